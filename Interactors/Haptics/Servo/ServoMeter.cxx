// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoMeter.h"

namespace palpate
{
void ServoMeter::read(ServoStatistics& statistics) const noexcept
{
  statistics.ticks = this->ticks.read();
  statistics.missed = this->missed.read();
  statistics.invalidSamples = this->invalidSamples.read();
  statistics.repeatedSamples = this->repeatedSamples.read();
  statistics.refusedForces = this->refusedForces.read();
  statistics.sceneChanges = this->sceneChanges.read();
  statistics.period = this->period.read();
  statistics.wakeUp = this->wakeUp.read();
  statistics.tick = this->tick.read();
}

void ServoMeter::reset() noexcept
{
  for (EventCount* const count : { &this->ticks, &this->missed, &this->invalidSamples,
         &this->repeatedSamples, &this->refusedForces, &this->sceneChanges })
  {
    count->reset();
  }
  for (LatencyHistogram* const times : { &this->period, &this->wakeUp, &this->tick })
  {
    times->reset();
  }
}
} // namespace palpate
