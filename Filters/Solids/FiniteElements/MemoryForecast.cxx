// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/MemoryForecast.h"

#include <algorithm>

namespace palpate
{
namespace
{
// Measured values (see MemoryForecast). The matrix takes 2.4 to 3.6 kB per node. FactorBytes is the
// mean of c.
constexpr double MatrixBytes = 3000.0;
constexpr double FactorBytes = 750.0;
} // namespace

MemoryForecast forecastMemory(double nodes, double outerNodes)
{
  const double thickness = 6.0 * nodes / std::max(1.0, std::min(outerNodes, nodes));
  return { MatrixBytes * nodes, FactorBytes * nodes * thickness };
}
} // namespace palpate
