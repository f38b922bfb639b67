// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/TermEffect.h"

#include "Laws/BodyMaterial.h"
#include "Laws/ErrorRule.h"
#include "Laws/ResponseLaw.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/SeriesCompliance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::size_t MostPoints = 400;
// Square roots of the compared depths, as fractions of the range.
constexpr std::array<double, 4> Roots = { 0.25, 0.5, 0.75, 1.0 };
// Number of samples of laws that are not stored with the response.
constexpr int UnstoredSamples = 8;

/// Computes the forces of one model of the body.
class ModelledForce
{
public:
  ModelledForce(const PressedBody& body, const LawModel& model)
    : Body(body)
    , Spots(model.material.spots())
    , HasCurvature(model.curvature)
    , Prepared(prepareLaw(
        body.tool, body.range, UnstoredSamples, model.material.range(), true, model.strain))
  {
  }

  ContactSpot spot(std::size_t i) const
  {
    ContactSpot spot = this->Spots.at(i);
    spot.curvature = this->HasCurvature ? this->Body.shape.curvature(i) : SpotCurvature{};
    return spot;
  }
  /// Returns the force, N; NaN if the spot has no force at this depth.
  double at(const ContactSpot& spot, double depth) const
  {
    return this->Prepared.law.evaluate(spot, depth).force;
  }
  const LocalContact& contact() const { return *this->Prepared.contact; }

private:
  const PressedBody& Body;
  ContactSpots Spots;
  bool HasCurvature;
  PreparedLaw Prepared;
};

/// Returns the smallest value that `change(i)` does not exceed at a fraction `share` of the points.
/// Negative changes are ignored.
template <class Change>
double quantile(const PressedBody& body, const Change& change)
{
  const std::size_t looked = std::min(body.points, MostPoints);
  std::vector<double> changes;
  changes.reserve(looked);
  for (std::size_t k = 0; k < looked; ++k)
  {
    const std::size_t i = body.points * k / looked;
    const double found = body.shape.bound(i) < 0.0 ? -1.0 : change(i);
    if (!(found < 0.0))
    {
      changes.push_back(std::isnan(found) ? Infinity : found);
    }
  }
  if (changes.empty())
  {
    return 0.0;
  }
  std::sort(changes.begin(), changes.end());
  const double rank = std::ceil(body.share * static_cast<double>(changes.size()));
  return changes[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}
} // namespace

double changeOfForce(const PressedBody& body, const LawModel& whole, const LawModel& less)
{
  const ModelledForce reference(body, whole);
  const ModelledForce other(body, less);
  return quantile(body,
    [&](std::size_t i)
    {
      const ContactSpot there = reference.spot(i);
      const ContactSpot here = other.spot(i);
      double largest = -1.0;
      for (const double root : Roots)
      {
        const double depth = body.range * root * root;
        const double right = reference.at(there, depth);
        if (!std::isnan(right))
        {
          const double change = std::abs(other.at(here, depth) / right - 1.0);
          largest = std::isnan(change) ? Infinity : std::max(largest, change);
        }
      }
      return largest;
    });
}

double boundOfStrain(const PressedBody& body, const LawModel& model)
{
  const ModelledForce force(body, model);
  const MaterialRange& range = model.material.range();
  const ErrorRule rule(body.tool,
    { model.curvature, nullptr, Infinity, 0.0, range.hasStack() ? &range.stack : nullptr });
  return quantile(body,
    [&](std::size_t i)
    {
      const ContactSpot spot = force.spot(i);
      if (!force.contact().answers(spot))
      {
        return -1.0;
      }
      const NodeLaw local = force.contact().law(spot);
      double largest = -1.0;
      for (const double root : Roots)
      {
        const double depth = body.range * root * root;
        const double own = spot.compliance == 0.0
          ? depth
          : seriesResponse(local, spot.reducedModulus, spot.compliance, depth).localDeflection;
        ErrorParts parts = rule.at(spot, {}, local.at(own));
        largest = std::max(largest, parts[ResponseLimit::Strain] + parts[ResponseLimit::Thickness]);
      }
      return largest;
    });
}
} // namespace palpate
