// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SourceErrors_h
#define palpate_SourceErrors_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/TrueShape/BendingError.h"
#include "Solids/TrueShape/SurfaceDisc.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// Expected error of H at a source due to the elements, mm/N, >= 0 (ElementError, BendingError).
struct ExpectedError
{
  double error = NotANumber;
  double direct = NotANumber; ///< the part of H above this value is due to bending
  /// Fraction of the bending that the elements do not represent.
  double bending = BendingError::Assumed;
};

/// Expected errors at the points of a RegularGreen. A source has its own error. The error at
/// another point is that of the nearest sources in the disc of the point.
class SourceErrors
{
public:
  SourceErrors() = default;
  /// `points` and `sources` are in ascending order. `discs` has one disc per point. Cost: one
  /// ElementError per source, on threadCount() threads.
  SourceErrors(const ElasticBody& body, const std::vector<std::int32_t>& points,
    const std::vector<SurfaceDisc>& discs, const std::vector<std::int32_t>& sources);

  /// Returns the error of the point with the index `place` in `points`.
  const ExpectedError& at(std::size_t place) const { return this->Errors[place]; }

  void setBending(const BendingError& bending, const BodySurface& surface,
    const std::vector<std::int32_t>& points);

private:
  std::vector<ExpectedError> Errors;
};
} // namespace palpate

#endif
