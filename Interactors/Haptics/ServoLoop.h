// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoLoop_h
#define palpate_ServoLoop_h

#include "HapticDevice.h"
#include "LatestValue.h"
#include "ServoStep.h"

#include <atomic>
#include <cstdint>
#include <thread>

namespace palpate
{
/**
 * The servo thread: device → ServoStep → device at a fixed rate, newest tick published.
 *
 * Deadlines are absolute (a late tick does not shift the next; ticks missed altogether are skipped
 * and counted). The tick neither allocates, locks, logs nor throws. start and stop belong to one
 * owning thread; newest to one reading thread. Device and body must outlive the loop; stopping, or
 * destroying a running loop, sends zero force.
 */
class ServoLoop
{
public:
  /// `rate` in ticks per second, 1 to 100000.
  ServoLoop(HapticDevice& device, const ServoStep& step, double rate);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  void start();
  void stop();
  bool isRunning() const noexcept { return this->Thread.joinable(); }

  /// The newest tick; a default one before the first.
  const ServoTick& newest() noexcept { return this->Latest.read(); }
  std::uint64_t ticks() const noexcept { return this->Ticks.load(std::memory_order_relaxed); }
  std::uint64_t missed() const noexcept { return this->Missed.load(std::memory_order_relaxed); }

private:
  void run() noexcept;

  HapticDevice& Device;
  ServoStep Step;
  double Period;
  LatestValue<ServoTick> Latest;
  std::atomic<bool> Stopping{ false };
  std::atomic<std::uint64_t> Ticks{ 0 };
  std::atomic<std::uint64_t> Missed{ 0 };
  std::thread Thread;
};
} // namespace palpate

#endif
