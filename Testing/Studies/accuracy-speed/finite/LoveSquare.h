// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::testing
{

/// Normal displacement of a half-space at (x, y) under a uniform pressure on the square |x'|, |y'|
/// <= 1/2, times πE* per force (Love 1929; Johnson 1985, eq. 3.25). Lengths in units of the side.
/// Not defined on the lines of the sides.
double loveSquare(double x, double y);

} // namespace palpate::testing
