// SPDX-License-Identifier: BSD-3-Clause
#include "SpringMethods.h"

#include "Mechanics/Tools/ToolSpecification.h"
#include "TrackedMethod.h"

#include <numeric>

namespace palpate::testing
{
namespace
{
class OneSpring final : public TrackedMethod
{
public:
  OneSpring(const StudyBody& body, double stiffness)
    : TrackedMethod("one spring", body)
    , Stiffness(stiffness)
  {
  }

protected:
  double magnitude(const TouchedPlace& place) override { return this->Stiffness * place.depth; }
  std::size_t modelBytes() const override { return sizeof this->Stiffness; }

private:
  double Stiffness;
};

class PointSprings final : public TrackedMethod
{
public:
  PointSprings(const std::string& name, const StudyBody& body, const std::vector<double>& stiffness)
    : TrackedMethod(name, body)
    , Stiffness(body.inPackedOrder<float>(stiffness))
  {
  }

protected:
  double magnitude(const TouchedPlace& place) override
  {
    return place.blend(this->Stiffness) * place.depth;
  }
  std::size_t modelBytes() const override { return sizeof(float) * this->Stiffness.size(); }

private:
  std::vector<float> Stiffness;
};

/// The best stiffness at each point, ∫ F δ dδ / ∫ δ² dδ, with steps of √δ like those of the stored
/// curves.
std::vector<double> bestStiffness(const StudyBody& body, const StudyLaw& known)
{
  constexpr int samples = 32;
  const SampledCurves curves = known.sample(body.spots(), samples);
  std::vector<double> found;
  for (std::size_t p = 0; p < body.pointCount(); ++p)
  {
    double work = 0.0;
    double square = 0.0;
    for (int i = 0; i < samples; ++i)
    {
      const double root = (i + 1.0) / samples;
      const double depth = root * root * known.tool().range;
      const double weight = i + 1 < samples ? root : 0.5 * root; // trapezoids, dδ ∝ s ds
      work += weight * depth * curves.force[p * samples + static_cast<std::size_t>(i)];
      square += weight * depth * depth;
    }
    found.push_back(work / square);
  }
  return found;
}
} // namespace

std::unique_ptr<ContactMethod> oneSpring(const StudyBody& body, const StudyLaw& known)
{
  const std::vector<double> each = bestStiffness(body, known);
  const double sum = std::accumulate(each.begin(), each.end(), 0.0);
  return std::make_unique<OneSpring>(body, sum / static_cast<double>(each.size()));
}

std::unique_ptr<ContactMethod> pointSprings(
  const std::string& name, const StudyBody& body, const StudyLaw& known)
{
  return std::make_unique<PointSprings>(name, body, bestStiffness(body, known));
}

std::unique_ptr<ContactMethod> fixedPatch(const StudyBody& body, const StudyLaw& known)
{
  constexpr double pi = 3.14159265358979323846;
  const double modulus = known.material().reducedModulus;
  const double radius = known.tool().shape->contactRadius(0.5 * known.tool().range);
  const double onHalfSpace = 16.0 / (3.0 * pi * pi * modulus * radius);
  const double punch = 1.0 / (2.0 * modulus * radius);
  const StudyLaw flat(
    studyTool("flat:" + shortestDecimals(radius), known.tool().range), known.material());
  const SampledCurves curves =
    flat.sample(body.spots(), 2); // the law is linear, so two samples suffice
  std::vector<double> stiffness;
  for (std::size_t p = 0; p < body.pointCount(); ++p)
  {
    stiffness.push_back(1.0 / (onHalfSpace - punch + 1.0 / curves.stiffness[2 * p]));
  }
  return std::make_unique<PointSprings>("fixed-traction patch", body, stiffness);
}
} // namespace palpate::testing
