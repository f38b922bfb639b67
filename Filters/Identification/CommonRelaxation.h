// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CommonRelaxation_h
#define palpate_CommonRelaxation_h

#include "Identification/BodyIdentification.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <array>
#include <vector>

namespace palpate
{
/// The relaxation of all sites of a body, with common times and separate strengths, which can be
/// interpolated between the sites.
struct CommonRelaxation
{
  PronySeries mean; ///< of all sites; no branch where none relaxes
  /// p_i of each site, as many as `mean` has branches, followed by 0.
  std::vector<std::array<double, PronySeries::LargestCount>> strength;
  /// The largest relative difference of ψ from a site's own, over the times of that site.
  double worst = 0.0;
};

/**
 * Times within a factor of two are merged, then the closest and weakest until four are left; the
 * strengths of each site are fitted to its own ψ(t) (non-negative least squares in ln t). E* and
 * all else of a site are unchanged. Exact for one site, and for sites of equal times.
 */
PALPATE_EXPORT CommonRelaxation commonRelaxation(const std::vector<const IdentifiedBody*>& sites);
} // namespace palpate

#endif
