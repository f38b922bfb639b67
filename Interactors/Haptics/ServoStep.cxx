// SPDX-License-Identifier: BSD-3-Clause
#include "ServoStep.h"

namespace palpate
{
ServoStep::ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
  const ContactSettings& settings)
  : Contact(body, settings)
  , Mapping(mapping)
  , MaximumForce(maximumForce > 0.0 ? maximumForce : 0.0)
{
}

ServoTick ServoStep::step(const DeviceSample& sample, double time) noexcept
{
  ServoTick tick;
  tick.time = time;
  if (!sample.valid || !sample.position.allFinite())
  {
    this->Contact.reset();
    tick.contact.state = ContactState::Invalid;
    return tick;
  }
  tick.tip = this->Mapping.toBody(sample.position);
  tick.contact = this->Contact.update(tick.tip);
  const double magnitude = tick.contact.force.norm();
  if (tick.contact.force.allFinite() && magnitude > 0.0)
  {
    const double share = magnitude > this->MaximumForce ? this->MaximumForce / magnitude : 1.0;
    tick.deviceForce = this->Mapping.forceToDevice(share * tick.contact.force);
  }
  return tick;
}
} // namespace palpate
