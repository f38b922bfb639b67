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
  for (int i = 1; i <= samples; ++i)
  {
    const double root = static_cast<double>(i) / samples;
    this->Nodes.push_back({ root, std::pow(root, -2.0 * exponent), -2.0 * exponent / root });
  }
}
} // namespace palpate
