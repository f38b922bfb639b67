// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TermEffect_h
#define palpate_TermEffect_h

#include "Laws/ResponseFiller.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>

namespace palpate
{
class AxisymmetricTool;
class BodyMaterial;
class StrainCorrection;

/// A body, and the tool that is pressed into it. Laws are compared at the points of the body.
struct PressedBody
{
  const AxisymmetricTool& tool;
  double range = 0.0;     ///< mm, largest compared depth; must be within the tool's depth limit
  std::size_t points = 0; ///< number of points of the body
  const SurfaceShape& shape;
  double share = 0.95; ///< fraction of the points for which a result holds, > 0 to 1
};

/// One model of a body. Models can differ in the terms of their laws.
struct LawModel
{
  const BodyMaterial& material;
  bool curvature = false;                   ///< include the body's curvature
  const StrainCorrection* strain = nullptr; ///< finite strain; null for small strain
};

/**
 * Returns the change of the force between the models `whole` and `less`: the largest
 * |F_less/F_whole - 1| at four depths (1/16, 1/4, 9/16 and all of the range). At a fraction `share`
 * of the points the change does not exceed the result. Infinite if only `whole` has a force; 0 if
 * the body has no points. Uses about 400 points, evenly spaced by their index. Cost: the
 * construction of the laws, and 10 to 50 µs per point.
 */
PALPATE_EXPORT double changeOfForce(
  const PressedBody& body, const LawModel& whole, const LawModel& less);

/// Returns an upper bound of the change of the force by finite strain in a Neo-Hooke body. The
/// bound is computed by ErrorRule, without solving the finite-strain problem.
PALPATE_EXPORT double boundOfStrain(const PressedBody& body, const LawModel& model);
} // namespace palpate

#endif
