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
/// A relaxing body fitted to histories. After the errors of BodyFit, `errorPerNoise` has those of
/// ln p_i, then of ln τ_i, if they were fitted.
struct PALPATE_EXPORT RelaxationFit : BodyFit
{
  PronySeries series; ///< times ascend
  double score = 0.0; ///< sum of squares over σ², plus a charge for each parameter (1 %)
};

/**
 * Non-linear least squares (Levenberg and Marquardt) of the force. Parameters: E*, C_g or h, the
 * depths of first contact, and strengths and times of up to four branches. The fit has as many
 * branches as reduce the residual by more than noise would (`noise`, N; a likelihood ratio at 1 %)
 * and remain distinct. It starts from the elastic fit of the loads and a spectrum
 * (RelaxationStart.h). If `given` has at least one branch, the series is not fitted. Returns
 * nothing if no start leads to a body.
 */
PALPATE_EXPORT std::optional<RelaxationFit> fitRelaxingBody(
  const std::vector<PressHistory>& histories, BodyModel model, bool findContact,
  const std::shared_ptr<const LayerKernel>& kernel, double noise, const PronySeries& given);

/// The standard error of ln E* per newton of noise if C_g (0 here) were unknown, too.
PALPATE_EXPORT double modulusErrorBesideCompliance(const std::vector<PressHistory>& histories,
  const RelaxationFit& halfSpace, bool findContact, bool isSeriesGiven);

/// The forces of a relaxing body at the points of a history, N; `offset` as in
/// RelaxingFoundation::follow.
PALPATE_EXPORT std::vector<double> forcesOver(const PressHistory& history,
  const BodyParameters& body, const PronySeries& series,
  const std::shared_ptr<const LayerKernel>& kernel, double offset);
} // namespace palpate

#endif
