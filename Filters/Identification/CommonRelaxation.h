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
/// The relaxation of all sites of a body. The times are common to the sites, the strengths are
/// separate. Therefore the strengths can be interpolated between the sites.
struct CommonRelaxation
{
  PronySeries mean; ///< mean over all sites; no branches if no site relaxes
  /// p_i of each site: one value for each branch of `mean`, then zeros.
  std::vector<std::array<double, PronySeries::LargestCount>> strength;
  /// The largest relative difference between this ψ and the ψ identified at a site, over the times
  /// of that site.
  double worst = 0.0;
};

/**
 * Makes the common relaxation of sites. Times within a factor of two are merged. Then the closest
 * and weakest times are merged until four remain. The strengths of each site are fitted to the ψ(t)
 * identified there (non-negative least squares, evenly in ln t). E* and the other parameters of a
 * site are unchanged. Exact for one site, and for sites with equal times.
 */
PALPATE_EXPORT CommonRelaxation commonRelaxation(const std::vector<const IdentifiedBody*>& sites);
} // namespace palpate

#endif
