// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Hid/SpaceMouseDevice.h"

#include "Transports/DeviceList.h"
#include "Haptics/Servo/LatestValue.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t LongestReport = 64;
/// Longest time step, s. A longer step is a pause of the loop, during which the tip does not move.
constexpr double LongestStep = 0.02;

struct NumberedAxes
{
  SpaceMouseState state;
  std::uint64_t number = 0; ///< numbers of the reports are 1, 2, 3, …
};

/// Returns 0 within the dead zone. Outside the dead zone the result grows linearly up to ±1.
double beyondDeadZone(double value, double deadZone) noexcept
{
  const double beyond = std::max(0.0, std::abs(value) - deadZone) / (1.0 - deadZone);
  return std::copysign(std::min(1.0, beyond), value);
}

DeviceSpecification inputOnly(const SpaceMouseSettings& settings)
{
  DeviceSpecification specification;
  specification.outputsForce = false;
  specification.maximumForce = 0.0;
  specification.workspace.setConstant(settings.halfExtent);
  specification.rate = 125.0;
  specification.sampleTimeOut = std::numeric_limits<double>::infinity();
  return specification;
}
} // namespace

/// The listener of the reader thread, and the data that it shares with the tick.
class SpaceMouseDevice::Link final : public HidListener
{
public:
  std::string returned(HidPort&, const HidEntry&) override
  {
    this->State = {}; // the cap is assumed to be at rest until a report arrives
    this->publish();
    return {};
  }

  void received(const std::uint8_t* report, std::size_t size) noexcept override
  {
    if (takeSpaceMouseReport(report, size, this->State))
    {
      this->publish();
    }
    else
    {
      this->Malformed.fetch_add(1, std::memory_order_relaxed);
    }
  }

  void lost() noexcept override { this->Alive.store(false, std::memory_order_release); }

  LatestValue<NumberedAxes> States; ///< from the reader thread to the tick
  std::atomic<bool> Alive{ true };  ///< initially true, because the device sends no reports at rest
  std::atomic<std::uint64_t> Malformed{ 0 };

private:
  void publish() noexcept
  {
    this->States.write({ this->State, ++this->Number });
    this->Alive.store(true, std::memory_order_release);
  }

  SpaceMouseState State;
  std::uint64_t Number = 0;
};

std::unique_ptr<SpaceMouseDevice> SpaceMouseDevice::open(const std::string& path,
  SpaceMouseMode mode, std::string& error, HidBus& bus, const SpaceMouseSettings& settings)
{
  std::unique_ptr<HidPort> port = bus.open(path, error);
  if (!port)
  {
    return nullptr;
  }
  return std::unique_ptr<SpaceMouseDevice>(
    new SpaceMouseDevice(bus, entryAt(bus, path), std::move(port), mode, settings));
}

SpaceMouseDevice::SpaceMouseDevice(HidBus& bus, const HidEntry& entry,
  std::unique_ptr<HidPort> port, SpaceMouseMode mode, const SpaceMouseSettings& settings)
  : Mode(mode)
  , Settings(settings)
  , Limits(inputOnly(settings))
  , Connection(std::make_shared<Link>())
  , Reader(
      std::make_unique<HidReader>(bus, entry, std::move(port), this->Connection, LongestReport))
{
}

SpaceMouseDevice::~SpaceMouseDevice() = default;

DeviceSample SpaceMouseDevice::read(double time) noexcept
{
  DeviceSample sample;
  const bool alive = this->Connection->Alive.load(std::memory_order_acquire);
  const double elapsed = time - this->LastTime; // NaN in the first tick
  this->LastTime = time;
  if (alive && std::isfinite(time))
  {
    const Eigen::Vector3d push = this->pushed(time);
    if (elapsed > 0.0)
    {
      this->move(push, std::min(elapsed, LongestStep));
    }
  }
  else
  {
    this->Velocity.setZero();
  }
  sample.position = this->Position;
  sample.velocity = this->Velocity;
  sample.buttons = this->Connection->States.read().state.buttons;
  sample.valid = alive && std::isfinite(time);
  return sample;
}

Eigen::Vector3d SpaceMouseDevice::pushed(double time) noexcept
{
  const NumberedAxes& state = this->Connection->States.read();
  if (state.number != this->Seen)
  {
    this->Seen = state.number;
    this->SeenTime = time;
  }
  const bool silent = time - this->SeenTime > this->Settings.longestSilence;
  if (silent && this->Mode == SpaceMouseMode::Rate)
  {
    return Eigen::Vector3d::Zero();
  }
  return state.state.push.unaryExpr(
    [this](double value) { return beyondDeadZone(value, this->Settings.deadZone); });
}

void SpaceMouseDevice::move(const Eigen::Vector3d& push, double elapsed) noexcept
{
  const double reach = this->Settings.halfExtent;
  const double share = 1.0 - std::exp(-elapsed / this->Settings.filterTime);
  const Eigen::Vector3d before = this->Position;
  if (this->Mode == SpaceMouseMode::Rate)
  {
    this->Velocity += share * (this->Settings.fullSpeed * push - this->Velocity);
    this->Position += elapsed * this->Velocity;
  }
  else
  {
    this->Position += share * (reach * push - this->Position);
  }
  this->Position = this->Position.cwiseMax(-reach).cwiseMin(reach);
  this->Velocity = (this->Position - before) / elapsed;
}

DeviceErrors SpaceMouseDevice::errors() const noexcept
{
  DeviceErrors errors;
  errors.malformed = this->Connection->Malformed;
  errors.disconnections = this->Reader->disconnections();
  return errors;
}
} // namespace palpate
