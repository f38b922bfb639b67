// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Hid/HidReader.h"

#include "Haptics/Servo/RealTimeGrant.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int ReadLimit = 50; ///< longest wait for a report and for the end of the thread, ms
constexpr std::chrono::milliseconds SearchPause(250);
constexpr std::chrono::milliseconds ReaderPatience(1000);
/// Below the priority of the servo thread, so that many reports do not delay a tick.
constexpr int ReaderPriority = 79;
} // namespace

/// This object is owned jointly by the thread and the reader, because the reader may end before the
/// thread.
struct HidReader::Shared
{
  HidBus& Bus;
  HidEntry Entry; ///< used by the thread
  std::unique_ptr<HidPort> Port;
  std::shared_ptr<HidListener> Listener;
  std::vector<std::uint8_t> Report;

  std::atomic<bool> Connected{ true };
  std::atomic<std::uint64_t> Disconnections{ 0 };
  mutable std::mutex Mutex;
  std::condition_variable Stop;
  bool Stopping = false; ///< protected by Mutex
  /// The reason why a device that was plugged in again is not used. Protected by Mutex.
  std::string Words;

  Shared(HidBus& bus, HidEntry entry, std::unique_ptr<HidPort> port,
    std::shared_ptr<HidListener> listener, std::size_t reportSize)
    : Bus(bus)
    , Entry(std::move(entry))
    , Port(std::move(port))
    , Listener(std::move(listener))
    , Report(reportSize)
  {
  }

  bool stopping() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Stopping;
  }

  void run()
  {
    requestRealTime({ ReaderPriority });
    while (!this->stopping())
    {
      if (this->Port)
      {
        this->readOnce();
      }
      else if (this->pause()) // the pause is needed because the system may still list the device
                              // immediately after the loss
      {
        this->search();
      }
    }
    this->Port.reset();
  }

  /// Waits until the next search. Returns false if the thread must end.
  bool pause()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    return !this->Stop.wait_for(lock, SearchPause, [this] { return this->Stopping; });
  }

  void readOnce()
  {
    const int count = this->Port->read(this->Report.data(), this->Report.size(), ReadLimit);
    if (count > 0)
    {
      this->Listener->received(this->Report.data(), static_cast<std::size_t>(count));
    }
    else if (count < 0)
    {
      // Called before the loss is counted, so that an increased count implies this call.
      this->Listener->lost();
      this->Connected = false;
      this->Disconnections.fetch_add(1);
      this->Port.reset();
    }
  }

  void search()
  {
    const HidEntry found = findAgain(this->Bus, this->Entry);
    if (found.path.empty())
    {
      this->say({});
      return;
    }
    std::string error;
    std::unique_ptr<HidPort> port = this->Bus.open(found.path, error);
    if (port)
    {
      error = this->Listener->returned(*port, found);
    }
    this->say(error);
    if (error.empty())
    {
      this->Entry = found;
      this->Port = std::move(port);
      this->Connected = true;
    }
  }

  void say(std::string words)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Words = std::move(words);
  }
};

HidReader::HidReader(HidBus& bus, HidEntry entry, std::unique_ptr<HidPort> port,
  std::shared_ptr<HidListener> listener, std::size_t reportSize)
  : Work(std::make_shared<Shared>(
      bus, std::move(entry), std::move(port), std::move(listener), reportSize))
  , Thread([work = this->Work] { work->run(); })
{
}

HidReader::~HidReader()
{
  {
    const std::lock_guard<std::mutex> lock(this->Work->Mutex);
    this->Work->Stopping = true;
  }
  this->Work->Stop.notify_all();
  this->Thread.finish(ReaderPatience);
}

bool HidReader::connected() const noexcept
{
  return this->Work->Connected;
}

std::uint64_t HidReader::disconnections() const noexcept
{
  return this->Work->Disconnections;
}

std::string HidReader::status() const
{
  if (this->connected())
  {
    return "connected";
  }
  const std::lock_guard<std::mutex> lock(this->Work->Mutex);
  return this->Work->Words.empty() ? "unplugged, waiting for it to return"
                                   : "returned, but not used: " + this->Work->Words;
}

HidEntry findAgain(HidBus& bus, const HidEntry& entry)
{
  HidEntry best;
  for (HidEntry& candidate : bus.entries())
  {
    const bool same = candidate.vendor == entry.vendor && candidate.product == entry.product &&
      candidate.serial == entry.serial && candidate.usagePage == entry.usagePage &&
      candidate.usage == entry.usage;
    if (same && (best.path.empty() || candidate.path == entry.path))
    {
      best = std::move(candidate);
    }
  }
  return best;
}
} // namespace palpate
