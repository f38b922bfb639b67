// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurveSigns_h
#define palpate_CurveSigns_h

#include "Identification/MeasuredCurve.h"

#include <string>

namespace palpate
{
/**
 * Checks the signs of a curve. If deflection or force seems to fall while the tool is pressed in,
 * returns the reason as a question, with the numbers; "" if both rise.
 *
 * The first readings count as those without contact, or with the least contact. Forces are
 * negative if from there they fall, at greater depth, by more than three times as much as they
 * rise. The deflection is negative if it falls while forces rise. Both are negative if forces fall
 * from nearly 0 together with the deflection. A single reading does not count.
 */
std::string doubtSigns(const MeasuredCurve& curve);

/// Checks the unit of the deflections of a curve. They are in another unit than mm if the `depth`
/// (mm) is more than a hundred times the depth of small strains under the tool. Returns the reason
/// as a question; "" if the unit is plausible.
std::string doubtUnits(const AxisymmetricTool& tool, double depth);
} // namespace palpate

#endif
