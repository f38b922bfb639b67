// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MemoryForecast_h
#define palpate_MemoryForecast_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Memory of a body's finite elements in bytes. It is estimated from the number of nodes before
 * assembly. The estimate is accurate to within a factor of ForecastError.
 *
 * With nested dissection the number of entries in a column of the factor is proportional to the
 * body's thickness. With n nodes, b of which are on the surface, the thickness in nodes is taken as
 * 6 n/b. For a cube this is the number of nodes along a side. The factor then takes c n · 6 n/b
 * bytes, which is c n^(4/3) for a cube. Measured with CHOLMOD and METIS on blocks of hexahedra and
 * of tetrahedra, c is 490 to 940 and grows slowly with n: 611 for 10³ elements, 889 for 40³, 942
 * for 60³, 661 for 60 × 60 × 6, 913 for 200 × 200 × 10, 615 for 6 × 6 × 300. c is smallest for
 * small bodies with many held nodes. The exact number is known after the symbolic analysis
 * (StiffnessFactor::memoryEstimate), which itself takes hours on some bodies.
 */
struct MemoryForecast
{
  double matrix = 0.0; ///< memory of the stiffness matrix and its symbolic analysis
  double factor = 0.0; ///< memory of the Cholesky factor of the stiffness matrix

  static constexpr double ForecastError = 2.0;

  /// Returns whether the body certainly needs more than `bytes`.
  bool exceeds(double bytes) const
  {
    return this->matrix > ForecastError * bytes || this->factor > ForecastError * bytes;
  }
};

/// Returns the forecast for `nodes` nodes, of which `outerNodes` are on the surface.
PALPATE_EXPORT MemoryForecast forecastMemory(double nodes, double outerNodes);
} // namespace palpate

#endif
