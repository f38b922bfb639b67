// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Grey levels of a scan, low in air and high in tissue, prepared for the contour of the outer skin:
 * openings are closed, and cavities are filled. The grey levels at the skin itself do not change,
 * so that a contour keeps its sub-voxel position.
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
  std::array<int, 3> size;       // number of voxels along x, y, z
  std::array<double, 3> spacing; // spacing of the voxels, mm, > 0
  std::vector<float> values;     // grey values, all finite; x varies fastest

  /** Receives the completed fraction of the work, 0 to 1. Returns false to stop. */
  using Progress = std::function<bool(double)>;

  /**
   * Flat grey-level closing (dilation, then erosion) with a ball of `radius` mm, as if the scan
   * were surrounded by air. The time is proportional to the number of voxels times the square of
   * the radius in voxels. Returns false if `progress` stopped the closing; the grey values are then
   * meaningless.
   */
  bool closeOpenings(double radius, const Progress& progress);

  /**
   * Raises every voxel below `contour` to `tissue`, except the air. The air is the largest
   * face-connected region below the contour that reaches the border of the scan. Returns false if
   * no region reaches the border.
   */
  bool fillCavities(float contour, float tissue);
};
} // namespace palpate

#endif
