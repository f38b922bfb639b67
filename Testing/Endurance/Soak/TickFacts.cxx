// SPDX-License-Identifier: BSD-3-Clause
#include "TickFacts.h"

#include "Haptics/Servo/ServoStep.h"

namespace palpate::endurance
{
TickFacts factsOf(double time, const DeviceSample& sample, const Vector3& sent, const Tick& tick)
{
  TickFacts facts;
  facts.time = time;
  facts.sample = sample;
  facts.sent = sent;
  facts.scene = tick.scene;
  facts.sceneShare = tick.sceneShare;
  facts.tip = tick.tip;
  facts.contactForce = tick.contact.force;
  facts.idealForce = tick.idealForce;
  facts.saidSent = tick.deviceForce;
  facts.isPassivityLimited = (tick.acted & static_cast<unsigned>(SafetyLink::Passivity)) != 0;
  return facts;
}
} // namespace palpate::endurance
