// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/SessionDevice.h"

#include "Haptics/Devices/DeviceTransports.h"
#include "Haptics/Devices/TrajectoryFile.h"

#include <limits>
#include <utility>

namespace palpate
{
namespace
{
std::string openReplay(const std::string& file, SessionDevice& device)
{
  SessionDevice opened;
  opened.kind = SessionDevice::Replay;
  const std::string error = readTrajectory(file, opened.trajectory);
  if (!error.empty() || opened.trajectory.rows.empty())
  {
    return error;
  }
  // A recording that starts in the middle of a session is replayed from its first row.
  const double begin = opened.trajectory.rows.front().time;
  for (TrajectoryRow& row : opened.trajectory.rows)
  {
    row.time -= begin;
  }
  opened.trajectory.setups.shift(begin);
  device = std::move(opened);
  return {};
}

std::string use(
  std::unique_ptr<HapticDevice> opened, const std::string& error, SessionDevice& device)
{
  if (!opened)
  {
    return error;
  }
  device = { SessionDevice::Opened, std::move(opened), {}, {} };
  return {};
}
} // namespace

std::string openSessionDevice(const std::string& name, SessionDevice& device)
{
  if (name == "simulated")
  {
    device = {};
    return {};
  }
  const std::size_t colon = name.find(':');
  const std::string kind = name.substr(0, colon);
  const std::string rest = colon == std::string::npos ? std::string() : name.substr(colon + 1);
  std::string error;
  if (kind == "plant" && (colon == std::string::npos || !rest.empty()))
  {
    SessionDevice made{ SessionDevice::Plant, nullptr, {}, {} };
    error = readPlant(rest, made.held);
    if (error.empty())
    {
      device = std::move(made);
    }
    return error;
  }
  if (kind == "replay" && !rest.empty())
  {
    return openReplay(rest, device);
  }
  if (isTransported(name))
  {
    auto opened = openTransported(name, error);
    return use(std::move(opened), error, device);
  }
  return "is none of \"simulated\", \"plant:SETTINGS\", \"replay:FILE\", \"hid:PATH\", "
         "\"bridge:ADDRESS\"";
}

DeviceSpecification SessionDevice::specification(double rate) const
{
  if (this->device)
  {
    return this->device->specification();
  }
  if (this->kind == Plant)
  {
    return specificationOf(this->held.plant, rate);
  }
  DeviceSpecification hand; // a stiff hand has no limit of the stiffness and no time-out
  hand.maximumStiffness = std::numeric_limits<double>::infinity();
  hand.maximumDamping = std::numeric_limits<double>::infinity();
  hand.sampleTimeOut = std::numeric_limits<double>::infinity();
  hand.outputsForce = false;
  return hand;
}
} // namespace palpate
