// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ValidityRule.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Numerics/Constants.h"
#include "Laws/ResponseLaw.h"

#include <cmath>

namespace palpate
{
namespace
{
// Ratio of contact radius to tool radius, a/R, at which validity ends. It corresponds to about 8 %
// strain (Tabor's 0.2 a/R).
constexpr double StrainRatio = 0.4;
// Largest angle by which the body's normal may change over the contact radius, rad.
constexpr double NormalTurn = 0.2;
// Largest compression of a layer relative to its thickness. At this compression, the force from
// finite elements with finite strain (Data/Studies/calculix, nu = 0.45) is 4 % above that of the
// linear layer; at 0.4 it is 10 % above.
constexpr double Compression = 0.2;
} // namespace

ValidityRule::ValidityRule(
  const AxisymmetricTool& tool, const ResponseLaw& law, double range, double bodyWidth)
  : Tool(tool)
  , Law(law)
  , Range(range)
  , StrainDepth(tool.depthAtStrain(StrainRatio))
  , StrainRadius(std::isfinite(this->StrainDepth) ? tool.contactRadius(this->StrainDepth) : 0.0)
  , HalfWidth(0.5 * bodyWidth)
  , WidthDepth(tool.depthAtContactRadius(this->HalfWidth))
{
}

ValidityRule::Answer ValidityRule::at(const ContactSpot& spot, double curvature) const
{
  Answer first{ Infinity, ResponseLimit::None };
  const auto consider = [&first](double depth, ResponseLimit limit)
  {
    if (depth < first.depth)
    {
      first = { depth, limit };
    }
  };
  const bool layer = spot.thickness > 0.0;
  // A flat end has its full contact radius at any depth. Therefore its strain depends only on the
  // depth.
  const bool widens = this->StrainRadius > this->Tool.smallestContactRadius();
  consider(layer && widens ? this->Law.deflectionAtContactRadius(spot, this->StrainRadius)
                           : this->Law.totalDeflection(spot, this->StrainDepth),
    ResponseLimit::Strain);
  if (curvature > 0.0)
  {
    consider(
      this->Law.deflectionAtContactRadius(spot, NormalTurn / curvature), ResponseLimit::Curvature);
  }
  if (!(widens && this->StrainRadius < this->HalfWidth))
  {
    consider(layer ? this->Law.deflectionAtContactRadius(spot, this->HalfWidth)
                   : this->Law.totalDeflection(spot, this->WidthDepth),
      ResponseLimit::Edge);
  }
  if (layer)
  {
    const double thinnest = spot.thinnest > 0.0 ? spot.thinnest : spot.thickness;
    consider(this->Law.totalDeflection(spot, Compression * thinnest), ResponseLimit::Thickness);
  }
  return first.depth < this->Range ? first : Answer{ this->Range, ResponseLimit::None };
}
} // namespace palpate
