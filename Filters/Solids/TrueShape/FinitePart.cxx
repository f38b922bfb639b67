// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/FinitePart.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/ReducedModulus.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Penalty in units of E* per contact radius. With this penalty, the tool penetrates the body by a
/// few hundredths of its depth. The depth is corrected for the penetration.
constexpr double PenaltyFactor = 100.0;
/// Factor on the depth for the set of facets that may touch. It is needed at finite strain, because
/// the surface also moves tangentially.
constexpr double FacetDepthFactor = 1.2;
} // namespace

FinitePart::FinitePart(const ElasticBody& body, const AxisymmetricTool& tool,
  const ToolOutline& outline, const DirectPlace& at, double deepest, const UnitMotion* rest)
  : Body(body)
  , Tool(outline)
  , Frame(toolFrame(at))
  , Stiffness(body.stiffness())
{
  const ElasticMaterial& material = body.material(0);
  this->Penalty = PenaltyFactor * reducedModulus(material.youngsModulus, material.poissonRatio) /
    tool.contactRadius(deepest);
  this->Elements.reserve(body.mesh().elements.size());
  for (const VolumeElement& element : body.mesh().elements)
  {
    this->Elements.emplace_back(elementNodes(body.mesh(), element));
  }
  this->takeSurface(facetsUnder(body, tool, at, FacetDepthFactor * deepest));
  if (rest != nullptr && this->isTouched())
  {
    this->Rest = restAround(body, this->Surface, *rest, tool.contactRadius(deepest));
  }
  Vector none;
  this->linearizeBody(Vector::Zero(this->unknowns()), none);
  this->StiffnessAtRest = this->Stiffness.lower;
  this->BorderAtRest = this->Border;
  this->CornerAtRest = this->Corner;
}

void FinitePart::stiffen(double share)
{
  this->Stiffness.lower += share * this->StiffnessAtRest;
  this->Border += share * this->BorderAtRest;
  this->Corner += share * this->CornerAtRest;
}

void FinitePart::takeSurface(const std::vector<ToolFacet>& facets)
{
  for (const ToolFacet& facet : facets)
  {
    const double area = facet.area.norm() / FacetParts;
    visitParts(facet.corners,
      [&](const Eigen::Vector2d& where)
      {
        Piece piece{};
        piece.shape = faceShapes(static_cast<int>(facet.nodes.size()), where);
        std::copy(facet.nodes.begin(), facet.nodes.end(), piece.nodes.begin());
        piece.place =
          facet.places * Eigen::Map<const Eigen::VectorXd>(piece.shape.data(), facet.places.cols());
        piece.weight = area;
        this->Surface.push_back(piece);
      });
  }
}

FiniteTetrahedron::Vector FinitePart::gather(const VolumeElement& element, const Vector& u) const
{
  FiniteTetrahedron::Vector values;
  for (int i = 0; i < values.size(); ++i)
  {
    values[i] = this->displacement(element.nodes[static_cast<std::size_t>(i / 3)], i % 3, u);
  }
  return values;
}

double FinitePart::displacement(std::int32_t node, int axis, const Vector& u) const
{
  const int unknown = this->Body.unknown(node, axis);
  if (unknown >= 0)
  {
    return u[unknown];
  }
  return this->loads() > 0 ? this->Rest.motion.row(3 * node + axis).dot(u.tail(this->loads()))
                           : 0.0;
}

Eigen::MatrixXd FinitePart::restOf(const VolumeElement& element) const
{
  Eigen::MatrixXd made = Eigen::MatrixXd::Zero(30, this->loads());
  for (int i = 0; i < 30; ++i)
  {
    const std::int32_t node = element.nodes[static_cast<std::size_t>(i / 3)];
    if (this->Body.unknown(node, i % 3) < 0)
    {
      made.row(i) = this->Rest.motion.row(3 * node + i % 3);
    }
  }
  return made;
}

void FinitePart::addForce(std::int32_t node, const Eigen::Vector3d& force, Vector& gradient) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int unknown = this->Body.unknown(node, axis);
    if (unknown >= 0)
    {
      gradient[unknown] += force[axis];
    }
    else if (this->loads() > 0)
    {
      gradient.tail(this->loads()) +=
        force[axis] * this->Rest.motion.row(3 * node + axis).transpose();
    }
  }
}

void FinitePart::addBorder(const VolumeElement& element, const ElementMatrix& stiffness)
{
  const auto isHeld = [&](std::int32_t node)
  {
    return this->Body.unknown(node, 0) < 0 || this->Body.unknown(node, 1) < 0 ||
      this->Body.unknown(node, 2) < 0;
  };
  if (this->loads() == 0 || std::none_of(element.nodes.begin(), element.nodes.end(), isHeld))
  {
    return;
  }
  const Eigen::MatrixXd moved = this->restOf(element);
  const Eigen::MatrixXd forces = stiffness * moved;
  this->Corner += moved.transpose() * forces;
  for (int i = 0; i < 30; ++i)
  {
    const int unknown = this->Body.unknown(element.nodes[static_cast<std::size_t>(i / 3)], i % 3);
    if (unknown >= 0)
    {
      this->Border.row(unknown) += forces.row(i);
    }
  }
}

/// Returns the deformed position of a piece, in the tool's frame.
Eigen::Vector3d FinitePart::placeOf(const Piece& piece, const Vector& u) const
{
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (std::size_t n = 0; n < piece.nodes.size(); ++n)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      moved[axis] += piece.shape[n] * this->displacement(piece.nodes[n], axis, u);
    }
  }
  return piece.place + this->Frame.transpose() * moved;
}

double FinitePart::distance(const Piece& piece, const Vector& u, double depth) const
{
  const Eigen::Vector3d at = this->placeOf(piece, u);
  return this->Tool.distance({ at.head<2>().norm(), depth - at.z() }).value;
}

FinitePart::Gap FinitePart::gapAt(const Piece& piece, const Vector& u, double depth) const
{
  const Eigen::Vector3d at = this->placeOf(piece, u);
  const double r = at.head<2>().norm();
  const ToolOutline::Distance found = this->Tool.distance({ r, depth - at.z() });
  // Columns: radial, circumferential and axial direction of the tool.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (r > 0.0)
  {
    axes.col(0) << at.head<2>() / r, 0.0;
    axes.col(1) << -axes(1, 0), axes(0, 0), 0.0;
  }
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  hessian(0, 0) = found.hessian(0, 0);
  hessian(0, 2) = hessian(2, 0) = -found.hessian(0, 1);
  hessian(2, 2) = found.hessian(1, 1);
  hessian(1, 1) = r > 0.0 ? found.gradient[0] / r : found.hessian(0, 0);
  const Eigen::Matrix3d turned = this->Frame * axes;
  return { found.value, turned * Eigen::Vector3d(found.gradient[0], 0.0, -found.gradient[1]),
    turned * hessian * turned.transpose() };
}

double FinitePart::energy(const Vector& u, double depth) const
{
  double sum = 0.0;
  const auto& elements = this->Body.mesh().elements;
  for (std::size_t e = 0; e < elements.size() && std::isfinite(sum); ++e)
  {
    sum += this->Elements[e].energy(this->Body.material(0), this->gather(elements[e], u));
  }
  for (const Piece& piece : this->Surface)
  {
    const double gap = std::min(0.0, this->distance(piece, u, depth));
    sum += 0.5 * this->Penalty * piece.weight * gap * gap;
  }
  const auto load = u.tail(this->loads());
  return this->loads() > 0 ? sum + 0.5 * load.dot(this->Rest.energy * load) : sum;
}

void FinitePart::linearize(const Vector& u, double depth, ToolCurvature curvature, Vector& gradient)
{
  this->linearizeBody(u, gradient);
  this->visitTouched(u, depth,
    [&](const Piece& piece, const Gap& gap) { this->addContact(piece, gap, curvature, gradient); });
}

void FinitePart::linearizeBody(const Vector& u, Vector& gradient)
{
  gradient.setZero(this->unknowns());
  std::fill_n(this->Stiffness.lower.valuePtr(), this->Stiffness.lower.nonZeros(), 0.0);
  this->Border.setZero(this->free(), this->loads());
  this->Corner = this->Rest.energy;
  gradient.tail(this->loads()) = this->Rest.energy * u.tail(this->loads());
  FiniteTetrahedron::Vector forces;
  ElementMatrix stiffness;
  const auto& elements = this->Body.mesh().elements;
  for (std::size_t e = 0; e < elements.size(); ++e)
  {
    this->Elements[e].linearize(
      this->Body.material(0), this->gather(elements[e], u), forces, stiffness);
    addElement(elements[e], stiffness, this->Stiffness);
    this->addBorder(elements[e], stiffness);
    for (int i = 0; i < 10; ++i)
    {
      this->addForce(
        elements[e].nodes[static_cast<std::size_t>(i)], forces.segment<3>(3 * i), gradient);
    }
  }
}

template <class Visit>
void FinitePart::visitTouched(const Vector& u, double depth, const Visit& visit) const
{
  for (const Piece& piece : this->Surface)
  {
    const Gap gap = this->gapAt(piece, u, depth);
    if (gap.value < 0.0)
    {
      visit(piece, gap);
    }
  }
}

void FinitePart::addContact(
  const Piece& piece, const Gap& gap, ToolCurvature curvature, Vector& gradient)
{
  const double scale = this->Penalty * piece.weight;
  Eigen::Matrix3d bend = scale * gap.gradient * gap.gradient.transpose();
  if (curvature == ToolCurvature::Included)
  {
    bend += scale * gap.value * gap.hessian;
  }
  for (std::size_t n = 0; n < piece.nodes.size(); ++n)
  {
    this->addForce(piece.nodes[n], scale * gap.value * piece.shape[n] * gap.gradient, gradient);
    for (std::size_t m = 0; m < piece.nodes.size(); ++m)
    {
      for (int i = 0; i < 9; ++i)
      {
        const int row = this->Body.unknown(piece.nodes[n], i / 3);
        const int column = this->Body.unknown(piece.nodes[m], i % 3);
        if (column >= 0 && column <= row)
        {
          this->Stiffness.lower.coeffRef(row, column) +=
            piece.shape[n] * piece.shape[m] * bend(i / 3, i % 3);
        }
      }
    }
  }
}

double FinitePart::firstTouch() const
{
  const Vector still = Vector::Zero(this->unknowns());
  const auto isTouching = [&](double depth)
  {
    return std::any_of(this->Surface.begin(), this->Surface.end(),
      [&](const Piece& piece) { return this->distance(piece, still, depth) < 0.0; });
  };
  const double size = this->Surface.front().place.norm() + std::sqrt(this->Surface.front().weight);
  double high = 0.0;
  double low = 0.0;
  for (double step = 0.01 * size; isTouching(low); step *= 2.0)
  {
    high = low;
    low -= step;
  }
  for (int i = 0; i < 20 && low < high; ++i)
  {
    const double middle = 0.5 * (low + high);
    (isTouching(middle) ? high : low) = middle;
  }
  return low;
}

FinitePart::Pressed FinitePart::pressed(const Vector& u, double depth) const
{
  // An increase of the depth is equivalent to raising the body by the same distance.
  const Eigen::Vector3d deeper = -this->Frame.col(2);
  Pressed made;
  made.gradient = Vector::Zero(this->unknowns());
  double area = 0.0;
  this->visitTouched(u, depth,
    [&](const Piece& piece, const Gap& gap)
    {
      const double scale = this->Penalty * piece.weight;
      const double slope = gap.gradient.dot(deeper);
      const Eigen::Vector3d bent = gap.value * gap.hessian * deeper;
      area += piece.weight;
      made.force += scale * gap.value * slope;
      made.penetration += scale * gap.value * gap.value;
      for (std::size_t n = 0; n < piece.nodes.size(); ++n)
      {
        this->addForce(
          piece.nodes[n], scale * piece.shape[n] * (slope * gap.gradient + bent), made.gradient);
      }
    });
  made.radius = std::sqrt(area / Pi);
  made.penetration /= made.force > 0.0 ? made.force : 1.0;
  if (this->loads() > 0)
  {
    made.turned = (this->Rest.turns * u.tail(this->loads())).norm();
  }
  return made;
}
} // namespace palpate
