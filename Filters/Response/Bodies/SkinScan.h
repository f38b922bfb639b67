// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Grey levels of a scan, low in air and high in tissue, prepared for the contour of the outer
 * skin: openings closed, cavities filled. The grey levels at the skin itself survive, so that a
 * contour keeps its sub-voxel position.
 *
 * Uses vtkSMPTools; the result does not depend on the number of threads.
 */

#ifndef palpate_SkinScan_h
#define palpate_SkinScan_h

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

namespace palpate
{
struct SkinScan
{
  std::array<int, 3> size;       // voxels along x, y, z
  std::array<double, 3> spacing; // mm, > 0
  std::vector<float> values;     // finite, x fastest

  /** Called with the fraction done, 0 to 1; false = stop. */
  using Progress = std::function<bool(double)>;

  /**
   * Flat grey-level closing (dilation, then erosion) with a ball of `radius` mm, as if there were
   * air around the scan. Time grows with voxels times the square of the radius in voxels. False
   * when stopped; the values are then meaningless.
   */
  bool closeOpenings(double radius, const Progress& progress);

  /**
   * Raises every voxel below `contour` to `tissue`, except the air: of the regions below the
   * contour, connected through faces, the largest that reaches the border of the scan. False when
   * there is none.
   */
  bool fillCavities(float contour, float tissue);
};
} // namespace palpate

#endif
