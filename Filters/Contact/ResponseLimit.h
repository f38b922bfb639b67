// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseLimit_h
#define palpate_ResponseLimit_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Which of the law's assumptions breaks first at a point: the codes of the array `Limit`.
enum class ResponseLimit : std::uint8_t
{
  None, ///< within Range
  Strain,
  Curvature,
  Thickness,
  OppositeWall,
  Edge,
  DataEnd
};
constexpr std::size_t ResponseLimitCount = 7;

/// What breaks it: "strain", "layer thickness"; "" for 0 and for a number that is no code. These
/// and the next are static texts.
PALPATE_EXPORT const char* limitInWords(int code) noexcept;

/// What was assumed: "small strain", "a flat surface"; "" likewise.
PALPATE_EXPORT const char* assumptionInWords(int code) noexcept;
} // namespace palpate

#endif
