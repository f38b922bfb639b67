// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxingIdentification_h
#define palpate_RelaxingIdentification_h

#include "Mechanics/Identification/BodyIdentification.h"
#include "Mechanics/Identification/PressHistory.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/**
 * Which body one site is that relaxes: its slow response, as BodyIdentification finds an elastic
 * one, and strengths and times of its relaxation (PronySeries), from all that tools did there,
 * loading, holding and unloading alike. The body relaxes as a whole, a compliance in series as
 * well.
 *
 * Of the three models each is fitted with as many branches as its readings ask for; the answer is
 * the one that leaves least, when each parameter is charged with what noise would give it (1 %).
 * With options().relaxation the series is taken as known, and the speed of the test is taken into
 * account.
 *
 * Confidence intervals as there; of strengths and times symmetric in the logarithm. A test tells
 * times from a fifteenth of its fastest press to its longest hold (`shortestTime`, `longestTime`);
 * `remark` says in words what it does not tell. Slow response and strength trade off: unless a hold
 * shows where the force comes to rest, E* is refused as too uncertain, or has a wide interval.
 *
 * Readings deeper than small strain allows are not compared, but what was pressed there is
 * remembered; a site whose longest hold lies there is refused. Cost: a tenth of a second, a second
 * for a layer. From any number of threads.
 */
PALPATE_EXPORT IdentifiedBody identifyRelaxing(
  const BodyIdentification& identification, std::vector<PressHistory> histories);
} // namespace palpate

#endif
