// SPDX-License-Identifier: BSD-3-Clause
#include "Strain/FiniteBody.h"

#include "Strain/QuadraticLine.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Dual = SecondOrder<5>;

/// Values at a Gauss point of an element: the matrix B of the displacement gradient H = B u, the
/// linear functions of the pressure, and the weight.
struct ElementPoint
{
  Eigen::Matrix<double, 5, 18> b = Eigen::Matrix<double, 5, 18>::Zero();
  Eigen::Vector3d pressure; ///< values of the linear functions for volume change and pressure
  double weight;            ///< mm³
};

template <class Element>
ElementPoint pointOf(const Element& element, int i, int k)
{
  const double x = QuadraticLine::GaussNode[static_cast<std::size_t>(i)];
  const double y = QuadraticLine::GaussNode[static_cast<std::size_t>(k)];
  const auto nx = QuadraticLine::shapes(x);
  const auto ny = QuadraticLine::shapes(y);
  const auto sx = QuadraticLine::slopes(x);
  const auto sy = QuadraticLine::slopes(y);
  Eigen::Matrix<double, 9, 1> shape;
  Eigen::Matrix<double, 9, 2> slope; // derivatives with respect to x and y
  for (std::size_t j = 0; j < 3; ++j)
  {
    for (std::size_t m = 0; m < 3; ++m)
    {
      const auto node = static_cast<Eigen::Index>(3 * j + m);
      shape[node] = nx[m] * ny[j];
      slope(node, 0) = sx[m] * ny[j];
      slope(node, 1) = nx[m] * sy[j];
    }
  }
  // Derivatives of (r, z) with respect to (x, y).
  const Eigen::Matrix2d jacobian = element.places * slope;
  const Eigen::Matrix<double, 9, 2> byPlace = slope * jacobian.inverse();
  const double r = element.places.row(0).dot(shape);
  ElementPoint point;
  point.pressure = { 1.0, x, y };
  point.weight = QuadraticLine::GaussWeight[static_cast<std::size_t>(i)] *
    QuadraticLine::GaussWeight[static_cast<std::size_t>(k)] * jacobian.determinant() * 2.0 * Pi * r;
  for (Eigen::Index node = 0; node < 9; ++node)
  {
    point.b(0, 2 * node) = byPlace(node, 0);
    point.b(1, 2 * node) = byPlace(node, 1);
    point.b(2, 2 * node + 1) = byPlace(node, 0);
    point.b(3, 2 * node + 1) = byPlace(node, 1);
    point.b(4, 2 * node) = shape[node] / r;
  }
  return point;
}

StrainEnergy::Gradient<double> gradientOf(const Eigen::Matrix<double, 5, 1>& h)
{
  return { h[0], h[1], h[2], h[3], h[4] };
}
} // namespace

int FiniteBody::unknownOf(const Element& element, int i) const
{
  const auto node = static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i) / 2]);
  return this->UnknownOf[2 * node + static_cast<std::size_t>(i) % 2];
}

FiniteBody::ElementVector FiniteBody::gather(const Element& element, const Vector& u) const
{
  ElementVector values;
  for (int i = 0; i < ElementUnknowns; ++i)
  {
    const int unknown = this->unknownOf(element, i);
    values[i] = unknown < 0 ? 0.0 : u[unknown];
  }
  return values;
}

double FiniteBody::energyOf(
  const Element& element, const ElementVector& u, double* leastVolume) const
{
  const Material& material = this->Materials[element.layer];
  double stored = 0.0;
  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
  for (int i = 0; i < QuadraticLine::GaussCount; ++i)
  {
    for (int k = 0; k < QuadraticLine::GaussCount; ++k)
    {
      const ElementPoint point = pointOf(element, i, k);
      const auto h = gradientOf(point.b * u);
      const double j = material.energy.volumeChange(h);
      if (!material.energy.isLinear() && !(j > -1.0))
      {
        return HUGE_VAL;
      }
      if (leastVolume && !material.energy.isLinear())
      {
        *leastVolume = std::min(*leastVolume, 1.0 + j);
      }
      stored += point.weight * material.energy.isochoric(h, j);
      change += point.weight * j * point.pressure;
      mass += point.weight * point.pressure * point.pressure.transpose();
    }
  }
  return stored + 0.5 * material.bulkModulus * change.dot(mass.ldlt().solve(change));
}

void FiniteBody::linearize(const Element& element, const ElementVector& u,
  const Eigen::Vector3d* followed, ElementVector& gradient, ElementMatrix& tangent,
  PressureStep& step) const
{
  const Material& material = this->Materials[element.layer];
  std::array<ElementPoint, 9> points;
  std::array<Dual, 9> volume;
  std::array<Dual, 9> isochoric;
  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, ElementUnknowns> changeOf =
    Eigen::Matrix<double, 3, ElementUnknowns>::Zero();
  for (std::size_t g = 0; g < 9; ++g)
  {
    ElementPoint& point = points[g];
    point = pointOf(element, static_cast<int>(g / 3), static_cast<int>(g % 3));
    const Eigen::Matrix<double, 5, 1> h = point.b * u;
    StrainEnergy::Gradient<Dual> strain;
    for (int i = 0; i < 5; ++i)
    {
      strain[static_cast<std::size_t>(i)] = Dual::variable(h[i], i);
    }
    volume[g] = material.energy.volumeChange(strain);
    isochoric[g] = material.energy.isochoric(strain, volume[g]);
    change += point.weight * volume[g].value * point.pressure;
    mass += point.weight * point.pressure * point.pressure.transpose();
    changeOf += point.weight * point.pressure * (volume[g].gradient.transpose() * point.b);
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver = mass.ldlt();
  const Eigen::Vector3d pressure = material.bulkModulus * solver.solve(change);
  gradient = changeOf.transpose() * pressure;
  step.now = pressure;
  step.byUnknown = material.bulkModulus * solver.solve(changeOf);
  tangent = changeOf.transpose() * step.byUnknown;
  for (std::size_t g = 0; g < 9; ++g)
  {
    const ElementPoint& point = points[g];
    const double p = (followed ? *followed : pressure).dot(point.pressure);
    gradient += point.weight * point.b.transpose() * isochoric[g].gradient;
    const Eigen::Matrix<double, 5, 5> stiff =
      point.weight * (isochoric[g].hessian + p * volume[g].hessian);
    const Eigen::Matrix<double, 5, ElementUnknowns> half = stiff * point.b;
    tangent.noalias() += point.b.transpose() * half;
  }
}

Eigen::Vector2d FiniteBody::displacementAt(const SurfacePoint& point, const Vector& u) const
{
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  for (std::size_t m = 0; m < 3; ++m)
  {
    for (std::size_t c = 0; c < 2; ++c)
    {
      const int unknown = this->UnknownOf[2 * static_cast<std::size_t>(point.nodes[m]) + c];
      value[static_cast<Eigen::Index>(c)] += unknown < 0 ? 0.0 : point.shape[m] * u[unknown];
    }
  }
  return value;
}

FiniteBody::Gap FiniteBody::gapAt(
  const SurfacePoint& point, const Eigen::Vector2d& displacement, double depth) const
{
  if (this->IsLinear)
  {
    return { this->Tool.height(point.place.x()) - depth - point.place.y() - displacement.y(),
      { 0.0, -1.0 }, Eigen::Matrix2d::Zero(), -1.0, Eigen::Vector2d::Zero() };
  }
  const ToolOutline::Distance distance =
    this->Tool.distance(point.place + displacement + Eigen::Vector2d(0.0, depth));
  return { distance.value, distance.gradient, distance.hessian, distance.gradient.y(),
    distance.hessian.col(1) };
}

double FiniteBody::energy(const Vector& u, double depth) const
{
  double sum = 0.0;
  for (const Element& element : this->Elements)
  {
    sum += this->energyOf(element, this->gather(element, u), nullptr);
    if (!std::isfinite(sum))
    {
      return HUGE_VAL;
    }
  }
  for (const SurfacePoint& point : this->Surface)
  {
    const double gap = this->gapAt(point, this->displacementAt(point, u), depth).value;
    sum += gap < 0.0 ? 0.5 * this->Penalty * point.weight * gap * gap : 0.0;
  }
  return sum;
}

void FiniteBody::linearize(const Vector& u, double depth, Vector& gradient)
{
  gradient.setZero(this->Unknowns);
  double* values = this->Tangent.valuePtr();
  std::fill_n(values, this->Tangent.nonZeros(), 0.0);
  ElementVector force;
  ElementMatrix tangent;
  std::size_t entry = 0;
  this->Steps.resize(this->Elements.size());
  for (std::size_t e = 0; e < this->Elements.size(); ++e)
  {
    const Element& element = this->Elements[e];
    this->linearize(element, this->gather(element, u),
      this->Pressures.empty() ? nullptr : &this->Pressures[e], force, tangent, this->Steps[e]);
    for (int i = 0; i < ElementUnknowns; ++i)
    {
      const int row = this->unknownOf(element, i);
      if (row >= 0)
      {
        gradient[row] += force[i];
      }
      for (int k = 0; k <= i; ++k, ++entry)
      {
        if (this->ValueOf[entry] >= 0)
        {
          values[this->ValueOf[entry]] += tangent(i, k);
        }
      }
    }
  }
  this->Gaps.resize(this->Surface.size());
  for (std::size_t p = 0; p < this->Surface.size(); ++p)
  {
    this->Gaps[p] = this->gapAt(this->Surface[p], this->displacementAt(this->Surface[p], u), depth);
    if (this->Gaps[p].value < 0.0)
    {
      this->addContact(p, gradient);
    }
  }
}

/// Adds the gradient of the penalty of a surface point that is inside the tool.
void FiniteBody::addContact(std::size_t p, Vector& gradient)
{
  const SurfacePoint& point = this->Surface[p];
  const Gap& gap = this->Gaps[p];
  const double scale = this->Penalty * point.weight;
  const Eigen::Vector2d slope = scale * gap.value * gap.gradient;
  const double pressing = this->Pressures.empty() ? gap.value : this->ContactPressures[p];
  const Eigen::Matrix2d bend =
    scale * (gap.gradient * gap.gradient.transpose() + pressing * gap.hessian);
  const auto unknownAt = [&](int i)
  {
    const auto node = static_cast<std::size_t>(point.nodes[static_cast<std::size_t>(i) / 2]);
    return this->UnknownOf[2 * node + static_cast<std::size_t>(i) % 2];
  };
  for (int i = 0; i < 6; ++i)
  {
    const int row = unknownAt(i);
    if (row < 0)
    {
      continue;
    }
    const double shape = point.shape[static_cast<std::size_t>(i) / 2];
    gradient[row] += shape * slope[i % 2];
    for (int k = 0; k < 6; ++k)
    {
      const int column = unknownAt(k);
      if (column >= 0 && column <= row)
      {
        this->Tangent.coeffRef(row, column) +=
          shape * point.shape[static_cast<std::size_t>(k) / 2] * bend(i % 2, k % 2);
      }
    }
  }
}

void FiniteBody::follow(const Vector& step)
{
  this->Pressures.resize(this->Elements.size());
  for (std::size_t e = 0; e < this->Elements.size(); ++e)
  {
    this->Pressures[e] =
      this->Steps[e].now + this->Steps[e].byUnknown * this->gather(this->Elements[e], step);
  }
  this->ContactPressures.resize(this->Surface.size());
  for (std::size_t p = 0; p < this->Surface.size(); ++p)
  {
    const Gap& gap = this->Gaps[p];
    this->ContactPressures[p] =
      std::min(0.0, gap.value + gap.gradient.dot(this->displacementAt(this->Surface[p], step)));
  }
}

FinitePoint FiniteBody::evaluate(const Vector& u, double depth) const
{
  FinitePoint found;
  found.depth = depth;
  for (const Element& element : this->Elements)
  {
    found.energy += this->energyOf(element, this->gather(element, u), &found.leastVolume);
  }
  double lastRadius = 0.0;
  double lastGap = 0.0;
  for (const SurfacePoint& point : this->Surface)
  {
    const Eigen::Vector2d displacement = this->displacementAt(point, u);
    const Gap gap = this->gapAt(point, displacement, depth);
    const double radius = point.place.x() + (this->IsLinear ? 0.0 : displacement.x());
    if (gap.value < 0.0)
    {
      found.force += this->Penalty * point.weight * gap.value * gap.byDepth;
      // Adds the energy of the penalty twice: once for itself, and once for the additional energy
      // that the body would have without the penalty.
      found.energy += this->Penalty * point.weight * gap.value * gap.value;
      found.contactRadius = radius;
    }
    else if (lastGap < 0.0 && std::isfinite(gap.value))
    {
      found.contactRadius = lastRadius + (radius - lastRadius) * lastGap / (lastGap - gap.value);
    }
    lastRadius = radius;
    lastGap = gap.value;
  }
  return found;
}

FiniteBody::Course FiniteBody::course(const Vector& u, double depth, const Solver& solver) const
{
  Vector byDepth = Vector::Zero(this->Unknowns);
  Vector byUnknown = Vector::Zero(this->Unknowns);
  double slope = 0.0;
  for (const SurfacePoint& point : this->Surface)
  {
    const Gap gap = this->gapAt(point, this->displacementAt(point, u), depth);
    if (!(gap.value < 0.0))
    {
      continue;
    }
    const double scale = this->Penalty * point.weight;
    slope += scale * gap.value * gap.byDepth;
    const Eigen::Vector2d mixed =
      scale * (gap.byDepth * gap.gradient + gap.value * gap.gradientByDepth);
    const Eigen::Vector2d first = scale * gap.value * gap.gradient;
    for (std::size_t m = 0; m < 3; ++m)
    {
      for (std::size_t c = 0; c < 2; ++c)
      {
        const int row = this->UnknownOf[2 * static_cast<std::size_t>(point.nodes[m]) + c];
        if (row >= 0)
        {
          byDepth[row] += point.shape[m] * mixed[static_cast<Eigen::Index>(c)];
          byUnknown[row] += point.shape[m] * first[static_cast<Eigen::Index>(c)];
        }
      }
    }
  }
  Course found{ -solver.solve(byDepth), slope };
  found.penaltySlope += byUnknown.dot(found.motion);
  return found;
}
} // namespace palpate
