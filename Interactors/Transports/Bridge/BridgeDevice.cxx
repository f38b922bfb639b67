// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Bridge/BridgeDevice.h"

#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace palpate
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr int FirstGreetings = 50; ///< ms between two greetings while the device is being opened
constexpr double GreetingPause = 0.25; ///< s between two greetings to a lost program

std::uint64_t microseconds() noexcept
{
  return static_cast<std::uint64_t>(
    std::chrono::duration_cast<std::chrono::microseconds>(Clock::now().time_since_epoch()).count());
}

/// Whether both descriptions are of the same device. The nonces are ignored.
bool same(DescriptionReport a, DescriptionReport b) noexcept
{
  a.nonce = b.nonce = 0;
  HapticReportBytes first{};
  HapticReportBytes second{};
  pack(a, first);
  pack(b, second);
  return first == second;
}
} // namespace

std::unique_ptr<BridgeDevice> BridgeDevice::open(
  const std::string& address, std::string& error, double patience)
{
  std::unique_ptr<BridgeSocket> socket = BridgeSocket::open(address, error);
  if (!socket)
  {
    return nullptr;
  }
  std::unique_ptr<BridgeDevice> device(
    new BridgeDevice(std::move(socket), address, std::random_device()()));
  if (!device->greetFirst(patience))
  {
    error = "'" + address + "': no program there describes itself as a device";
    return nullptr;
  }
  return device;
}

BridgeDevice::BridgeDevice(
  std::unique_ptr<BridgeSocket> socket, std::string address, std::uint32_t nonce)
  : Socket(std::move(socket))
  , Address(std::move(address))
  , Limits(carefulSpecification())
  , Nonce(nonce)
{
}

BridgeDevice::~BridgeDevice()
{
  if (this->Known)
  {
    this->send({}, false);
  }
}

bool BridgeDevice::greetFirst(double patience)
{
  const auto end = Clock::now() + std::chrono::duration<double>(patience);
  auto next = Clock::now();
  while (!this->Known && Clock::now() < end)
  {
    if (Clock::now() >= next)
    {
      this->greet();
      next = Clock::now() + std::chrono::milliseconds(FirstGreetings);
    }
    this->Socket->wait(FirstGreetings);
    this->receiveAll(0.0);
  }
  if (this->Known)
  {
    // A state that arrived before the first tick has no time of the servo loop.
    this->Now = Stage::Described;
    this->Limits = specificationOf(this->Description, &this->Remark);
    this->Watchdog = watchdogOf(this->Limits.sampleTimeOut, this->Limits);
  }
  return this->Known;
}

DeviceSample BridgeDevice::read(double time) noexcept
{
  if (!this->Started)
  {
    this->Started = true;
    this->GreetedAt = time;
  }
  this->Fresh = false;
  this->receiveAll(time);
  // Both conditions are written such that a time counts as too late if it is NaN or decreases.
  if (this->Now == Stage::Alive && !(std::abs(time - this->NewsAt) <= this->Limits.sampleTimeOut))
  {
    this->lose();
  }
  if (this->Now != Stage::Alive && !(std::abs(time - this->GreetedAt) < GreetingPause))
  {
    this->Now = Stage::Greeting; // this case includes a description without a state
    this->GreetedAt = time;
    ++this->Nonce;
    this->greet();
  }
  DeviceSample sample;
  sample.fresh = false;
  if (this->Now != Stage::Alive)
  {
    return sample;
  }
  sample.position = this->Newest.position;
  sample.velocity = this->Newest.velocity;
  sample.buttons = this->Newest.buttons;
  sample.orientation = this->Newest.orientation;
  sample.valid = !this->Newest.fault;
  sample.fresh = this->Fresh;
  return sample;
}

void BridgeDevice::receiveAll(double time) noexcept
{
  std::array<std::uint8_t, HapticReportSize + 1> bytes{};
  for (int i = 0; i < ReadsPerTick; ++i)
  {
    std::size_t size = bytes.size();
    const BridgeSocket::Arrival arrival = this->Socket->receive(bytes.data(), size);
    if (arrival == BridgeSocket::Arrival::None)
    {
      return;
    }
    if (arrival == BridgeSocket::Arrival::Foreign)
    {
      this->Foreign.fetch_add(1, std::memory_order_relaxed);
    }
    else
    {
      this->take(bytes.data(), size, time);
    }
  }
}

void BridgeDevice::take(const std::uint8_t* bytes, std::size_t size, double time) noexcept
{
  StateReport state;
  DescriptionReport description;
  if (parse(bytes, size, state) == ReportDefect::None)
  {
    this->takeState(state, time);
  }
  else if (parse(bytes, size, description) == ReportDefect::None)
  {
    this->takeDescription(description);
  }
  else
  {
    this->Malformed.fetch_add(1, std::memory_order_relaxed);
  }
}

void BridgeDevice::takeState(const StateReport& state, double time) noexcept
{
  if (this->Now == Stage::Greeting)
  {
    return; // the program has sent no description since the greeting
  }
  const ReportSequence::Verdict verdict = this->Sequence.judge(state.sequence);
  this->Stale.store(this->Sequence.stale(), std::memory_order_relaxed);
  this->Lost.store(this->Sequence.lost(), std::memory_order_relaxed);
  if (verdict == ReportSequence::Verdict::Restarted)
  {
    this->lose();
  }
  else if (verdict == ReportSequence::Verdict::New)
  {
    this->Newest = state;
    this->NewsAt = time;
    this->Fresh = true;
    this->Faulty = state.fault;
    this->Amplified = state.amplifiersOn;
    this->Now = Stage::Alive;
  }
}

void BridgeDevice::takeDescription(const DescriptionReport& description) noexcept
{
  if (description.nonce != this->Nonce)
  {
    this->Malformed.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  this->Stranger = this->Known && !same(description, this->Description);
  if (this->Stranger || this->Now != Stage::Greeting)
  {
    return; // the description is of another device, or is the answer to a second greeting
  }
  this->Description = description;
  this->Known = true;
  this->Sequence.restart();
  this->Now = Stage::Described;
}

void BridgeDevice::lose() noexcept
{
  this->send({}, false); // sent in case the program still receives
  this->GreetedAt = -std::numeric_limits<double>::infinity(); // makes this tick send a greeting
  this->Now = Stage::Greeting;
  this->Disconnections.fetch_add(1, std::memory_order_relaxed);
}

void BridgeDevice::greet() noexcept
{
  HapticReportBytes bytes{};
  pack(HelloReport{ this->Nonce }, bytes);
  // If this greeting is lost, other greetings follow.
  this->Socket->send(bytes.data(), bytes.size());
}

bool BridgeDevice::writeWrench(const Wrench& wrench) noexcept
{
  if (!this->Limits.outputsForce || this->Now != Stage::Alive)
  {
    return false;
  }
  if (this->Newest.fault)
  {
    this->send({}, false);
    return false;
  }
  const bool isFinite = std::isfinite(wrench.force.norm() + wrench.torque.norm());
  return this->send(
    isFinite ? wrench.within(this->Limits.maximumForce, this->Limits.maximumTorque) : Wrench(),
    true);
}

void BridgeDevice::holdFor(double seconds) noexcept
{
  this->Watchdog = watchdogOf(seconds, this->Limits);
}

bool BridgeDevice::send(const Wrench& wrench, bool enable) noexcept
{
  ForceReport report;
  report.enable = enable;
  report.sequence = ++this->ForceSequence;
  report.time = microseconds();
  report.force = wrench.force;
  report.torque = wrench.torque;
  report.watchdog = this->Watchdog;
  report.stateSequence = this->Newest.sequence;
  HapticReportBytes bytes{};
  pack(report, bytes);
  const bool sent = this->Socket->send(bytes.data(), bytes.size());
  if (!sent)
  {
    this->Unsent.fetch_add(1, std::memory_order_relaxed);
  }
  return sent;
}

std::string BridgeDevice::status() const
{
  std::string words = "connected";
  if (this->Stranger)
  {
    words = "returned, but not used: it describes itself otherwise than before; start again to "
            "use it";
  }
  else if (this->Now != Stage::Alive)
  {
    words = this->Disconnections > 0 ? "silent, waiting for it to return"
                                     : "connected, waiting for its first report";
  }
  else if (this->Faulty)
  {
    words += ", but it reports a fault";
  }
  else if (this->Limits.outputsForce && !this->Amplified)
  {
    words += ", amplifiers off";
  }
  return this->Remark.empty() ? words : words + " (" + this->Remark + ")";
}

DeviceErrors BridgeDevice::errors() const noexcept
{
  DeviceErrors errors;
  errors.malformed = this->Malformed;
  errors.stale = this->Stale;
  errors.lost = this->Lost;
  errors.unsent = this->Unsent;
  errors.disconnections = this->Disconnections;
  return errors;
}
} // namespace palpate
