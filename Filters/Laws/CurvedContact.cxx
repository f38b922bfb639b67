// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/CurvedContact.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Number of nodes of the sag's law below full contact of a flat end.
constexpr int NodesBeforeFlat = 16;

/// The sums κ_t+κ₁ and κ_t+κ₂ of the curvatures of tool and body, in ascending order.
struct Sums
{
  double smaller;
  double larger;
  bool fits;
};

Sums sumsOf(double toolCurvature, const SpotCurvature& curvature)
{
  const double one = toolCurvature + curvature.first;
  const double other = toolCurvature + curvature.second;
  const double smaller = std::min(one, other);
  return { smaller, std::max(one, other), smaller > LeastSum * toolCurvature };
}

double ellipseOf(const Sums& sums)
{
  const double ratio = std::log(sums.larger / sums.smaller);
  return ratio * ratio / 48.0;
}

/// Depth and force of the sag's contact at a contact radius, for the curvature of the SagLaw.
struct SagPoint
{
  double depth;
  double force;
};

SagPoint sagAt(const SagLaw& sag, double radius)
{
  const ContactNodes& nodes = sag.nodes;
  if (nodes.size() == 0)
  {
    return { sag.curvature * radius * radius,
      4.0 / 3.0 * sag.curvature * radius * radius * radius };
  }
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (nodes.size() < 4 || radius > nodes.radii.back())
  {
    return { unknown, unknown };
  }
  // δ/a² and F/a³ change little from node to node, so that cubic interpolation between four nodes
  // suffices.
  const auto above = std::lower_bound(nodes.radii.begin(), nodes.radii.end(), radius);
  const auto place = static_cast<std::size_t>(above - nodes.radii.begin());
  const std::size_t begin = std::min(place < 2 ? 0 : place - 2, nodes.size() - 4);
  SagPoint sum{ 0.0, 0.0 };
  for (std::size_t i = begin; i < begin + 4; ++i)
  {
    double weight = 1.0;
    for (std::size_t j = begin; j < begin + 4; ++j)
    {
      weight *= j == i ? 1.0 : (radius - nodes.radii[j]) / (nodes.radii[i] - nodes.radii[j]);
    }
    const double a = nodes.radii[i];
    sum.depth += weight * nodes.depths[i] / (a * a);
    sum.force += weight * nodes.forces[i] / (a * a * a);
  }
  return { sum.depth * radius * radius, sum.force * radius * radius * radius };
}
} // namespace

void ContactNodes::reserve(std::size_t nodes)
{
  for (std::vector<double>* column :
    { &this->depths, &this->forces, &this->stiffnesses, &this->radii, &this->toolDepths })
  {
    column->reserve(nodes);
  }
}

void ContactNodes::add(
  double depth, double force, double stiffness, double radius, double toolDepth)
{
  this->depths.push_back(depth);
  this->forces.push_back(force);
  this->stiffnesses.push_back(stiffness);
  this->radii.push_back(radius);
  this->toolDepths.push_back(toolDepth);
}

LocalState NodeLaw::at(double depth) const
{
  const ContactNodes& nodes = this->Nodes;
  if (depth <= 0.0)
  {
    return {};
  }
  if (!(depth <= nodes.depths.back()))
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return { depth, unknown, unknown, unknown };
  }
  const auto above = std::lower_bound(nodes.depths.begin(), nodes.depths.end(), depth);
  const auto next = static_cast<std::size_t>(above - nodes.depths.begin());
  if (next == 0)
  {
    const double power = nodes.stiffnesses[0] * nodes.depths[0] / nodes.forces[0];
    const double part = depth / nodes.depths[0];
    const double force = nodes.forces[0] * std::pow(part, power);
    return { depth, force, power * force / depth, nodes.radii[0] * std::sqrt(part),
      nodes.toolDepths[0] * part, nodes.toolDepths[0] / nodes.depths[0], nodes.coversTouch };
  }
  const double from = std::sqrt(nodes.depths[next - 1]);
  const double width = std::sqrt(nodes.depths[next]) - from;
  const double root = std::sqrt(depth);
  const double x = (root - from) / width;
  const double force0 = nodes.forces[next - 1];
  const double force1 = nodes.forces[next];
  const double slope0 = 2.0 * from * nodes.stiffnesses[next - 1] * width;
  const double slope1 = 2.0 * (from + width) * nodes.stiffnesses[next] * width;
  const double rise = force1 - force0;
  const double square = 3.0 * rise - 2.0 * slope0 - slope1;
  const double cube = slope0 + slope1 - 2.0 * rise;
  const double force = force0 + x * (slope0 + x * (square + x * cube));
  const double slope = slope0 + x * (2.0 * square + 3.0 * x * cube);
  return { depth, force, slope / (2.0 * root * width),
    nodes.radii[next - 1] + x * (nodes.radii[next] - nodes.radii[next - 1]),
    nodes.toolDepths[next - 1] + x * (nodes.toolDepths[next] - nodes.toolDepths[next - 1]) };
}

IndentationPoint NodeLaw::evaluate(double deflection, double reducedModulus) const
{
  const LocalState state = this->at(deflection);
  return { reducedModulus * state.force, reducedModulus * state.stiffness, state.radius };
}

double wholeFrom(double b, const SpotCurvature& curvature)
{
  const double one = curvature.first;
  const double other = curvature.second;
  const bool isConvex = std::min(one, other) > 0.0;
  return isConvex ? 0.0 : b * b * std::max(std::abs(one), std::abs(other));
}

double ellipseFactor(double toolCurvature, const SpotCurvature& curvature)
{
  const Sums sums = sumsOf(toolCurvature, curvature);
  return sums.fits ? ellipseOf(sums) : Infinity;
}

ContactNodes onCurvedBody(
  const ContactNodes& flat, const SagLaw& sag, const SpotCurvature& curvature)
{
  ContactNodes curved;
  curved.reserve(flat.size() + NodesBeforeFlat);
  // A flat end has its full radius at the first node, where the depth is almost 0.
  const bool isFlatEnd = flat.size() > 1 && flat.radii[0] > 0.99 * flat.radii[1];
  const double whole = isFlatEnd ? wholeFrom(flat.radii[0], curvature) : 0.0;
  // On a body that is not convex, the rim of the flat end touches first.
  curved.coversTouch = whole == 0.0;
  if (isFlatEnd && whole == 0.0)
  {
    const Sums sums = sumsOf(0.0, curvature);
    const double kappa = std::sqrt(sums.smaller * sums.larger);
    const double factor = 1.0 + ellipseOf(sums);
    for (int i = 1; sums.smaller > 0.0 && i <= NodesBeforeFlat; ++i)
    {
      const double a = flat.radii[0] * i / NodesBeforeFlat;
      const SagPoint point = sagAt(sag, a);
      // dF/dδ of a flat end is proportional to a only on a half-space. On a layer the difference
      // quotient of the sag's law is used.
      const SagPoint less = sagAt(sag, 0.999 * a);
      const double stiffness = (point.force - less.force) / (point.depth - less.depth);
      curved.add(kappa / sag.curvature * point.depth, factor * kappa / sag.curvature * point.force,
        factor * stiffness, a, 0.0);
    }
  }
  for (std::size_t i = 0; i < flat.size(); ++i)
  {
    const double toolCurvature = flat.toolDepths[i] / (flat.radii[i] * flat.radii[i]);
    const Sums sums = sumsOf(toolCurvature, curvature);
    if (!isFlatEnd && !sums.fits)
    {
      break;
    }
    const double kappa =
      isFlatEnd ? curvature.mean() : std::sqrt(sums.smaller * sums.larger) - toolCurvature;
    const double factor = isFlatEnd ? 1.0 : 1.0 + ellipseOf(sums);
    const SagPoint point = sagAt(sag, flat.radii[i]);
    const double depth = flat.depths[i] + kappa / sag.curvature * point.depth;
    const double force = factor * (flat.forces[i] + kappa / sag.curvature * point.force);
    const bool isLater =
      curved.size() == 0 || (depth > curved.depths.back() && force > curved.forces.back());
    if (isFlatEnd && (!(depth >= whole && depth > 0.0 && force > 0.0) || !isLater))
    {
      continue; // the flat end is not yet in full contact
    }
    if (!(depth > 0.0) || !isLater)
    {
      break;
    }
    curved.add(depth, force, factor * flat.stiffnesses[i], flat.radii[i], flat.toolDepths[i]);
  }
  return curved;
}
} // namespace palpate
