// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Hid/ForceWriter.h"

#include "Transports/Hid/HapticReport.h"
#include "Haptics/Servo/LatestValue.h"
#include "Haptics/Servo/RealTimeGrant.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <utility>

#include <semaphore.h>

namespace palpate
{
namespace
{
constexpr std::chrono::milliseconds Patience(1000);
constexpr int Priority = 79; ///< below the servo's priority, so that no device can delay a tick

struct Order
{
  Wrench wrench;
  std::uint32_t stateSequence = 0;
  std::uint32_t watchdog = ForceReport().watchdog;
  std::uint64_t number = 0; ///< numbers of the orders are 1, 2, 3, …
};
} // namespace

/// This object is owned jointly by the thread and the writer, because the writer may end before the
/// thread.
struct ForceWriter::Shared
{
  std::uint32_t Watchdog; ///< used by the tick

  std::uint64_t Number = 0;           ///< used by the tick
  LatestValue<Order> Orders;          ///< from the tick to the thread
  std::atomic<bool> Waiting{ false }; ///< true while the thread has not yet received a wake-up
  sem_t Wake{};

  std::mutex Mutex;
  std::shared_ptr<HidPort> Port; ///< protected by Mutex
  std::atomic<bool> Stopping{ false };
  std::atomic<bool> Taken{ true };
  std::atomic<std::uint64_t> Unsent{ 0 };

  std::uint64_t Done = 0;     ///< used by the thread; number of the last order
  std::uint32_t Sequence = 0; ///< used by the thread; number of the last report

  explicit Shared(std::uint32_t watchdog)
    : Watchdog(watchdog)
  {
    sem_init(&this->Wake, 0, 0);
  }
  ~Shared() { sem_destroy(&this->Wake); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  void run()
  {
    requestRealTime({ Priority });
    while (true)
    {
      while (sem_wait(&this->Wake) != 0 && errno == EINTR)
      {
        // a signal has interrupted the wait
      }
      // Cleared before the order is read, so that a later order wakes the thread again.
      this->Waiting.store(false);
      if (this->Stopping)
      {
        break;
      }
      this->sendNewest();
    }
    this->report({}, false);
  }

  void sendNewest()
  {
    const Order& order = this->Orders.read();
    if (order.number == this->Done)
    {
      return;
    }
    const bool sent = this->report(order, true);
    this->Taken.store(sent);
    this->Unsent.fetch_add(order.number - this->Done - (sent ? 1 : 0));
    this->Done = order.number;
  }

  bool report(const Order& order, bool enable)
  {
    // The local pointer keeps the port open while the device is busy, even if the device is lost.
    std::shared_ptr<HidPort> port;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      port = this->Port;
    }
    if (!port)
    {
      return false;
    }
    ForceReport report;
    report.enable = enable;
    report.sequence = ++this->Sequence;
    report.time = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now().time_since_epoch())
                                               .count());
    report.force = order.wrench.force;
    report.torque = order.wrench.torque;
    report.watchdog = order.watchdog;
    report.stateSequence = order.stateSequence;
    HapticReportBytes bytes;
    pack(report, bytes);
    return port->write(bytes.data(), bytes.size());
  }
};

ForceWriter::ForceWriter(std::uint32_t watchdog)
  : Work(std::make_shared<Shared>(watchdog))
  , Thread([work = this->Work] { work->run(); })
{
}

ForceWriter::~ForceWriter()
{
  this->stop();
}

void ForceWriter::stop()
{
  this->Work->Stopping = true;
  sem_post(&this->Work->Wake);
  this->Thread.finish(Patience);
}

void ForceWriter::use(std::shared_ptr<HidPort> port)
{
  const std::lock_guard<std::mutex> lock(this->Work->Mutex);
  this->Work->Port.swap(port);
}

bool ForceWriter::send(const Wrench& wrench, std::uint32_t stateSequence) noexcept
{
  Shared& work = *this->Work;
  Order order;
  order.wrench = wrench;
  order.stateSequence = stateSequence;
  order.watchdog = work.Watchdog;
  order.number = ++work.Number;
  work.Orders.write(order);
  if (!work.Waiting.exchange(true))
  {
    sem_post(&work.Wake);
  }
  return work.Taken;
}

void ForceWriter::holdFor(std::uint32_t watchdog) noexcept
{
  this->Work->Watchdog = watchdog;
}

bool ForceWriter::taken() const noexcept
{
  return this->Work->Taken;
}

std::uint64_t ForceWriter::unsent() const noexcept
{
  return this->Work->Unsent;
}
} // namespace palpate
