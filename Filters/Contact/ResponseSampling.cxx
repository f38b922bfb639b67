// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ResponseSampling.h"

namespace palpate
{
namespace
{
int smallWhole(double power)
{
  constexpr double largest = 8.0;
  return power >= 1.0 && power <= largest && power == std::floor(power) ? static_cast<int>(power)
                                                                        : 0;
}
} // namespace

ResponseSampling::ResponseSampling(int samples, double exponent)
  : Samples(samples)
  , Exponent(exponent)
  , WholePower(smallWhole(2.0 * exponent))
  , Spacing(1.0 / samples)
{
  if (samples > FewNodes)
  {
    this->Many.resize(static_cast<std::size_t>(samples));
  }
  Node* const nodes = samples > FewNodes ? this->Many.data() : this->Few.data();
  for (int i = 1; i <= samples; ++i)
  {
    const double root = static_cast<double>(i) / samples;
    nodes[i - 1] = { root, std::pow(root, -2.0 * exponent), -2.0 * exponent / root };
  }
}

namespace
{
/// A cubic c0 + c1 t + c2 t² + c3 t³ on an interval.
struct Cubic
{
  long double c0, c1, c2, c3;
};

/// Returns the integral of s^p times a cubic in t over an interval of width h, which begins at h
/// times `first`. Long double is used because terms of the order of first³ cancel in the
/// integration by parts.
long double integral(const Cubic& c, long double first, long double h, long double p)
{
  const auto primitive = [&](long double t)
  {
    const long double x = first + t;
    const long double rho = c.c0 + t * (c.c1 + t * (c.c2 + t * c.c3));
    const long double d1 = c.c1 + t * (2.0L * c.c2 + t * 3.0L * c.c3);
    const long double d2 = 2.0L * c.c2 + t * 6.0L * c.c3;
    const long double d3 = 6.0L * c.c3;
    return std::pow(x * h, p + 1.0L) *
      (rho - x / (p + 2.0L) * (d1 - x / (p + 3.0L) * (d2 - x / (p + 4.0L) * d3))) / (p + 1.0L);
  };
  return primitive(1.0L) - primitive(0.0L);
}
} // namespace

ResponseEnergy::ResponseEnergy(const ResponseSampling& sampling)
  : Sampling(sampling)
  , Samples(sampling.samples())
  , Exponent(sampling.exponent())
  , Left(static_cast<std::size_t>(sampling.samples()))
  , Right(static_cast<std::size_t>(sampling.samples()))
{
  const long double m = this->Exponent;
  const long double h = 1.0L / this->Samples;
  const auto weight = [&](int i) { return std::pow(h * i, -2.0L * m); };
  // The force of a sample enters through the value of ρ and, with the factor -2m/s, through the
  // slope of ρ. The stiffness of the sample enters only through the slope.
  const auto share = [&](long double value, long double slope, int i) -> Share
  {
    const long double s = h * i;
    return { static_cast<double>(2.0L * weight(i) * (value - 2.0L * m / s * slope)),
      static_cast<double>(4.0L * weight(i) * s * slope) };
  };
  for (int i = 1; i <= this->Samples; ++i)
  {
    this->Weights.push_back(static_cast<double>(weight(i)));
  }
  for (int i = 1; i < this->Samples; ++i)
  {
    const auto over = [&](const Cubic& cubic) { return integral(cubic, i, h, 2.0L * m + 1.0L); };
    const auto at = static_cast<std::size_t>(i);
    this->Right[at - 1] =
      share(over({ 1.0L, 0.0L, -3.0L, 2.0L }), h * over({ 0.0L, 1.0L, -2.0L, 1.0L }), i);
    this->Left[at] =
      share(over({ 0.0L, 0.0L, 3.0L, -2.0L }), h * over({ 0.0L, 0.0L, -1.0L, 1.0L }), i + 1);
  }
}
} // namespace palpate
