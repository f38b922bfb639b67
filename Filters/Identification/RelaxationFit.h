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
/// A body that relaxes, fitted to histories. `errorPerNoise` continues after the offsets with ln
/// p_i, then ln τ_i, if they were fitted.
struct PALPATE_EXPORT RelaxationFit : BodyFit
{
  PronySeries series; ///< of ascending times
  double score = 0.0; ///< sum of squares per σ², with a charge for each parameter (1 %)
};

/**
 * Non-linear least squares (Levenberg and Marquardt) of the force over E*, C_g or h, the depths of
 * first contact, and strengths and times of up to four branches; as many as reduce the residual by
 * more than noise would (`noise`, N; a likelihood ratio at 1 %) and remain distinct. It starts from
 * the elastic fit of the loads and a spectrum (RelaxationStart.h). If `given` has at least one
 * branch, the series is not fitted. Nothing where no start leads to a body.
 */
PALPATE_EXPORT std::optional<RelaxationFit> fitRelaxingBody(
  const std::vector<PressHistory>& histories, BodyModel model, bool findContact,
  const std::shared_ptr<const LayerKernel>& kernel, double noise, const PronySeries& given);

/// The standard error of ln E* per newton of noise if C_g (0 here) were unknown as well.
PALPATE_EXPORT double modulusErrorBesideCompliance(const std::vector<PressHistory>& histories,
  const RelaxationFit& halfSpace, bool findContact, bool isSeriesGiven);

/// The forces of a relaxing body at the points of a history, N; `offset` as in
/// RelaxingFoundation::follow.
PALPATE_EXPORT std::vector<double> forcesOver(const PressHistory& history,
  const BodyParameters& body, const PronySeries& series,
  const std::shared_ptr<const LayerKernel>& kernel, double offset);
} // namespace palpate

#endif
