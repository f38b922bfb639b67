// SPDX-License-Identifier: BSD-3-Clause
#include "PulledPlug.h"

#include "Firmware.h"
#include "PressingServo.h"

#include <cstdio>
#include <thread>

namespace palpate::testing
{
namespace
{
using Clock = std::chrono::steady_clock;

std::string forceFault(const Eigen::Vector3d& force, int tick)
{
  char text[96];
  std::snprintf(
    text, sizeof text, "%g N in tick %d after the report of the loss", force.norm(), tick);
  return text;
}

/// Runs ticks until the loss is reported, and then twenty more. Returns the fault, or "".
std::string watchLoss(PressingServo& servo, Clock::time_point& gone)
{
  int ticks = 0;
  while (!servo.tick())
  {
    if (++ticks == PatientTicks)
    {
      return "the loss is never reported";
    }
  }
  gone = Clock::now();
  std::string fault;
  for (int i = 1; i <= 21 && fault.empty(); ++i)
  {
    fault = servo.force() == Eigen::Vector3d::Zero() ? "" : forceFault(servo.force(), i);
    servo.tick();
  }
  return fault;
}
} // namespace

PulledPlug pullPlug(const std::shared_ptr<const ContactBody>& plate, const PullMoment& moment)
{
  PulledPlug result;
  EmulatedHid hid(modelOf(describedDevice()));
  const auto device = HidDevice::open(hid.path(), result.fault);
  if (!device)
  {
    return result;
  }
  Firmware firmware(hid, [phase = moment.phase](double seconds) { return press(seconds + phase); });
  PressingServo servo(*device, plate);
  if (!servo.ticksUntilForce())
  {
    result.fault = "the plate is not felt: " + device->status();
    return result;
  }
  Clock::time_point pulled;
  std::thread hand(
    [&]
    {
      std::this_thread::sleep_for(moment.wait);
      result.motors = firmware.motors().norm();
      pulled = Clock::now();
      hid.unplug();
    });
  Clock::time_point gone;
  result.fault = watchLoss(servo, gone);
  hand.join();
  result.wall = std::chrono::duration<double, std::milli>(gone - pulled).count();
  if (result.fault.empty() && device->status().rfind("connected", 0) == 0)
  {
    result.fault = "it calls itself connected";
  }
  return result;
}
} // namespace palpate::testing
