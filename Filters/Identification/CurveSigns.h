// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurveSigns_h
#define palpate_CurveSigns_h

#include "Identification/MeasuredCurve.h"

#include <string>

namespace palpate
{
/**
 * Why deflection or force of a curve seems to fall where the tool is pressed in, with the numbers,
 * as a question; "" where both rise.
 *
 * The first readings are those without contact, or with the least. Forces that from there fall by
 * three times as much as they rise, at greater depth, are negative; so is a deflection that falls
 * while forces rise; so are both where forces fall from nearly 0 with the deflection. A single
 * reading does not count.
 */
std::string doubtSigns(const MeasuredCurve& curve);

/// Why the deflections of a curve are in another unit than mm, as a question: pressed in by `depth`
/// (mm) a tool would be a hundred times as deep as small strains reach. "" where they are not.
std::string doubtUnits(const AxisymmetricTool& tool, double depth);
} // namespace palpate

#endif
