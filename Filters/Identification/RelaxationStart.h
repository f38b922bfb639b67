// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationStart_h
#define palpate_RelaxationStart_h

#include "Identification/RelaxationResiduals.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Strengths of the slow response and of branches at given relaxation times, relative to the force
/// of a body.
struct RelaxationSpectrum
{
  double slow = 0.0;
  std::vector<double> strength; ///< strength of each branch, > 0
  std::vector<double> time;     ///< relaxation time of each branch, s, ascending

  /// Returns the spectrum reduced to at most `count` branches. Neighbouring branches that are close
  /// or weak are merged.
  RelaxationSpectrum merged(std::size_t count) const;
};

/**
 * Estimates the relaxation from the forces of histories, for an approximate body and offsets. The
 * slow response and branches at three times per decade of the window are fitted by non-negative
 * least squares, with the quasi-linear law. Only readings above a tenth of the largest force are
 * used. The result provides the initial values of a fit.
 */
RelaxationSpectrum startingSpectrum(const std::vector<PressHistory>& histories,
  const RelaxingBody& about, const std::shared_ptr<const LayerKernel>& kernel,
  const TimeWindow& window);

/// Returns a body whose slow response is that of `about` multiplied by the slow strength, and whose
/// relaxation is that of the spectrum.
RelaxingBody withSpectrum(RelaxingBody about, const RelaxationSpectrum& spectrum);
} // namespace palpate

#endif
