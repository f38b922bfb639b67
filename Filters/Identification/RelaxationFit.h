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
/// A relaxing body fitted to histories. `errorPerNoise` contains the errors of BodyFit, followed by
/// those of ln p_i and of ln τ_i if these parameters were fitted.
struct PALPATE_EXPORT RelaxationFit : BodyFit
{
  PronySeries series; ///< branches in the order of their times
  /// Sum of squares divided by σ², plus a penalty for each parameter (1 % test).
  double score = 0.0;
};

/**
 * Fits a relaxing body by non-linear least squares (Levenberg and Marquardt) of the force. The
 * parameters are E*, C_g or h, the depths of first contact, and strengths and times of up to four
 * branches. The number of branches is as large as possible under two conditions: each branch
 * reduces the residual by more than noise would (a likelihood ratio test at 1
 * %), and the times of the branches remain distinct. `noise` is the noise of a reading, N. The fit
 * starts from the elastic fit of the loadings and a spectrum (RelaxationStart.h). If `given` has at
 * least one branch, the series is not fitted. Returns no value if no initial body leads to a
 * result.
 */
PALPATE_EXPORT std::optional<RelaxationFit> fitRelaxingBody(
  const std::vector<PressHistory>& histories, BodyModel model, bool findContact,
  const std::shared_ptr<const LayerKernel>& kernel, double noise, const PronySeries& given);

/// Returns the standard error that ln E* would have if C_g (0 here) were also unknown, divided by
/// the standard deviation of the noise (N).
PALPATE_EXPORT double modulusErrorBesideCompliance(const std::vector<PressHistory>& histories,
  const RelaxationFit& halfSpace, bool findContact, bool isSeriesGiven);

/// Returns the forces of a relaxing body at the points of a history, N. `offset` is the deflection
/// at first contact, mm, as in RelaxingFoundation::follow().
PALPATE_EXPORT std::vector<double> forcesOver(const PressHistory& history,
  const BodyParameters& body, const PronySeries& series,
  const std::shared_ptr<const LayerKernel>& kernel, double offset);
} // namespace palpate

#endif
