// SPDX-License-Identifier: BSD-3-Clause
#include "LawMethods.h"

#include "Mechanics/Tools/ConeTool.h"
#include "Mechanics/Tools/FlatTool.h"
#include "Contact/ContactTracker.h"
#include "Mechanics/Tools/SphereTool.h"
#include "TrackedMethod.h"

#include <cmath>
#include <utility>
#include <vector>

namespace palpate::testing
{
namespace
{
/// The force F = c E* δ^m of Table 1, with m = 1, 3/2 or 2.
class TableOne final : public TrackedMethod
{
public:
  TableOne(const StudyBody& body, const StudyLaw& law, double factor, double exponent)
    : TrackedMethod("Table 1 at run time", body)
    , Modulus(body.pointCount(), static_cast<float>(law.material().reducedModulus))
    , Factor(factor)
    , Exponent(exponent)
  {
  }

protected:
  double magnitude(const TouchedPlace& place) override
  {
    const double power = this->Exponent == 1.0 ? 1.0
      : this->Exponent == 1.5                  ? std::sqrt(place.depth)
                                               : place.depth;
    return this->Factor * place.blend(this->Modulus) * place.depth * power;
  }
  std::size_t modelBytes() const override { return sizeof(float) * this->Modulus.size(); }

private:
  std::vector<float> Modulus; ///< modulus at each point
  double Factor;
  double Exponent;
};

std::vector<double> inverseThicknesses(const StudyBody& body)
{
  std::vector<double> values;
  for (const Spot& spot : body.spots())
  {
    values.push_back(spot.inverseThickness);
  }
  return values;
}

class ExactLaw final : public TrackedMethod
{
public:
  ExactLaw(const StudyBody& body, const StudyLaw& law)
    : TrackedMethod("exact law at run time", body)
    , Law(law.tool(), law.material())
    , InverseThickness(body.inPackedOrder<float>(inverseThicknesses(body)))
  {
  }

protected:
  double magnitude(const TouchedPlace& place) override
  {
    return this->Law.evaluate({ place.blend(this->InverseThickness), 0.0 }, place.depth).force;
  }
  std::size_t modelBytes() const override { return sizeof(float) * this->InverseThickness.size(); }

private:
  StudyLaw Law;
  std::vector<float> InverseThickness;
};

class ExactReference final : public ContactMethod
{
public:
  ExactReference(const StudyBody& body, const StudyLaw& law)
    : Body(body)
    , Law(law.tool(), law.material())
    , Tracker(body.contact().surface, body.contact().tree, body.contact().response)
  {
  }
  std::string name() const override { return "reference"; }
  Vector3 force(const Vector3& tip) override
  {
    const ContactTracker::Result contact = this->Tracker.update(tip);
    if (contact.outcome != ContactTracker::Outcome::Inside)
    {
      return Vector3::Zero();
    }
    const ContactPlace& place = contact.place;
    const Spot spot =
      this->Body.spotAt(this->Body.packed().corners(place.triangle), place.projection.weights);
    return this->Law.evaluate(spot, -place.signedDistance).force * place.normal;
  }
  void forget() override { this->Tracker.reset(); }
  std::size_t bytes() const override { return this->Body.meshBytes(); }

private:
  const StudyBody& Body;
  StudyLaw Law;
  ContactTracker Tracker;
};

class BallReference final : public ContactMethod
{
public:
  BallReference(double radius, const StudyLaw& law)
    : Radius(radius)
    , Law(law.tool(), law.material())
  {
  }
  std::string name() const override { return "reference"; }
  Vector3 force(const Vector3& tip) override
  {
    return this->Law.evaluate({}, this->Radius - tip.norm()).force * tip.normalized();
  }
  std::size_t bytes() const override { return 0; }

private:
  double Radius;
  StudyLaw Law;
};
class PlaneReference final : public ContactMethod
{
public:
  PlaneReference(SpotMap spotAt, const StudyLaw& law)
    : SpotAt(std::move(spotAt))
    , Law(law.tool(), law.material())
  {
  }
  std::string name() const override { return "reference"; }
  Vector3 force(const Vector3& tip) override
  {
    return this->Law.evaluate(this->SpotAt(tip.x(), tip.y()), -tip.z()).force * Vector3::UnitZ();
  }
  std::size_t bytes() const override { return 0; }

private:
  SpotMap SpotAt;
  StudyLaw Law;
};
} // namespace

std::unique_ptr<ContactMethod> tableOne(const StudyBody& body, const StudyLaw& law)
{
  const AxisymmetricTool& tool = *law.tool().shape;
  if (dynamic_cast<const SphereTool*>(&tool) != nullptr)
  {
    const double radius = tool.largestContactRadius();
    return std::make_unique<TableOne>(body, law, 4.0 / 3.0 * std::sqrt(radius), 1.5);
  }
  if (dynamic_cast<const FlatTool*>(&tool) != nullptr)
  {
    return std::make_unique<TableOne>(body, law, 2.0 * tool.smallestContactRadius(), 1.0);
  }
  if (dynamic_cast<const ConeTool*>(&tool) != nullptr)
  {
    constexpr double pi = 3.14159265358979323846;
    const double tangent = 1.0 / tool.profile(1.0); // f = r cot α
    return std::make_unique<TableOne>(body, law, 2.0 / pi * tangent, 2.0);
  }
  return nullptr;
}

std::unique_ptr<ContactMethod> exactLaw(const StudyBody& body, const StudyLaw& law)
{
  return std::make_unique<ExactLaw>(body, law);
}

std::unique_ptr<ContactMethod> exactReference(const StudyBody& body, const StudyLaw& law)
{
  return std::make_unique<ExactReference>(body, law);
}

std::unique_ptr<ContactMethod> ballReference(double radius, const StudyLaw& law)
{
  return std::make_unique<BallReference>(radius, law);
}

std::unique_ptr<ContactMethod> planeReference(SpotMap spotAt, const StudyLaw& law)
{
  return std::make_unique<PlaneReference>(std::move(spotAt), law);
}
} // namespace palpate::testing
