// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/StrainShare.h"

#include "Mechanics/FiniteStrain/SmallStrainError.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <cmath>

namespace palpate
{
namespace
{
/// Error of the correction, as a fraction of the effect of finite strain. The error arises because
/// the contact differs from the contact on a half-space under the same force.
constexpr double StrainErrorFactor = 0.3;

/// Returns the depth of the tool in a half-space under `force`, mm.
double depthUnder(const AxisymmetricTool& tool, double force, double radius, double modulus)
{
  double depth = radius < tool.largestContactRadius() && radius > tool.smallestContactRadius()
    ? tool.depthAtContactRadius(radius)
    : force / (2.0 * modulus * radius);
  for (int i = 0; i < 8 && depth > 0.0; ++i)
  {
    const IndentationPoint at = tool.evaluate(depth, modulus);
    const double next = depth - (at.force - force) / at.stiffness;
    depth = next > 0.0 ? next : 0.5 * depth;
  }
  return depth;
}
} // namespace

StrainShare strainShare(const AxisymmetricTool& tool, const StrainCorrection* strain,
  const ElasticMaterial& material, const SmallStrainContact& contact)
{
  const double modulus = reducedModulus(material.youngsModulus, material.poissonRatio);
  const double depth = depthUnder(tool, contact.force, contact.radius, modulus);
  const double alone = tool.stiffness(depth, modulus);
  const double local = contact.stiffness / alone;
  if (strain == nullptr)
  {
    const double pressure = contact.force / (Pi * contact.radius * contact.radius * modulus);
    return { 0.0, 0.0, local * smallStrainError(pressure, material.poissonRatio, 0.0, 0.0) };
  }
  const StrainFactor found = strain->at(depth, material.poissonRatio, 0.0);
  const double more = (found.factor - 1.0) * contact.force;
  return { more, (1.0 / contact.stiffness - 1.0 / alone) * more,
    local * found.error + StrainErrorFactor * std::abs((found.factor - 1.0) * (1.0 - local)) };
}
} // namespace palpate
