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
  /// Grey level in the unit of the scan; for labels, the middle of their range.
  double given = 0.0;
  float contour = 0.0f; ///< level of the contour, for the values after mark()
  /// Grey value of tissue; its distance above the contour equals the distance of air below the
  /// contour.
  float tissue = 0.0f;
  /// Whether the values are labels of tissues. Labels are not a measure of density. Therefore
  /// mark() replaces the smallest label by 0 and all other labels by 1.
  bool isLabelled = false;
  float outside = 0.0f; ///< the smallest label, which counts as outside the body

  /// Replaces labels by 0 and 1. Values that are not labels stay unchanged.
  void mark(std::vector<float>& values) const;
};

/// Largest number of different values for which integers count as labels.
inline constexpr int MostLabels = 64;

/**
 * Finds the level of a scan with one component, whose finite values are between `least` and `most`.
 * If `wanted` is 0, the function chooses the level: 0.5 for labels after mark(), otherwise 12 % of
 * the range. For example, 12 % of the range gives 31 for grey values from 0 to 255, and -533 for CT
 * numbers from -1024 to 3071.
 */
SkinLevel skinLevel(vtkDataArray* values, double wanted, double least, double most);
} // namespace palpate

#endif
