// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mechanics/Relaxation/PronySeries.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate::testing
{
/**
 * Elements side by side for f = δ^m up to 1 mm, each one-sided and relaxing by itself, as the
 * theorem has it (reference sheet, 8.1): as their number grows, the exact force. Written once more,
 * plainly: shares nothing with Filters/Mechanics/Relaxation.
 */
class RelaxationFoundation
{
public:
  RelaxationFoundation(double exponent, const PronySeries& series, std::size_t count);

  void forget();
  /// The force, N, at a depth (mm; negative outside) `elapsed` s after the last, the way between
  /// them straight.
  double press(double depth, double elapsed);
  std::size_t bytes() const { return sizeof(*this) + this->Elements.size() * sizeof(Element); }

private:
  struct Element
  {
    double gap = 0.0;                                     ///< mm
    double weight = 0.0;                                  ///< N/mm
    double depth = 0.0;                                   ///< its own, mm
    std::array<double, PronySeries::LargestCount> over{}; ///< h_i, mm
  };

  PronySeries Series;
  std::vector<Element> Elements;
};
} // namespace palpate::testing
