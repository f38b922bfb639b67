// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/InclusionMixing.h"

#include <cmath>

namespace palpate
{
double mixedModulus(double around, double inclusion, double fraction)
{
  return inclusion > around ? 1.0 / ((1.0 - fraction) / around + fraction / inclusion)
                            : around * std::pow(inclusion / around, fraction);
}
} // namespace palpate
