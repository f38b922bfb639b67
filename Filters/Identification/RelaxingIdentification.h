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
 * Identifies a relaxing body at one site: its slow response, as BodyIdentification finds an elastic
 * one, and strengths and times of its relaxation (PronySeries), from loading, holding and unloading
 * alike. The whole body relaxes, including a compliance in series.
 *
 * Each of the three models is fitted with as many branches as its readings need; the result is that
 * of least residual, with a charge for each parameter of what noise would give (1 %). With
 * options().relaxation the series is taken as known, and the speed of the test is taken into
 * account.
 *
 * Confidence intervals as there; of strengths and times symmetric in the logarithm. A test resolves
 * times from a fifteenth of its fastest press to its longest hold (`shortestTime`, `longestTime`);
 * `remark` says in words what it does not resolve. Slow response and strength are correlated:
 * unless a hold shows where the force comes to rest, E* is refused as too uncertain, or has a wide
 * interval.
 *
 * Readings deeper than small strain allows are not compared, but remain in the history; a site
 * whose longest hold lies there is refused. Cost: a tenth of a second, a second for a layer.
 * Thread-safe.
 */
PALPATE_EXPORT IdentifiedBody identifyRelaxing(
  const BodyIdentification& identification, std::vector<PressHistory> histories);
} // namespace palpate

#endif
