// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxingIdentification_h
#define palpate_RelaxingIdentification_h

#include "Identification/BodyIdentification.h"
#include "Identification/PressHistory.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/**
 * Identifies a relaxing body at one site. The slow response is identified in the same way as an
 * elastic body (BodyIdentification). Strengths and times of the relaxation (PronySeries) are
 * identified from loading, holding and unloading together. The whole body relaxes, including a
 * compliance in series.
 *
 * Each of the three models is fitted with as many branches as the readings require. The result is
 * the model with the smallest sum of residual and penalty. The penalty for each parameter is the
 * reduction of the residual that noise would cause (1 %). If options().relaxation is given, the
 * series is assumed to be known, and only the effect of the test's speed is computed.
 *
 * Confidence intervals are computed as in BodyIdentification; those of strengths and times are
 * symmetric in the logarithm. A test resolves relaxation times from a fifteenth of the duration of
 * its fastest press to its longest hold
 * (`shortestTime`, `longestTime`). `remark` states the times that are not resolved. Slow response
 * and strength are correlated. If no hold shows the final force, E* is therefore refused as too
 * uncertain, or has a wide interval.
 *
 * Readings at too large a strain are not compared with the fit, but remain in the history. A site
 * is refused if its longest hold is at such a strain. Cost: a tenth of a second, or a second for a
 * layer. Thread-safe.
 */
PALPATE_EXPORT IdentifiedBody identifyRelaxing(
  const BodyIdentification& identification, std::vector<PressHistory> histories);
} // namespace palpate

#endif
