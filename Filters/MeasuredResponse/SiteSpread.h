// SPDX-License-Identifier: BSD-3-Clause
#ifndef SiteSpread_h
#define SiteSpread_h

#include "Contact/BodyMesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// The projection of a site on the surface.
struct SiteAnchor
{
  std::int32_t triangle = -1;
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); ///< unit vector, outward
};

/**
 * Interpolates values from sites to the points of a body.
 *
 * A site contributes to a point under three conditions: the point is within `reach` (mm, straight
 * distance); it is connected to the site over the surface within about that distance; and its
 * normal is within 60° of the normal at the site (visitSurfacePatch). Therefore no value is
 * transferred through a thin lobe. The weights of a point's sites are those of vtkShepardKernel,
 * 1/d², multiplied by (1 - d/reach)², so that the result is continuous at the end of a site's reach
 * (Franke and Little 1980).
 */
class SiteSpread
{
public:
  SiteSpread(const BodyMesh& mesh, const std::vector<SiteAnchor>& sites, double reach);

  /// Whether the point is within the reach of at least one site.
  bool reaches(std::int32_t point) const
  {
    return this->Start[static_cast<std::size_t>(point)] <
      this->Start[static_cast<std::size_t>(point) + 1];
  }

  /// Returns the interpolated value at a point. `values` has one value per site. The point must be
  /// within the reach of a site.
  double at(std::int32_t point, const std::vector<double>& values) const;
  /// Returns the weighted root mean square deviation of the sites' values from at(); 0 at a site.
  double deviationAt(std::int32_t point, const std::vector<double>& values) const;

private:
  /// Index in Site of the first site of each point, and finally the number of entries.
  std::vector<std::size_t> Start;
  std::vector<std::int32_t> Site;
  std::vector<double> Weight;
};
} // namespace palpate

#endif
