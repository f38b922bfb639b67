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
/// What elements let expect of the error of H at a source, mm/N, >= 0 (ElementError,
/// BendingError).
struct ExpectedError
{
  double error = NotANumber;
  double direct = NotANumber;             ///< of H what is beyond this is bending
  double bending = BendingError::Assumed; ///< what they miss of that, as a fraction of it
};

/// The expected errors of the points of a RegularGreen: own ones where they are sources, those of
/// the nearest sources of their disc elsewhere.
class SourceErrors
{
public:
  SourceErrors() = default;
  /// `points` and `sources` ascending; `discs` beside the points. Cost: that of an ElementError per
  /// source, on threadCount() threads.
  SourceErrors(const ElasticBody& body, const std::vector<std::int32_t>& points,
    const std::vector<SurfaceDisc>& discs, const std::vector<std::int32_t>& sources);

  /// Of the point at this place in `points`.
  const ExpectedError& at(std::size_t place) const { return this->Errors[place]; }

  void setBending(const BendingError& bending, const BodySurface& surface,
    const std::vector<std::int32_t>& points);

private:
  std::vector<ExpectedError> Errors;
};
} // namespace palpate

#endif
