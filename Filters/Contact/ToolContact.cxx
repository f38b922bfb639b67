// SPDX-License-Identifier: BSD-3-Clause
#include "ToolContact.h"

#include <cmath>

namespace palpate
{
ToolContactForce ToolContact::update(const Vector3& tip) noexcept
{
  const ContactTracker::Contact contact = this->Tracker.update(tip);
  ToolContactForce result;
  switch (contact.outcome)
  {
    case ContactTracker::Outcome::Outside:
      break;
    case ContactTracker::Outcome::Border:
      result.state = ContactState::LostAtBorder;
      break;
    case ContactTracker::Outcome::Invalid:
      result.state = ContactState::Invalid;
      break;
    case ContactTracker::Outcome::Inside:
      result = this->blend(contact.surface);
      break;
  }
  return result;
}

ToolContactForce ToolContact::blend(const SurfacePoint& surface) const noexcept
{
  ToolContactForce result;
  result.state = ContactState::Slide;
  result.triangle = surface.triangle;
  result.contactPoint = surface.projection.point;
  result.deflection = -surface.signedDistance;
  Vector3 direction = Vector3::Zero();
  Vector3 paperForce = Vector3::Zero();
  const auto& corners = this->Body.surface.corners(surface.triangle);
  for (int k = 0; k < 3; ++k)
  {
    const double weight = surface.projection.weights[k];
    if (weight == 0.0)
    {
      continue; // on an edge, neither neighbour's opposite corner has a say
    }
    const std::int32_t corner = corners[static_cast<std::size_t>(k)];
    if (!this->Body.response.isValid(corner))
    {
      ToolContactForce invalid;
      invalid.state = ContactState::Invalid;
      return invalid;
    }
    const ResponseValue value = this->Body.response.evaluate(corner, result.deflection);
    const Vector3 normal = this->Body.response.normal(corner);
    result.normalForce += weight * value.force;
    result.stiffness += weight * value.stiffness;
    direction += weight * normal;
    paperForce += weight * value.force * normal;
    if (value.beyondRange)
    {
      result.state = ContactState::BeyondRange;
    }
  }
  if (this->Form == ForceForm::Paper)
  {
    result.normalForce = paperForce.norm();
    direction = result.normalForce > 0.0 ? paperForce : direction;
  }
  const double length = direction.norm();
  if (!(length > 0.0) || !std::isfinite(result.normalForce))
  {
    ToolContactForce invalid;
    invalid.state = ContactState::Invalid;
    return invalid;
  }
  result.normal = direction / length;
  result.force = result.normalForce * result.normal;
  return result;
}
} // namespace palpate
