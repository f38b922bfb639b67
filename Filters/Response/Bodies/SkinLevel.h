// SPDX-License-Identifier: BSD-3-Clause
/**
 * The grey level of the skin in a scan, given by the user or chosen from the scan.
 */
#ifndef palpate_SkinLevel_h
#define palpate_SkinLevel_h

#include <vector>

class vtkDataArray;

namespace palpate
{
struct SkinLevel
{
  double given = 0.0;   ///< in the unit of the scan; of labels the middle of their range
  float contour = 0.0f; ///< of the values after mark()
  float tissue = 0.0f;  ///< value of the tissue, as far above the contour as air is below it
  /// Whether the values are labels of tissues. A label is no measure of density, so that all labels
  /// above the least one count as 1, and the least one as 0.
  bool isLabelled = false;
  float outside = 0.0f; ///< the least label

  /// Replaces labels by 0 and 1; other values stay.
  void mark(std::vector<float>& values) const;
};

/// Integers of at most this many different values are labels of tissues.
inline constexpr int MostLabels = 64;

/**
 * The level of a scan of one component, whose finite values lie between `least` and `most`. If
 * `wanted` is 0 it is chosen: 0.5 of marked labels, otherwise 12 % of the range. That is 31 for
 * grey values from 0 to 255, and -533 for CT numbers from -1024 to 3071.
 */
SkinLevel skinLevel(vtkDataArray* values, double wanted, double least, double most);
} // namespace palpate

#endif
