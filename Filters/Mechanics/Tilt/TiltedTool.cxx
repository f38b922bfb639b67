// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltedTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/GaussLegendre.h"
#include "Mechanics/Numerics/IncreasingRoot.h"
#include "Mechanics/Tilt/CubicSpline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
const GaussLegendre& cellRule()
{
  // For the exponential of a cubic over a cell the error is 1e-12.
  static const GaussLegendre rule(8);
  return rule;
}
} // namespace

TiltedTool::TiltedTool(
  std::string name, std::vector<Sample> samples, bool hasWall, std::vector<double> kinks)
  : Name(std::move(name))
  , Samples(std::move(samples))
  , HasWall(hasWall)
  , Kinks(std::move(kinks))
{
  // Limits the slopes so that the cubics do not overshoot (Fritsch and Carlson 1980).
  for (std::size_t i = 0; i + 1 < this->Samples.size(); ++i)
  {
    Sample& lower = this->Samples[i];
    Sample& upper = this->Samples[i + 1];
    const double secant = std::log(upper.radius / lower.radius) / this->cellWidth(i);
    lower.exponent = std::clamp(lower.exponent, 0.0, 3.0 * secant);
    upper.exponent = std::clamp(upper.exponent, 0.0, 3.0 * secant);
  }
  const Sample& first = this->Samples.front();
  this->Forces.push_back(2.0 * first.radius * first.depth / (1.0 + first.exponent));
  for (std::size_t i = 0; i + 1 < this->Samples.size(); ++i)
  {
    this->Forces.push_back(
      this->Forces.back() + 2.0 * this->workInside(i, this->Samples[i + 1].depth));
  }
}

double TiltedTool::cellWidth(std::size_t cell) const
{
  return std::log(this->Samples[cell + 1].depth / this->Samples[cell].depth);
}

TiltedTool::Logarithm TiltedTool::radiusIn(std::size_t cell, double t) const
{
  const Sample& lower = this->Samples[cell];
  const Sample& upper = this->Samples[cell + 1];
  const double width = this->cellWidth(cell);
  const CubicCell logarithm(
    std::log(upper.radius / lower.radius), lower.exponent * width, upper.exponent * width);
  return { std::log(lower.radius) + logarithm.value(t), logarithm.slope(t) };
}

/// Returns ∫ a dD from the start of a cell to `deflection`.
double TiltedTool::workInside(std::size_t cell, double deflection) const
{
  const double begin = this->Samples[cell].depth;
  const double width = this->cellWidth(cell);
  const double end = std::log(deflection / begin) / width;
  return cellRule().integrate(0.0, end,
    [&](double t)
    { return std::exp(this->radiusIn(cell, t).value) * begin * std::exp(width * t) * width; });
}

double TiltedTool::radiusAt(double deflection) const
{
  const Sample& first = this->Samples.front();
  const Sample& last = this->Samples.back();
  if (deflection <= first.depth)
  {
    return first.radius * std::pow(deflection / first.depth, first.exponent);
  }
  if (deflection >= last.depth)
  {
    return this->HasWall ? last.radius
                         : last.radius * std::pow(deflection / last.depth, last.exponent);
  }
  const auto upper = std::upper_bound(this->Samples.begin(), this->Samples.end(), deflection,
    [](double depth, const Sample& sample) { return depth < sample.depth; });
  const auto cell = static_cast<std::size_t>(upper - this->Samples.begin()) - 1;
  return std::exp(
    this->radiusIn(cell, std::log(deflection / this->Samples[cell].depth) / this->cellWidth(cell))
      .value);
}

double TiltedTool::forcePerModulus(double, double deflection) const
{
  const Sample& first = this->Samples.front();
  const Sample& last = this->Samples.back();
  if (deflection <= first.depth)
  {
    return this->Forces.front() * std::pow(deflection / first.depth, 1.0 + first.exponent);
  }
  if (deflection >= last.depth)
  {
    const double exponent = this->HasWall ? 0.0 : last.exponent;
    const double beyond = std::pow(deflection / last.depth, 1.0 + exponent) - 1.0;
    return this->Forces.back() + 2.0 * last.radius * last.depth * beyond / (1.0 + exponent);
  }
  const auto upper = std::upper_bound(this->Samples.begin(), this->Samples.end(), deflection,
    [](double depth, const Sample& sample) { return depth < sample.depth; });
  const auto cell = static_cast<std::size_t>(upper - this->Samples.begin()) - 1;
  return this->Forces[cell] + 2.0 * this->workInside(cell, deflection);
}

double TiltedTool::largestContactRadius() const
{
  return this->HasWall ? this->Samples.back().radius : Infinity;
}

double TiltedTool::reducedProfile(double x) const
{
  if (!(x > 0.0))
  {
    return std::isnan(x) ? x : 0.0;
  }
  const Sample& first = this->Samples.front();
  const Sample& last = this->Samples.back();
  if (x <= first.radius)
  {
    return first.exponent > 0.0 ? first.depth * std::pow(x / first.radius, 1.0 / first.exponent)
                                : 0.0;
  }
  if (x >= last.radius)
  {
    return this->HasWall || !(last.exponent > 0.0)
      ? last.depth
      : last.depth * std::pow(x / last.radius, 1.0 / last.exponent);
  }
  const auto upper = std::lower_bound(this->Samples.begin(), this->Samples.end(), x,
    [](const Sample& sample, double radius) { return sample.radius < radius; });
  const auto cell = static_cast<std::size_t>(upper - this->Samples.begin()) - 1;
  const double target = std::log(x);
  const double share =
    std::log(x / this->Samples[cell].radius) / std::log(upper->radius / this->Samples[cell].radius);
  const double t = increasingRoot(
    [&](double at)
    {
      const Logarithm radius = this->radiusIn(cell, at);
      return ValueAndSlope{ radius.value - target, radius.slope };
    },
    0.0, 1.0, share);
  return this->Samples[cell].depth * std::exp(t * this->cellWidth(cell));
}

double TiltedTool::reducedSlope(double x) const
{
  const double depth = this->reducedProfile(x);
  const Sample& first = this->Samples.front();
  const Sample& last = this->Samples.back();
  double exponent = depth <= first.depth ? first.exponent : last.exponent;
  if (depth > first.depth && depth < last.depth)
  {
    const auto upper = std::upper_bound(this->Samples.begin(), this->Samples.end(), depth,
      [](double at, const Sample& sample) { return at < sample.depth; });
    const auto cell = static_cast<std::size_t>(upper - this->Samples.begin()) - 1;
    const double width = this->cellWidth(cell);
    exponent =
      this->radiusIn(cell, std::log(depth / this->Samples[cell].depth) / width).slope / width;
  }
  return exponent > 0.0 && x > 0.0 ? depth / (x * exponent) : 0.0;
}

double TiltedTool::depthAtContactRadius(double a) const
{
  if (!(a > 0.0))
  {
    return std::isnan(a) ? a : 0.0;
  }
  return this->HasWall && a >= this->Samples.back().radius ? Infinity : this->reducedProfile(a);
}

double TiltedTool::depthAtStrain(double ratio) const
{
  if (!(ratio > 0.0))
  {
    return std::isnan(ratio) ? ratio : 0.0;
  }
  // D/a increases with D if the contact radius increases more slowly than the depth. The root is
  // between these depths.
  constexpr double FarFactor = 1e6;
  double low = this->Samples.front().depth / FarFactor;
  double high = this->Samples.back().depth * FarFactor;
  if (low / this->radiusAt(low) > ratio)
  {
    return 0.0;
  }
  if (high / this->radiusAt(high) <= ratio)
  {
    return Infinity;
  }
  for (int i = 0; i < 100 && high > low * (1.0 + 1e-14); ++i)
  {
    const double middle = std::sqrt(low * high);
    (middle / this->radiusAt(middle) > ratio ? high : low) = middle;
  }
  return high;
}

double TiltedTool::profile(double r) const
{
  if (this->HasWall && r > this->Samples.back().radius)
  {
    return Infinity;
  }
  return 2.0 / Pi *
    GaussLegendre::standard().integrate(
      0.0, 0.5 * Pi, [&](double angle) { return this->reducedProfile(r * std::sin(angle)); });
}
} // namespace palpate
