// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationTerms_h
#define palpate_RelaxationTerms_h

#include "Mechanics/Relaxation/PronySeries.h"

namespace palpate
{
/// Relaxation data of a body, in addition to the curves of the slow response. The series is empty
/// if the body does not relax. The views do not own their memory.
struct RelaxationTerms
{
  PronySeries series;
  /// p_i at each point, series.count values per point, used instead of the p_i of the series. Null
  /// if those of the series apply to all points.
  const float* strength = nullptr;
  /// The part of the compliance of each point (mm/N, >= 0) that is in series and does not relax,
  /// for example that of a beam of another material below. Null if the whole compliance relaxes.
  const float* elasticCompliance = nullptr;
  /// Exponent m of F ∝ δ^m, and the contact radius at a depth of 1 mm, mm. The contact radius
  /// determines how far a tool must move to reach new material. If the radius is unknown (0),
  /// material never counts as new.
  double exponent = 1.0;
  double radius = 0.0;

  bool areFelt() const noexcept { return this->series.relaxes() || this->isPerPoint(); }
  bool isPerPoint() const noexcept { return this->strength && this->series.count > 0; }
};
} // namespace palpate

#endif
