// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CommonRelaxation_h
#define palpate_CommonRelaxation_h

#include "Mechanics/Identification/BodyIdentification.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <array>
#include <vector>

namespace palpate
{
/// How the sites of one body relax, each with strengths of its own at times that they share, so
/// that what lies between them can be blended.
struct CommonRelaxation
{
  PronySeries mean; ///< of all sites; no branch where none relaxes
  /// p_i of each site, as many as `mean` has branches; the others are 0.
  std::vector<std::array<double, PronySeries::LargestCount>> strength;
  /// The largest relative difference of ψ from a site's own, over the times of that site.
  double worst = 0.0;
};

/**
 * Times within a factor of two are one, then the closest and weakest are merged until four are
 * left; the strengths of each site are those that are nearest to its own ψ(t) (non-negative least
 * squares in ln t). E* and all else of a site stay as they were identified. Exact for one site, and
 * for sites of the same times.
 */
PALPATE_EXPORT CommonRelaxation commonRelaxation(const std::vector<const IdentifiedBody*>& sites);
} // namespace palpate

#endif
