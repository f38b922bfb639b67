// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationStart_h
#define palpate_RelaxationStart_h

#include "Mechanics/Identification/RelaxationResiduals.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Shares of the slow response and of branches at given times, in units of the force of a body.
struct RelaxationSpectrum
{
  double slow = 0.0;
  std::vector<double> strength; ///< > 0
  std::vector<double> time;     ///< s, ascending

  /// The same with at most `count` branches: neighbours that are close and weak are merged.
  RelaxationSpectrum merged(std::size_t count) const;
};

/**
 * What of relaxation is in the forces of histories, if body and offsets are about right:
 * non-negative least squares over the slow response and branches at three times per decade of the
 * window, quasi-linear, from the readings above a tenth of the largest force. A start for a fit.
 */
RelaxationSpectrum startingSpectrum(const std::vector<PressHistory>& histories,
  const RelaxingBody& about, const std::shared_ptr<const LayerKernel>& kernel,
  const TimeWindow& window);

/// The body whose slow response is `about` times the slow share, and which relaxes as the spectrum
/// says.
RelaxingBody withSpectrum(RelaxingBody about, const RelaxationSpectrum& spectrum);
} // namespace palpate

#endif
