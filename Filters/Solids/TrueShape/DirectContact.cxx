// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/DirectContact.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/DenseNodes.h"
#include "Mechanics/SharedWork.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
constexpr std::size_t LoadsPerBlock = 96;
/// Number of iterations for the mean direction of the pressures. The first direction is the axis.
constexpr int MostDirectionUpdates = 2;
/// Smallest covered area of a corner, as a fraction of the mean over all corners. Corners with a
/// smaller area are left out.
constexpr double LeastCovered = 0.02;
} // namespace

DirectContact::DirectContact(const ElasticBody& body, const AxisymmetricTool& tool,
  const DirectPlace& at, double deepest, const UnitMotion* rest)
  : Tool(tool)
  , At(at)
  , Frame(toolFrame(at))
  , Reached(reachedRadius(tool))
{
  this->takeCorners(facetsUnder(body, tool, at, deepest));
  Eigen::MatrixXd compliance = this->compliance(body);
  if (rest != nullptr)
  {
    this->addRest(body, *rest, compliance);
  }
  Eigen::Matrix3Xd normals(3, this->corners());
  for (Eigen::Index i = 0; i < normals.cols(); ++i)
  {
    normals.col(i) = this->Corners[static_cast<std::size_t>(i)].normal;
  }
  this->Compliance[static_cast<std::size_t>(Pushed::EachAlongItsOwn)] =
    this->along(compliance, normals);
  this->pushAlongMean(compliance, deepest);
}

void DirectContact::pushAlongMean(const Eigen::MatrixXd& compliance, double deepest)
{
  Eigen::MatrixXd& along = this->Compliance[static_cast<std::size_t>(Pushed::TogetherAlongTheMean)];
  Eigen::Matrix3Xd pushes(3, this->corners());
  pushes.colwise() = Eigen::Vector3d::UnitZ();
  along = this->along(compliance, pushes);
  for (int turn = 0; turn < MostDirectionUpdates; ++turn)
  {
    Eigen::VectorXd forces;
    std::vector<int> active;
    if (!this->solve(deepest, along, forces, active) || !(forces.sum() > 0.0))
    {
      return;
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int i : active)
    {
      mean += forces[i] / forces.sum() * this->Corners[static_cast<std::size_t>(i)].normal;
    }
    pushes.colwise() = mean;
    along = this->along(compliance, pushes);
  }
}

void DirectContact::takeCorners(const std::vector<ToolFacet>& facets)
{
  struct Part
  {
    Corner corner;
    std::map<std::int32_t, double> nodes;
    double weight = 0.0;
  };
  std::map<std::int32_t, Part> parts;
  double sum = 0.0;
  for (const ToolFacet& facet : facets)
  {
    const double area = -facet.area[2] / FacetParts;
    const Eigen::Vector3d normal = facet.area / facet.area[2];
    const auto nodes = static_cast<int>(facet.nodes.size());
    visitParts(facet.corners,
      [&](const Eigen::Vector2d& at)
      {
        const std::array<double, 6> shapes = faceShapes(nodes, at);
        const std::array<double, 6> ofCorners = faceShapes(facet.corners, at);
        const Eigen::Vector3d place =
          facet.places * Eigen::Map<const Eigen::VectorXd>(shapes.data(), nodes);
        const double r = place.head<2>().norm();
        if (!(r < this->Reached))
        {
          return;
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(facet.corners); ++i)
        {
          Part& part = parts[facet.nodes[i]];
          const double weight = ofCorners[i] * area;
          part.corner.pieces.push_back({ place[2], r, weight });
          part.corner.normal += weight * normal;
          part.weight += weight;
          sum += weight;
          for (std::size_t n = 0; n < facet.nodes.size(); ++n)
          {
            part.nodes[facet.nodes[n]] += weight * shapes[n];
          }
        }
      });
  }
  for (auto& [node, part] : parts)
  {
    if (part.weight * static_cast<double>(parts.size()) < LeastCovered * sum)
    {
      continue;
    }
    part.corner.normal /= part.weight;
    part.corner.area = part.weight;
    for (Piece& piece : part.corner.pieces)
    {
      piece.weight /= part.weight;
    }
    for (const auto& [of, share] : part.nodes)
    {
      part.corner.nodes.emplace_back(of, share / part.weight);
    }
    this->Corners.push_back(std::move(part.corner));
  }
}

double DirectContact::touchesBefore() const
{
  double before = 0.0;
  for (const Corner& corner : this->Corners)
  {
    for (const Piece& piece : corner.pieces)
    {
      before = std::max(before, -(piece.depth + this->Tool.profile(piece.away)));
    }
  }
  return before;
}

/// Returns the compliance between all corners, for the three directions of the tool's frame at each
/// corner.
Eigen::MatrixXd DirectContact::compliance(const ElasticBody& body) const
{
  const std::size_t count = this->Corners.size();
  const auto size = static_cast<Eigen::Index>(3 * count);
  Eigen::MatrixXd made(size, size);
  const auto visit = [&](std::size_t i, const auto& add)
  {
    for (const auto& [node, share] : this->Corners[i / 3].nodes)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const int unknown = body.unknown(node, axis);
        if (unknown >= 0)
        {
          add(unknown, share * this->Frame(axis, static_cast<Eigen::Index>(i % 3)));
        }
      }
    }
  };
  const auto solve = [&](std::size_t block)
  {
    const std::size_t first = block * LoadsPerBlock;
    const std::size_t last = std::min(3 * count, first + LoadsPerBlock);
    Eigen::MatrixXd loads =
      Eigen::MatrixXd::Zero(body.unknowns(), static_cast<Eigen::Index>(last - first));
    for (std::size_t i = first; i < last; ++i)
    {
      const auto column = static_cast<Eigen::Index>(i - first);
      visit(i, [&](int unknown, double share) { loads(unknown, column) += share; });
    }
    const Eigen::MatrixXd moved = body.factor().solveAll(loads);
    for (std::size_t j = 0; j < 3 * count; ++j)
    {
      Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(moved.cols());
      visit(j, [&](int unknown, double share) { sum += share * moved.row(unknown); });
      made.block(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(first), 1, sum.size()) =
        sum;
    }
  };
  shareWork((3 * count + LoadsPerBlock - 1) / LoadsPerBlock, solve);
  return made;
}

/// Adds the motion of the surrounding body to the compliance. A force on a corner is equivalent to
/// a force at the place and a moment about the place. The motion of the part's cut under these
/// loads moves all corners.
void DirectContact::addRest(
  const ElasticBody& body, const UnitMotion& rest, Eigen::MatrixXd& compliance) const
{
  Eigen::MatrixXd loads(6, compliance.cols());
  Eigen::MatrixXd moved(compliance.rows(), 6);
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, 6> moves = Eigen::Matrix<double, 3, 6>::Zero();
    for (const auto& [node, share] : this->Corners[i].nodes)
    {
      at += share * (body.mesh().nodes.col(node) - rest.about);
      for (std::size_t k = 0; k < 6; ++k)
      {
        moves.col(static_cast<Eigen::Index>(k)) += share * rest.nodes[k].col(node);
      }
    }
    const auto first = static_cast<Eigen::Index>(3 * i);
    moved.middleRows<3>(first) = this->Frame.transpose() * moves;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      const Eigen::Vector3d force = this->Frame.col(axis);
      loads.col(first + axis) << force, at.cross(force);
    }
  }
  const Eigen::MatrixXd more = moved * loads;
  compliance += 0.5 * (more + more.transpose());
}

Eigen::MatrixXd DirectContact::along(
  const Eigen::MatrixXd& compliance, const Eigen::Matrix3Xd& pushes) const
{
  const Eigen::Index count = pushes.cols();
  Eigen::MatrixXd half(compliance.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    half.col(i) = compliance.middleCols<3>(3 * i) * pushes.col(i);
  }
  Eigen::MatrixXd made(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    made.row(i) = pushes.col(i).transpose() * half.middleRows<3>(3 * i);
  }
  return made;
}

bool DirectContact::solve(double deflection, const Eigen::MatrixXd& compliance,
  Eigen::VectorXd& forces, std::vector<int>& active) const
{
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(this->corners());
  for (Eigen::Index i = 0; i < wanted.size(); ++i)
  {
    for (const Piece& piece : this->Corners[static_cast<std::size_t>(i)].pieces)
    {
      const double r = std::min(piece.away, this->Reached);
      wanted[i] += piece.weight * (deflection - this->Tool.profile(r) - piece.depth);
    }
  }
  DenseNodes corners(compliance);
  UnilateralContact contact;
  return contact.solve(corners, wanted, active, forces) && forces.allFinite();
}

DirectForce DirectContact::at(double deflection, Pushed pushed) const
{
  const Eigen::MatrixXd& compliance = this->Compliance[static_cast<std::size_t>(pushed)];
  Eigen::VectorXd forces;
  std::vector<int> active;
  if (!this->solve(deflection, compliance, forces, active))
  {
    return { NotANumber, NotANumber, NotANumber };
  }
  DirectForce found{ forces.sum(), 0.0, 0.0 };
  if (!active.empty())
  {
    const Eigen::MatrixXd touching = compliance(active, active);
    found.stiffness = touching.ldlt().solve(Eigen::VectorXd::Ones(touching.rows())).sum();
    double area = 0.0;
    for (const int i : active)
    {
      area += this->Corners[static_cast<std::size_t>(i)].area;
    }
    found.radius = std::sqrt(area / Pi);
  }
  return found;
}
} // namespace palpate
