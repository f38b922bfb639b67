// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ErrorRule.h"

#include "Mechanics/FiniteStrain/SmallStrainError.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
// Factor on the mean over the layers. With this factor the result bounds all errors of 30 random
// forces.
constexpr double StackBound = 1.6;
// Errors relative to the loss of force at an edge for which the tick makes a correction. Hetényi's
// law is accurate to 3 %, and the effect of a base to 10 %. A corner is approximated by a product
// of the factors of its edges. For angles other than a right angle edgeSharpness is up to 1.4 times
// too large.
constexpr double EdgeRemainder = 0.2;
constexpr double WedgeRemainder = 0.4;
constexpr double RightAngle = 0.5 * Pi;
constexpr double AngleTolerance = 0.09; // rad (5°)
constexpr double BorderReach = 2.0; // distance in contact radii beyond which a border has no effect

/// The reduction of the global compliance of a body with mean curvature κ, compared with a
/// half-space, divided by a |κ|: 2 |C_g E* R_b|. From finite elements of spheres and cavities.
double wholeCompliance(double radius, double meanCurvature, double poissonRatio)
{
  // C_g E* R_b is -0.19 to -0.23 at ν = 0.45. Its magnitude is smaller for a compressible body.
  constexpr double ball = 0.46;
  if (!(meanCurvature < 0.0))
  {
    return ball;
  }
  const double n = 1.0 - 2.0 * poissonRatio;
  const double logarithm = std::max(0.0, -std::log(radius * std::abs(meanCurvature)));
  return ball + 0.975 * n + 0.32 * n * n * logarithm;
}

/// Effects of the curvature on the force of a contact, relative to that force.
struct CurvatureEffect
{
  double perCurvature; ///< first-order effect per unit curvature, mm
  double sag;
  double structural;
};

CurvatureEffect effectOf(
  const ContactSpot& spot, const SpotCurvature& curvature, const LocalState& state)
{
  const double a = state.radius;
  const double mean = std::abs(curvature.mean());
  const double perCurvature = 2.0 / 3.0 * a * a * a / state.force;
  const double first = perCurvature * mean;
  // In a hollow the second-order term increases the effect: for a sphere 1/√(1-2x) - 1 = x + 3/2
  // x².
  return { perCurvature, curvature.mean() < 0.0 ? first * (1.0 + 2.0 * first) : first,
    spot.compliance == 0.0 ? wholeCompliance(a, curvature.mean(), spot.poissonRatio) * a * mean
                           : 0.0 };
}
} // namespace

double ErrorParts::total() const
{
  return std::accumulate(this->of.begin(), this->of.end(), 0.0);
}

double ErrorParts::norm() const
{
  return Eigen::Map<const Eigen::VectorXd>(this->of.data(), ResponseLimitCount).norm();
}

ResponseLimit ErrorParts::largest() const
{
  return static_cast<ResponseLimit>(
    std::max_element(this->of.begin(), this->of.end()) - this->of.begin());
}

ErrorRule::ErrorRule(const AxisymmetricTool& tool, const LawScope& scope)
  : Tool(tool)
  , Scope(scope)
{
}

StrainCorrection::Course ErrorRule::strain(const ContactSpot& spot) const
{
  return this->Scope.strain
    ? this->Scope.strain->course(spot.poissonRatio, spot.thickness, spot.second)
    : StrainCorrection::Course();
}

ErrorParts ErrorRule::at(const ContactSpot& spot, const SpotSurface& surface,
  const StrainCorrection::Course& strain, const LocalState& state, double thickness) const
{
  ErrorParts parts;
  this->addStrain(spot, strain, state, parts);
  parts[ResponseLimit::Curvature] = this->curvaturePart(spot, surface, state);
  parts[ResponseLimit::Edge] = this->edgePart(spot, surface.edge, state);
  if (surface.measured)
  {
    ErrorParts then;
    this->addStrain(spot, strain, *surface.measured, then);
    double& bound = parts[parts[ResponseLimit::Thickness] > 0.0 ? ResponseLimit::Thickness
                                                                : ResponseLimit::Strain];
    bound = std::max(bound, then.total());
    double& edge = parts[ResponseLimit::Edge];
    edge =
      edge < 1.0 ? std::abs(edge - this->edgePart(spot, surface.edge, *surface.measured)) : edge;
  }
  parts[ResponseLimit::Thickness] += thickness;
  const double local = 1.0 / (1.0 + spot.compliance * spot.reducedModulus * state.stiffness);
  for (double& part : parts.of)
  {
    part *= std::abs(local);
  }
  parts[ResponseLimit::Elements] =
    std::abs(local) * spot.complianceError * spot.reducedModulus * state.stiffness;
  parts[ResponseLimit::None] = this->Scope.storage;
  return parts;
}

void ErrorRule::addStrain(const ContactSpot& spot, const StrainCorrection::Course& strain,
  const LocalState& state, ErrorParts& parts) const
{
  if (this->Scope.strain)
  {
    parts[ResponseLimit::Strain] = strain.at(state.depth).error;
    return;
  }
  const double pressure = state.force / (Pi * state.radius * state.radius);
  if (this->Scope.stack)
  {
    parts[ResponseLimit::Thickness] = this->stackPart(spot, state);
    return;
  }
  const bool layer = spot.thickness > 0.0;
  const double flat = smallStrainError(pressure, spot.poissonRatio, 0.0, 0.0);
  if (!layer)
  {
    parts[ResponseLimit::Strain] = flat;
    return;
  }
  const double whole = smallStrainError(
    pressure, spot.poissonRatio, state.depth / spot.thickness, state.radius / spot.thickness);
  parts[whole > 2.0 * flat ? ResponseLimit::Thickness : ResponseLimit::Strain] = whole;
}

double ErrorRule::stackPart(const ContactSpot& spot, const LocalState& state) const
{
  const double a = state.radius;
  struct Part
  {
    double share;    // fraction of the depth, before normalization
    double pressure; // pressure on the layer divided by its E*
    double ratio;
    double thickness; // mm; 0 if it is infinite
  };
  std::array<Part, LayerStack::MostLayers + 1> parts;
  std::size_t count = 0;
  const auto modulusOf = [](const StackLayer& layer)
  { return reducedModulus(layer.youngsModulus, layer.poissonRatio); };
  const double first = modulusOf(this->Scope.stack->layers.front());
  double above = 0.0; // depth of the layer's top below the surface, mm
  // Below the centre of a uniform pressure on a circle, the stress is the pressure times 1 -
  // (z/√(a²+z²))³. This function is the integral of this factor over z.
  const auto taken = [a](double z)
  {
    const double slant = std::hypot(a, z);
    return z - slant - a * a / slant + 2.0 * a;
  };
  double whole = 0.0;
  const auto consider = [&](const StackLayer& layer, double thickness)
  {
    const double softness = first / modulusOf(layer);
    const bool isEndless = !(thickness > 0.0);
    const double share =
      softness * ((isEndless ? 2.0 * a : taken(above + thickness)) - taken(above));
    const double reaches = 1.0 - std::pow(above / std::hypot(a, above), 3.0);
    parts[count++] = { share, reaches * state.force / (Pi * a * a) * softness, layer.poissonRatio,
      isEndless ? 0.0 : thickness };
    whole += share;
    above += thickness;
  };
  for (std::size_t i = 0; i < this->Scope.stack->layers.size(); ++i)
  {
    const StackLayer& layer = this->Scope.stack->layers[i];
    consider(layer, i == 0 ? spot.thickness : i == 1 ? spot.second : layer.thickness);
  }
  if (this->Scope.stack->hasHalfSpace)
  {
    consider(this->Scope.stack->halfSpace, 0.0);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Part& part = parts[i];
    const double share = part.share / whole;
    const double h = part.thickness;
    sum += share *
      smallStrainError(
        part.pressure, part.ratio, h > 0.0 ? share * state.depth / h : 0.0, h > 0.0 ? a / h : 0.0);
  }
  return StackBound * sum;
}

double ErrorRule::curvaturePart(
  const ContactSpot& spot, const SpotSurface& surface, const LocalState& state) const
{
  const double a = state.radius;
  const SpotCurvature& curvature = surface.curvature;
  CurvatureEffect effect = effectOf(spot, curvature, state);
  if (surface.measured)
  {
    const CurvatureEffect then = effectOf(spot, curvature, *surface.measured);
    effect = { std::abs(effect.perCurvature - then.perCurvature), std::abs(effect.sag - then.sag),
      std::abs(effect.structural - then.structural) };
  }
  const double toolDepth =
    state.toolDepth < 0.0 ? this->Tool.depthAtContactRadius(a) : state.toolDepth;
  const double toolCurvature = toolDepth / (a * a);
  // In full contact the law of a flat end depends only on the mean curvature. Before full contact
  // no law is valid in a hollow.
  const double end = this->Tool.smallestContactRadius();
  const bool isWhole = end > 0.0 && a > 0.99 * end;
  const double ellipse = curvature.isFlat()   ? 0.0
    : !isWhole                                ? ellipseFactor(toolCurvature, curvature)
    : state.depth < wholeFrom(end, curvature) ? 1.0
                                              : 0.0;
  const double leftOut = this->Scope.curvature ? 0.0 : effect.sag;
  const double both = leftOut * effect.structural; // product of both effects
  return std::min(
    1.0, leftOut + ellipse + effect.structural + both + effect.perCurvature * curvature.error);
}

double ErrorRule::edgePart(
  const ContactSpot& spot, const NearEdge& edge, const LocalState& state) const
{
  const double a = state.radius;
  if (2.0 * a > this->Scope.bodyWidth)
  {
    return 1.0;
  }
  if (spot.compliance != 0.0)
  {
    return 0.0;
  }
  const auto part = [&](float away, double sharpness)
  {
    const auto distance = static_cast<double>(away);
    const double base = spot.thickness > 0.0 ? std::exp(-distance / spot.thickness) : 1.0;
    return base * (1.0 - edgeFactor(spot.poissonRatio, distance / a, sharpness));
  };
  double sum = 0.0;
  if (edge.distance < NearEdge::Far)
  {
    const double turn{ edge.turn };
    const double missing = this->Scope.edges && edge.isSharp
      ? (std::abs(turn - RightAngle) < AngleTolerance ? EdgeRemainder : WedgeRemainder)
      : 1.0;
    sum += missing * part(edge.distance, edgeSharpness(spot.poissonRatio, turn));
  }
  const double inside = static_cast<double>(edge.border) / (BorderReach * a);
  if (inside < 1.0)
  {
    constexpr double rightAngle = 1.0;
    sum += (1.0 - inside) * part(edge.border, rightAngle);
  }
  return std::min(1.0, sum);
}
} // namespace palpate
