// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationFit_h
#define palpate_RelaxationFit_h

#include "Identification/BodyFit.h"
#include "Identification/PressHistory.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// A relaxing body fitted to histories. `errorPerNoise` contains the errors of BodyFit, then those
/// of ln p_i and of ln τ_i, if these were fitted.
struct PALPATE_EXPORT RelaxationFit : BodyFit
{
  PronySeries series; ///< times are ascending
  double score = 0.0; ///< sum of squares over σ², plus a penalty for each parameter (1 %)
};

/**
 * Fits a relaxing body by non-linear least squares (Levenberg and Marquardt) of the force.
 * Parameters: E*, C_g or h, the depths of first contact, and strengths and times of up to four
 * branches. The number of branches is the largest for which each branch reduces the residual by
 * more than noise would (`noise`, N; a likelihood ratio at 1 %) and the branches remain distinct.
 * The fit starts from the elastic fit of the loadings and a spectrum (RelaxationStart.h). If
 * `given` has at least one branch, the series is not fitted. Returns nothing if no start leads to a
 * body.
 */
PALPATE_EXPORT std::optional<RelaxationFit> fitRelaxingBody(
  const std::vector<PressHistory>& histories, BodyModel model, bool findContact,
  const std::shared_ptr<const LayerKernel>& kernel, double noise, const PronySeries& given);

/// The standard error of ln E* per newton of noise if C_g (0 here) were also unknown.
PALPATE_EXPORT double modulusErrorBesideCompliance(const std::vector<PressHistory>& histories,
  const RelaxationFit& halfSpace, bool findContact, bool isSeriesGiven);

/// The forces of a relaxing body at the points of a history, N; `offset` as in
/// RelaxingFoundation::follow.
PALPATE_EXPORT std::vector<double> forcesOver(const PressHistory& history,
  const BodyParameters& body, const PronySeries& series,
  const std::shared_ptr<const LayerKernel>& kernel, double offset);
} // namespace palpate

#endif
