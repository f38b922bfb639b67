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

/// A tool on the points of a body, at which laws are compared.
struct PressedBody
{
  const AxisymmetricTool& tool;
  double range = 0.0;     ///< mm, down to which they are compared; one that the tool allows
  std::size_t points = 0; ///< of the body
  const SurfaceShape& shape;
  double share = 0.95; ///< of the points that an answer is to cover, above 0 to 1
};

/// One way to see a body: with more or with less in its law.
struct LawModel
{
  const BodyMaterial& material;
  bool curvature = false;                   ///< the body's sag
  const StrainCorrection* strain = nullptr; ///< finite strain
};

/**
 * How far `less` is off from `whole`: |F_less/F_whole - 1|, the largest of four depths (1/16, 1/4,
 * 9/16 and all of the range), which `share` of the points do not pass. Infinite where `less` has no
 * force and `whole` has. Looked at are some 400 points, evenly spaced by their number; 0 without
 * any. Cost: making the laws, and 10 to 50 µs a point.
 */
PALPATE_EXPORT double changeOfForce(
  const PressedBody& body, const LawModel& whole, const LawModel& less);

/// The same of finite strain in a Neo-Hooke body, no more than that: by ErrorRule, without solving.
PALPATE_EXPORT double boundOfStrain(const PressedBody& body, const LawModel& model);
} // namespace palpate

#endif
