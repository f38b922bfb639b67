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
/// The relaxation of all sites of a body. The relaxation times are common to all sites; each site
/// has its own strengths. Therefore the strengths can be interpolated between the sites.
struct CommonRelaxation
{
  PronySeries mean; ///< mean over all sites; it has no branches if no site relaxes
  /// p_i of each site, with one value for each branch of `mean`; the other entries are zero.
  std::vector<std::array<double, PronySeries::LargestCount>> strength;
  /// The largest relative difference between the ψ of a site computed with the common times and the
  /// ψ identified at the site, over the times of the site.
  double worst = 0.0;
};

/**
 * Computes the common relaxation of sites. Times within a factor of two are merged. Then close and
 * weak branches are merged until four times remain. The strengths of each site are fitted to the
 * ψ(t) identified at the site (non-negative least squares, evenly in ln t). E* and the other
 * parameters of a site are not changed. The result is exact for one site, and for sites with equal
 * times.
 */
PALPATE_EXPORT CommonRelaxation commonRelaxation(const std::vector<const IdentifiedBody*>& sites);
} // namespace palpate

#endif
