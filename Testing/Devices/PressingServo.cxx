// SPDX-License-Identifier: BSD-3-Clause
#include "PressingServo.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

namespace palpate::testing
{
Eigen::Vector3d press(double seconds)
{
  constexpr double pi = 3.14159265358979323846;
  return { 5e-3, 5e-3, -0.2e-3 - 0.3e-3 * std::cos(2.0 * pi / PressPeriod * seconds) };
}

PressingServo::PressingServo(HidDevice& device, std::shared_ptr<const ContactBody> plate)
  : Device(device)
  , Step(std::make_unique<ServoScene>(std::move(plate), ContactSettings()), WorkspaceMapping(),
      SafetySettings::of(device.specification()))
{
}

bool PressingServo::tick()
{
  std::this_thread::sleep_until(this->Deadline);
  // Missed ticks are not repeated, so N ticks take at least N milliseconds.
  this->Deadline =
    std::max(this->Deadline, std::chrono::steady_clock::now()) + std::chrono::milliseconds(1);
  const bool reported = this->Device.errors().disconnections > this->Losses;
  const double time =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
  const Tick done = this->Step.step(this->Device.read(time), time);
  this->Device.holdFor(done.holdTime);
  this->Device.write(done.deviceForce);
  this->Force = done.deviceForce;
  this->LastReading = done.fresh ? time : this->LastReading;
  this->Silence = time - this->LastReading;
  return reported;
}

bool PressingServo::ticksUntilForce()
{
  for (int i = 0; i < PatientTicks; ++i)
  {
    this->tick();
    if (this->Force.norm() > 0.1)
    {
      return true;
    }
  }
  return false;
}
} // namespace palpate::testing
