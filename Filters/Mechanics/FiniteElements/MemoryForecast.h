// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MemoryForecast_h
#define palpate_MemoryForecast_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * What the finite elements of a body will take, bytes, told by its numbers of nodes before anything
 * is assembled; off by up to a factor of ForecastError.
 *
 * Nested dissection leaves in a column of the factor as many entries, in proportion, as the body is
 * thick: with n nodes, b of them on the surface, 6 n/b, which is the side of a cube. That makes
 * c n · 6 n/b bytes, c n^(4/3) for a cube. Measured with CHOLMOD and METIS on blocks of hexahedra
 * and of tetrahedra, c is 490 to 940, and grows slowly with n: 611 for 10³ elements, 889 for 40³,
 * 942 for 60³, 661 for 60 × 60 × 6, 913 for 200 × 200 × 10, 615 for 6 × 6 × 300; least for small
 * bodies, many of whose nodes are held. The exact number is known after the symbolic analysis
 * (StiffnessFactor::memoryEstimate); this one is for bodies on which that would itself take hours.
 */
struct MemoryForecast
{
  double matrix = 0.0; ///< the stiffness, and the analysis of its pattern
  double factor = 0.0; ///< its Cholesky factor

  static constexpr double ForecastError = 2.0;

  /// Whether it is certain that it does not fit so many bytes.
  bool exceeds(double bytes) const
  {
    return this->matrix > ForecastError * bytes || this->factor > ForecastError * bytes;
  }
};

/// Of `nodes` nodes, of which `outerNodes` lie on the surface.
PALPATE_EXPORT MemoryForecast forecastMemory(double nodes, double outerNodes);
} // namespace palpate

#endif
