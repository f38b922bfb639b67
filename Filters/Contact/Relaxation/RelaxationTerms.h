// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationTerms_h
#define palpate_RelaxationTerms_h

#include "Mechanics/Relaxation/PronySeries.h"

namespace palpate
{
/// What a tick needs of a body that relaxes, beside its curves, which are its slow response; of one
/// that does not the series is empty. Views of somebody else's memory.
struct RelaxationTerms
{
  PronySeries series;
  /// p_i at each point, as many as the series has, instead of the series' own; null: everywhere
  /// the same.
  const float* strength = nullptr;
  /// What of the compliance of each point (mm/N, >= 0) is in series and does not relax, as of a
  /// beam of another material below; null: all relaxes.
  const float* elasticCompliance = nullptr;
  /// m of F ∝ δ^m, and radius of the contact at a depth of 1 mm, mm: how far the tool is led until
  /// what lies under it is new. Radius 0: unknown, nothing is ever new.
  double exponent = 1.0;
  double radius = 0.0;

  bool areFelt() const noexcept { return this->series.relaxes() || this->isPerPoint(); }
  bool isPerPoint() const noexcept { return this->strength && this->series.count > 0; }
};
} // namespace palpate

#endif
