// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mechanics/Relaxation/PronySeries.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate::testing
{
/**
 * Parallel elements for f = δ^m up to 1 mm. Each element is one-sided and relaxes independently, as
 * in the theorem (reference sheet, 8.1). As the number of elements grows, the force approaches the
 * exact force. This is an independent implementation: it shares no code with
 * Filters/Mechanics/Relaxation.
 */
class RelaxationFoundation
{
public:
  RelaxationFoundation(double exponent, const PronySeries& series, std::size_t count);

  void forget();
  /// Returns the force (N) at a depth (mm; negative outside), `elapsed` s after the last call. The
  /// depth changes linearly between two calls.
  double press(double depth, double elapsed);
  std::size_t bytes() const { return sizeof(*this) + this->Elements.size() * sizeof(Element); }

private:
  struct Element
  {
    double gap = 0.0;                                     ///< mm
    double weight = 0.0;                                  ///< N/mm
    double depth = 0.0;                                   ///< depth of this element, mm
    std::array<double, PronySeries::LargestCount> over{}; ///< h_i, mm
  };

  PronySeries Series;
  std::vector<Element> Elements;
};
} // namespace palpate::testing
