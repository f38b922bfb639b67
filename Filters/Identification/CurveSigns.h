// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurveSigns_h
#define palpate_CurveSigns_h

#include "Identification/MeasuredCurve.h"

#include <string>

namespace palpate
{
/**
 * Checks the signs of a curve. If deflection or force seems to decrease while the tool is pressed
 * in, returns the reason as a question, with the values. Returns "" if both increase.
 *
 * The first readings are assumed to be without contact or with the smallest contact. Forces are
 * considered negative if they decrease at greater depths, compared with the first readings, by more
 * than three times as much as they increase. The deflection is considered negative if it decreases
 * while forces increase. Both are considered negative if forces decrease from nearly 0 together
 * with the deflection. Single readings are ignored.
 */
std::string doubtSigns(const MeasuredCurve& curve);

/// Checks the unit of the deflections of a curve. The unit is considered implausible if `depth`
/// (mm) exceeds a hundred times the depth of small strains under the tool. Returns the reason as a
/// question, or "" if the unit is plausible.
std::string doubtUnits(const AxisymmetricTool& tool, double depth);
} // namespace palpate

#endif
