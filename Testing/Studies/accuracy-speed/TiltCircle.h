// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate
{
class AxisymmetricTool;
}

namespace palpate::testing
{
/**
 * What a tilted tool has at least for a force, over E* (mm²), on a half-space: the largest that any
 * circle of contact has. By reciprocity with a flat end's pressure a circle of radius a about x_c
 * has
 *   F/E* = 2 [a u(0) + ∫_0^a u'(r) √(a² - r²) dr],
 * u the mean over the circle of radius r of how far the tool is pressed below the surface. Without
 * anything solved for; far too little where the contact is a crescent.
 *
 * Angle >= 0, rad; depth of the deepest point > 0, mm. 64 radii, 24 angles, 30 places: 1e-3.
 */
double circleForce(const AxisymmetricTool& tool, double angle, double depth);
} // namespace palpate::testing
