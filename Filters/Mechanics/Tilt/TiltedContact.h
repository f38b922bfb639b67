// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltedContact_h
#define palpate_TiltedContact_h

#include "Mechanics/PalpateExport.h"

namespace palpate
{
class AxisymmetricTool;

/// Results for a tilted tool on a half-space.
struct TiltedForce
{
  double perModulus = 0.0; ///< F/E*, mm²
  /// Work divided by E*, mm³. Its relative error is the square of the relative error of the
  /// pressures.
  double work = 0.0;
  double area = 0.0; ///< area of the contact, mm²
};

/**
 * Computes the force of a tool tilted by θ, with its deepest point at the depth D in a half-space,
 * by boundary elements. The surface of the tool is sampled on a grid of `pixels` x `pixels`
 * rectangles fitted to the contact. The pressures are
 * >= 0, and there is no penetration (Polonsky and Keer 1999, conjugate gradients, here for a given
 * depth). The true surface of the tool is used, including flank and wall.
 *
 * Error of the force with 64 and 128 pixels: 1e-4 and 2e-5 for smooth tools; 5e-3 and 2.5e-3 for
 * sharp rims, which are sampled as steps. Cost: 10 and 80 ms.
 *
 * `depth` is D > 0, mm. `angle` is θ >= 0, rad, up to largestTilt(). `pixels` is a power of two,
 * >= 32.
 */
PALPATE_EXPORT TiltedForce solveTilted(
  const AxisymmetricTool& tool, double angle, double depth, int pixels = 64);
} // namespace palpate

#endif
