// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate
{
class AxisymmetricTool;
}

namespace palpate::testing
{
/**
 * Lower bound of the force on a tilted tool on a half-space, over E* (mm²): the largest force of
 * all circles of contact. By reciprocity with the pressure of a flat end, a circle of radius a
 * about x_c has
 *   F/E* = 2 [a u(0) + ∫_0^a u'(r) √(a² - r²) dr], where u is the mean, over the circle of radius
 *   r, of the depth of the tool below the surface. No system of equations is solved. The bound is
 *   much too low if the contact is a crescent.
 * Angle >= 0, rad; depth of the deepest point > 0, mm. 64 radii, 24 angles, 30 places: accuracy
 * 1e-3.
 */
double circleForce(const AxisymmetricTool& tool, double angle, double depth);
} // namespace palpate::testing
