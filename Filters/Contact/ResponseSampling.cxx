// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseSampling.h"

namespace palpate
{
ResponseSampling::ResponseSampling(int samples, double exponent)
  : Samples(samples)
  , Exponent(exponent)
{
  for (int i = 1; i <= samples; ++i)
  {
    this->Weights.push_back(std::pow(static_cast<double>(i) / samples, -2.0 * exponent));
  }
}
} // namespace palpate
