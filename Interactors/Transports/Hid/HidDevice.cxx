// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Hid/HidDevice.h"

#include "Transports/DeviceList.h"
#include "Haptics/Servo/LatestValue.h"
#include "Transports/Hid/ReportSequence.h"

#include <atomic>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
struct NumberedState
{
  StateReport report;
  std::uint64_t number = 0; ///< numbers of the states are 1, 2, 3, …
};

/// Reads the feature report with the description. All bytes are zero if there is no such report.
HapticReportBytes describe(HidPort& port)
{
  HapticReportBytes bytes{};
  if (port.feature(bytes.data(), bytes.size()) != static_cast<int>(bytes.size()))
  {
    bytes.fill(0);
  }
  return bytes;
}

} // namespace

/// The listener of the reader thread, and the data that it shares with the tick.
class HidDevice::Link final : public HidListener
{
public:
  Link(HidBus& bus, const HapticReportBytes& description, const DeviceSpecification& specification)
    : Writer(watchdogOf(specification.sampleTimeOut, specification))
    , Bus(bus)
    , DescriptionBytes(description)
  {
  }

  /// Writes use a separate port, because a port of hidapi is not thread-safe.
  std::string connectWriter(const std::string& path)
  {
    std::string error;
    std::shared_ptr<HidPort> port = this->Bus.open(path, error);
    this->Writer.use(std::move(port));
    return error;
  }

  std::string returned(HidPort& port, const HidEntry& entry) override
  {
    if (describe(port) != this->DescriptionBytes)
    {
      return "it describes itself otherwise than before; start again to use it";
    }
    this->Sequence.restart();
    return this->connectWriter(entry.path);
  }

  void received(const std::uint8_t* report, std::size_t size) noexcept override
  {
    StateReport state;
    if (parse(report, size, state) != ReportDefect::None)
    {
      this->Malformed.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    const auto verdict = this->Sequence.judge(state.sequence);
    this->Stale.store(this->Sequence.stale(), std::memory_order_relaxed);
    this->Lost.store(this->Sequence.lost(), std::memory_order_relaxed);
    if (verdict == ReportSequence::Verdict::Stale)
    {
      return;
    }
    this->States.write({ state, ++this->Number });
    this->Faulty.store(state.fault, std::memory_order_relaxed);
    this->Amplified.store(state.amplifiersOn, std::memory_order_relaxed);
    // Set only after the first state has been stored.
    this->Alive.store(true, std::memory_order_release);
  }

  void lost() noexcept override
  {
    this->Alive.store(false, std::memory_order_release);
    this->Writer.use(nullptr);
  }

  ForceWriter Writer;
  LatestValue<NumberedState> States; ///< from the reader thread to the tick
  std::atomic<bool> Alive{
    false
  }; ///< whether a valid state has arrived since the device was opened
  std::atomic<bool> Faulty{ false };
  std::atomic<bool> Amplified{ false };
  std::atomic<std::uint64_t> Malformed{ 0 };
  std::atomic<std::uint64_t> Stale{ 0 };
  std::atomic<std::uint64_t> Lost{ 0 };

private:
  HidBus& Bus;
  const HapticReportBytes DescriptionBytes;
  ReportSequence Sequence;  ///< used by the reader thread
  std::uint64_t Number = 0; ///< used by the reader thread
};

std::unique_ptr<HidDevice> HidDevice::open(const std::string& path, std::string& error, HidBus& bus)
{
  std::unique_ptr<HidPort> port = bus.open(path, error);
  if (!port)
  {
    return nullptr;
  }
  const HapticReportBytes bytes = describe(*port);
  DescriptionReport description;
  std::string remark;
  const bool described = parse(bytes.data(), bytes.size(), description) == ReportDefect::None;
  const DeviceSpecification specification = specificationOf(description, &remark);
  if (!described)
  {
    remark = "it does not describe itself, careful limits are assumed";
  }
  auto link = std::make_shared<Link>(bus, bytes, specification);
  error = link->connectWriter(path);
  if (!error.empty())
  {
    return nullptr;
  }
  return std::unique_ptr<HidDevice>(new HidDevice(
    bus, entryAt(bus, path), std::move(port), std::move(link), description, std::move(remark)));
}

HidDevice::HidDevice(HidBus& bus, const HidEntry& entry, std::unique_ptr<HidPort> port,
  std::shared_ptr<Link> link, const DescriptionReport& description, std::string remark)
  : Limits(specificationOf(description))
  , Description(description)
  , Remark(std::move(remark))
  , Connection(std::move(link))
  , Reader(
      std::make_unique<HidReader>(bus, entry, std::move(port), this->Connection, HapticReportSize))
{
}

HidDevice::~HidDevice()
{
  this->Connection->Writer.stop(); // called while the device is still connected
}

DeviceSample HidDevice::read(double) noexcept
{
  DeviceSample sample;
  Link& link = *this->Connection;
  if (!link.Alive.load(std::memory_order_acquire))
  {
    sample.fresh = false;
    return sample;
  }
  const NumberedState& state = link.States.read();
  sample.position = state.report.position;
  sample.velocity = state.report.velocity;
  sample.buttons = state.report.buttons;
  sample.orientation = state.report.orientation;
  sample.valid = !state.report.fault;
  sample.fresh = state.number != this->Seen;
  this->Seen = state.number;
  this->StateSequence = state.report.sequence;
  return sample;
}

void HidDevice::holdFor(double seconds) noexcept
{
  this->Connection->Writer.holdFor(watchdogOf(seconds, this->Limits));
}

bool HidDevice::writeWrench(const Wrench& wrench) noexcept
{
  Link& link = *this->Connection;
  if (!this->Limits.outputsForce || !link.Alive.load(std::memory_order_acquire))
  {
    return false;
  }
  const bool isFinite = std::isfinite(wrench.force.norm() + wrench.torque.norm());
  if (!isFinite || link.Faulty.load(std::memory_order_relaxed))
  {
    link.Writer.send(Wrench(), this->StateSequence);
    return false;
  }
  return link.Writer.send(
    wrench.within(this->Limits.maximumForce, this->Limits.maximumTorque), this->StateSequence);
}

std::string HidDevice::status() const
{
  if (!this->Reader->connected())
  {
    return this->Reader->status();
  }
  const Link& link = *this->Connection;
  std::string words = "connected";
  if (!link.Alive)
  {
    words += ", waiting for its first report";
  }
  else if (link.Faulty)
  {
    words += ", but it reports a fault";
  }
  else if (!link.Writer.taken())
  {
    words += ", but it does not take forces";
  }
  else if (this->Limits.outputsForce && !link.Amplified)
  {
    words += ", amplifiers off";
  }
  return this->Remark.empty() ? words : words + " (" + this->Remark + ")";
}

DeviceErrors HidDevice::errors() const noexcept
{
  const Link& link = *this->Connection;
  DeviceErrors errors;
  errors.malformed = link.Malformed;
  errors.stale = link.Stale;
  errors.lost = link.Lost;
  errors.unsent = link.Writer.unsent();
  errors.disconnections = this->Reader->disconnections();
  return errors;
}
} // namespace palpate
