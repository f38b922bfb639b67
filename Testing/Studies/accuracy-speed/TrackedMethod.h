// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "Contact/ContactTracker.h"
#include "StudyBody.h"

#include <memory>
#include <string>
#include <utility>

namespace palpate::testing
{
/// The contact of a tip with the facets of a body.
struct TouchedPlace
{
  TriangleCorners corners{};         ///< point numbers in packed order
  Vector3 weights = Vector3::Zero(); ///< area coordinates
  double depth = 0.0;                ///< mm
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); ///< blended from the points' normals, unit

  /// Σ weight · value.
  template <class Values>
  double blend(const Values& values) const
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum += weights[static_cast<Eigen::Index>(k)] *
        static_cast<double>(values[static_cast<std::size_t>(corners[k])]);
    }
    return sum;
  }
};

/// A method that tracks the contact as Palpate does, so that methods differ only in the force.
class TrackedMethod : public ContactMethod
{
public:
  TrackedMethod(std::string name, const StudyBody& body)
    : Body(body)
    , Name(std::move(name))
    , Tracker(body.contact().surface, body.contact().tree)
  {
  }

  std::string name() const override { return this->Name; }
  Vector3 force(const Vector3& tip) override
  {
    const ContactTracker::Result contact = this->Tracker.update(tip);
    if (contact.outcome != ContactTracker::Outcome::Inside)
    {
      return Vector3::Zero();
    }
    TouchedPlace place;
    place.corners = this->Body.packed().corners(contact.place.triangle);
    place.weights = contact.place.projection.weights;
    place.depth = -contact.place.signedDistance;
    place.point = contact.place.projection.point;
    for (std::size_t k = 0; k < 3; ++k)
    {
      place.normal += place.weights[static_cast<Eigen::Index>(k)] *
        this->Body.packed().pointNormal(place.corners[k]);
    }
    place.normal.normalize();
    return this->magnitude(place) * place.normal;
  }
  void forget() override { this->Tracker.reset(); }
  std::size_t bytes() const override { return this->Body.meshBytes() + this->modelBytes(); }

protected:
  /// Magnitude of the force, N.
  virtual double magnitude(const TouchedPlace& place) = 0;
  /// Bytes in addition to the mesh.
  virtual std::size_t modelBytes() const = 0;

  const StudyBody& Body;

private:
  std::string Name;
  ContactTracker Tracker;
};
} // namespace palpate::testing
