// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TickHistory_h
#define palpate_TickHistory_h

#include "Haptics/Servo/ServoStep.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/**
 * The ticks of the last seconds, oldest first. It stores ticks that are drained from a servo loop
 * and need not be kept permanently.
 *
 * The history keeps the newest tick and all ticks whose times are at most `seconds` before it.
 * These are seconds * rate ticks if the loop misses no tick, and at most one more. A tick needs
 * about 600 bytes; memory is used only for ticks that were added. Ticks are numbered from 0 in the
 * order in which they are added, so that a reader can find new ticks. All functions are for the
 * thread that drains, not for the servo thread.
 */
class TickHistory
{
public:
  /// `seconds` is the duration to keep, s. `rate` is in ticks per second. Both must be finite. With
  /// 0 seconds no tick is kept.
  TickHistory(double seconds, double rate)
    : Seconds(seconds)
    , HalfPeriod(0.5 / rate)
    , Capacity(seconds > 0.0 ? static_cast<std::size_t>(std::ceil(seconds * rate)) + 1 : 0)
  {
    this->Slots.reserve(this->Capacity);
  }

  void add(const Tick& tick)
  {
    ++this->Added;
    if (this->Capacity == 0)
    {
      return;
    }
    const double first = tick.time - this->Seconds + this->HalfPeriod;
    while (this->Count > 0 && ((*this)[0].time < first || this->Count == this->Capacity))
    {
      this->Begin = (this->Begin + 1) % this->Capacity;
      --this->Count;
    }
    const std::size_t place = (this->Begin + this->Count) % this->Capacity;
    if (place == this->Slots.size())
    {
      this->Slots.push_back(tick);
    }
    else
    {
      this->Slots[place] = tick;
    }
    ++this->Count;
  }

  std::size_t size() const noexcept { return this->Count; }
  /// The tick at an index. The index 0 is that of the oldest tick.
  const Tick& operator[](std::size_t index) const noexcept
  {
    return this->Slots[(this->Begin + index) % this->Capacity];
  }
  /// The number of ticks that were ever added. The oldest tick in the history has the number
  /// added() - size().
  std::uint64_t added() const noexcept { return this->Added; }

private:
  double Seconds;
  double HalfPeriod;
  std::size_t Capacity;
  std::size_t Begin = 0;
  std::size_t Count = 0;
  std::uint64_t Added = 0;
  std::vector<Tick> Slots;
};
} // namespace palpate

#endif
