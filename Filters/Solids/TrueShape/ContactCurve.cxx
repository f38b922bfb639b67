// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/ContactCurve.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// Returns the slope at x1 of the parabola through three points.
double middleSlope(double x0, double x1, double x2, double y0, double y1, double y2)
{
  const double before = (y1 - y0) / (x1 - x0);
  const double after = (y2 - y1) / (x2 - x1);
  return (before * (x2 - x1) + after * (x1 - x0)) / (x2 - x0);
}

/// Returns slopes that follow from parabolas and are limited such that the cubic is monotone.
std::vector<double> monotoneSlopes(const std::vector<double>& x, const std::vector<double>& y)
{
  const std::size_t n = x.size();
  std::vector<double> secants(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i)
  {
    secants[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  }
  std::vector<double> slopes(n, secants.front());
  for (std::size_t i = 1; i + 1 < n; ++i)
  {
    slopes[i] = middleSlope(x[i - 1], x[i], x[i + 1], y[i - 1], y[i], y[i + 1]);
  }
  if (n > 2)
  {
    slopes[0] = 2.0 * secants[0] - slopes[1];
    slopes[n - 1] = 2.0 * secants[n - 2] - slopes[n - 2];
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const double least = i == 0 ? secants[0]
      : i + 1 == n              ? secants[n - 2]
                                : std::min(secants[i - 1], secants[i]);
    slopes[i] = std::clamp(slopes[i], 0.0, 3.0 * std::max(least, 0.0));
  }
  return slopes;
}
} // namespace

ContactCurve::ContactCurve(std::vector<ContactSample> samples, double exponent, bool flatEnd,
  double stiffness, CurveEnd end, double tail)
  : Samples(std::move(samples))
  , Exponent(exponent)
  , FlatEnd(flatEnd)
  , End(end)
  , Tail(tail)
{
  for (const ContactSample& sample : this->Samples)
  {
    this->Abscissae.push_back(flatEnd ? sample.deflection : std::log(sample.deflection));
    this->Ordinates.push_back(flatEnd ? sample.force : std::log(sample.force));
  }
  if (this->Samples.size() > 1)
  {
    this->Slopes = monotoneSlopes(this->Abscissae, this->Ordinates);
  }
  else
  {
    this->Slopes.assign(this->Samples.size(), exponent);
  }
  if (flatEnd && !this->Slopes.empty())
  {
    this->Slopes.front() = stiffness;
  }
}

double ContactSample::elements() const
{
  const double m = std::abs(this->mesh);
  const double t = std::abs(this->truncation);
  return std::sqrt(m * m + t * t + 2.0 * this->beside * this->beside * m * t);
}

double ContactCurve::deepest() const
{
  return this->Samples.empty()    ? 0.0
    : this->End == CurveEnd::None ? Infinity
                                  : this->Samples.back().deflection;
}

std::size_t ContactCurve::intervalOf(double deflection) const
{
  const auto above = std::partition_point(this->Samples.begin(), this->Samples.end(),
    [deflection](const ContactSample& s) { return s.deflection <= deflection; });
  const auto i = static_cast<std::size_t>(above - this->Samples.begin());
  return std::min(i > 0 ? i - 1 : 0, this->Samples.size() - 2);
}

IndentationPoint ContactCurve::evaluate(double deflection) const
{
  if (!(deflection > 0.0))
  {
    const double none = std::isnan(deflection) ? NotANumber : 0.0;
    return { none, none, none };
  }
  if (this->Samples.empty() || deflection > this->deepest())
  {
    return { NotANumber, NotANumber, NotANumber };
  }
  const ContactSample& first = this->Samples.front();
  const ContactSample& last = this->Samples.back();
  if (deflection >= last.deflection && this->End == CurveEnd::None)
  {
    return { last.force + this->Tail * (deflection - last.deflection), this->Tail, last.radius };
  }
  if (deflection < first.deflection || this->Samples.size() == 1)
  {
    const double ratio = deflection / first.deflection;
    const double force = first.force * std::pow(ratio, this->Exponent);
    return { force, this->Exponent * force / deflection,
      first.radius * std::pow(ratio, this->Exponent - 1.0) };
  }
  const std::size_t i = this->intervalOf(deflection);
  const double x = this->FlatEnd ? deflection : std::log(deflection);
  const double width = this->Abscissae[i + 1] - this->Abscissae[i];
  const double t = (x - this->Abscissae[i]) / width;
  const double rise = this->Ordinates[i + 1] - this->Ordinates[i];
  const double a = width * this->Slopes[i];
  const double b = width * this->Slopes[i + 1];
  // This is the Hermite cubic y₀ + t(a + t((3 rise - 2a - b) + t(a + b - 2 rise))).
  const double second = 3.0 * rise - 2.0 * a - b;
  const double third = a + b - 2.0 * rise;
  const double y = this->Ordinates[i] + t * (a + t * (second + t * third));
  const double slope = (a + t * (2.0 * second + 3.0 * t * third)) / width;
  const double low = this->Samples[i].radius;
  const double high = this->Samples[i + 1].radius;
  const double radius = this->FlatEnd ? low + t * (high - low) : low * std::pow(high / low, t);
  if (this->FlatEnd)
  {
    return { y, slope, radius };
  }
  const double force = std::exp(y);
  return { force, slope * force / deflection, radius };
}

ContactSample ContactCurve::errorsAt(double deflection) const
{
  if (this->Samples.empty())
  {
    return {};
  }
  if (this->Samples.size() == 1 || deflection <= this->Samples.front().deflection)
  {
    return this->Samples.front();
  }
  const std::size_t i = this->intervalOf(deflection);
  const ContactSample& low = this->Samples[i];
  const ContactSample& high = this->Samples[i + 1];
  const double t =
    std::min(1.0, (deflection - low.deflection) / (high.deflection - low.deflection));
  const auto between = [t](double a, double b) { return a + t * (b - a); };
  ContactSample errors;
  errors.radius = between(low.radius, high.radius);
  errors.deflection = deflection;
  errors.force = this->evaluate(deflection).force;
  errors.truncation = between(low.truncation, high.truncation);
  errors.harmonics = between(low.harmonics, high.harmonics);
  errors.gap = between(low.gap, high.gap);
  errors.direction = between(low.direction, high.direction);
  errors.surface = between(low.surface, high.surface);
  errors.strain = between(low.strain, high.strain);
  errors.mesh = between(low.mesh, high.mesh);
  errors.beside = between(low.beside, high.beside);
  return errors;
}
} // namespace palpate
