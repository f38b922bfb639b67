// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/ElementError.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Factor on the second-order estimate. With this factor, 2 of 100 errors exceed the estimate.
constexpr double MissedFactor = 1.5;
/// Value of MissedFactor for linear tetrahedra, which lock.
constexpr double LinearMissedFactor = 7.5;
/// Factor on the contribution of held faces, where elements have the exact displacement.
constexpr double HeldFactor = 0.5;
/// The spacing of quadratic tetrahedra is divided by this factor, because they are more accurate.
constexpr double QuadraticGain = 1.25;

double gainOf(ElementKind kind)
{
  return kind == ElementKind::QuadraticTetrahedron ? QuadraticGain : 1.0;
}

/// A face belongs to the smooth surface around the source if two conditions hold: its normal is
/// within 30° of the normal at the source, and it is nearly level with the source.
constexpr double SmoothTurn = 0.866;
constexpr double SmoothSlope = 0.3;
/// On the smooth surface, the missed part is multiplied by this factor times the angle by which the
/// normal varies over one element, because the curvature of a smooth surface has a smooth effect on
/// H. The factor was measured on balls and bumps.
constexpr double SmoothFactor = 2.0;

/// Returns (h/r)², at most 1.
double missedPart(double spacing, double distance)
{
  const double ratio = spacing / std::max(distance, 1e-300);
  return std::min(1.0, ratio * ratio);
}
/// Returns the factor on the missed part at a free face in the frame of the source; 1 means no
/// reduction.
double smoothPart(const Eigen::Vector3d& area, const Eigen::Vector3d& at, double spacing)
{
  const double away = at.head<2>().norm();
  // Cosine of the angle between the normals; z points inwards.
  const double level = -area[2] / area.norm();
  if (!(level > SmoothTurn) || std::abs(at[2]) > SmoothSlope * std::max(away, spacing))
  {
    return 1.0;
  }
  return std::min(
    1.0, SmoothFactor * std::acos(std::min(1.0, level)) * spacing / std::max(away, spacing));
}
} // namespace

ElementError::ElementError(const ElasticBody& body)
{
  const VolumeMesh& mesh = body.mesh();
  const bool locks = std::any_of(mesh.elements.begin(), mesh.elements.end(),
    [](const VolumeElement& element) { return element.kind == ElementKind::Tetrahedron; });
  this->Part = locks ? LinearMissedFactor : MissedFactor;
  for (const BoundaryFace& boundary : body.topology().boundary())
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(boundary.element)];
    const ElementFace& face = elementFace(element.kind, boundary.face);
    Side side{ Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.0, true };
    const auto corner = [&](int i)
    { return element.nodes[static_cast<std::size_t>(face.node[static_cast<std::size_t>(i)])]; };
    for (int i = 0; i < face.corners; ++i)
    {
      side.middle += mesh.nodes.col(corner(i)) / face.corners;
      side.isHeld = side.isHeld && body.isHeld(corner(i));
    }
    for (int i = 0; i < face.corners; ++i)
    {
      const Eigen::Vector3d from = mesh.nodes.col(corner(i));
      const Eigen::Vector3d to = mesh.nodes.col(corner((i + 1) % face.corners));
      side.area += 0.5 * (from - side.middle).cross(to - side.middle);
    }
    const double square = side.area.norm() * (face.corners == 3 ? 2.0 : 1.0);
    side.spacing = std::sqrt(square) / gainOf(element.kind);
    this->Sides.push_back(side);
  }
  const bool isUniform = body.isUniform();
  for (std::int32_t e = 0; e < mesh.elementTotal() && !isUniform; ++e)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(e)];
    const double volume = leastVolume(element.kind, elementNodes(mesh, element));
    const bool isHexahedron = element.kind == ElementKind::Hexahedron;
    this->Cells.push_back({ elementMiddle(mesh, element), volume,
      std::cbrt(isHexahedron ? volume : 6.0 * volume) / gainOf(element.kind), body.material(e) });
  }
}

ExpectedError ElementError::at(const SingularSource& source) const
{
  const BoussinesqField field(source.material);
  ExpectedError sum{ 0.0, 0.0 };
  const auto add = [&sum](double amount, double missed)
  {
    sum.direct += amount;
    sum.error += amount * missed;
  };
  const auto place = [&source](const Eigen::Vector3d& middle)
  {
    Eigen::Vector3d at = source.inFrame(middle);
    if (SingularSource::isUnder(at))
    {
      return at;
    }
    // For a part of the body that overhangs the source, the field at the edge of the cone, at the
    // same distance, is used.
    constexpr double level =
      1.0 - SingularSource::LargestOverhang * SingularSource::LargestOverhang;
    const double aside = at.head<2>().norm();
    const Eigen::Vector2d direction =
      aside > 0.0 ? Eigen::Vector2d(at.head<2>() / aside) : Eigen::Vector2d(1.0, 0.0);
    Eigen::Vector3d moved;
    moved << std::sqrt(level) * direction, -SingularSource::LargestOverhang;
    return Eigen::Vector3d(at.norm() * moved);
  };
  for (const Side& side : this->Sides)
  {
    const Eigen::Vector3d at = place(side.middle);
    const double distance = std::max(at.norm(), 0.5 * side.spacing);
    const Eigen::Matrix3d stress = field.stress(at);
    const double force = side.isHeld ? stress.norm() * side.area.norm()
                                     : (stress * (source.frame.transpose() * side.area)).norm();
    const double missed = missedPart(side.spacing, distance);
    add(force * field.displacement(at).norm(),
      side.isHeld ? HeldFactor * missed
                  : missed * smoothPart(source.frame.transpose() * side.area, at, side.spacing));
  }
  for (const Cell& cell : this->Cells)
  {
    if (isAlike(cell.material, source.material))
    {
      continue;
    }
    const double here = cell.material.youngsModulus;
    const double there = source.material.youngsModulus;
    const Eigen::Vector3d at = place(cell.middle);
    const double distance = std::max(at.norm(), 0.5 * cell.spacing);
    const double contrast = std::max(std::abs(here - there) / std::max(here, there),
      std::abs(cell.material.poissonRatio - source.material.poissonRatio));
    add(contrast * cell.volume * field.stress(at).cwiseProduct(field.strain(at)).sum(),
      missedPart(cell.spacing, distance));
  }
  sum.error *= this->Part;
  return sum;
}
} // namespace palpate
