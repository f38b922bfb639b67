// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SampleRing_h
#define palpate_SampleRing_h

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/**
 * Passes every value from one thread to another thread, in order. Neither thread ever waits.
 *
 * The constructor allocates and touches all memory. If the reader drains too late and the ring is
 * full, the newest value is lost and counted. Therefore a record may have a gap, but the gap is
 * known, and no value is overwritten while it is read. One thread may call push, one other thread
 * drain; both may read the counts. Copying a Value must neither allocate nor throw.
 */
template <class Value>
class SampleRing
{
public:
  /// With a capacity of 0, no value is stored and none counts as lost.
  explicit SampleRing(std::size_t capacity)
    : Slots(capacity)
  {
  }

  /// Adds a value. Returns false if there is no space.
  bool push(const Value& value) noexcept
  {
    if (this->Slots.empty())
    {
      return false;
    }
    const std::uint64_t pushed = this->Pushed.load(std::memory_order_relaxed);
    if (pushed - this->Drained.load(std::memory_order_acquire) >= this->Slots.size())
    {
      this->Overruns.store(
        this->Overruns.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      return false;
    }
    this->Slots[this->PushIndex] = value;
    this->PushIndex = this->after(this->PushIndex);
    this->Pushed.store(pushed + 1, std::memory_order_release);
    return true;
  }

  /// For the pushing thread: fills the slot of the next value, so that its memory is in the caches.
  /// This value is not visible to the reader.
  void prepare(const Value& likely) noexcept
  {
    if (this->size() < this->Slots.size())
    {
      this->Slots[this->PushIndex] = likely;
    }
  }

  /// Calls sink(const Value&) for each value that was present when drain began, oldest first, and
  /// removes it. Returns the number of values. If the sink throws, its value and the following ones
  /// remain in the ring.
  template <class Sink>
  std::size_t drain(Sink&& sink)
  {
    const std::uint64_t pushed = this->Pushed.load(std::memory_order_acquire);
    const std::uint64_t first = this->Drained.load(std::memory_order_relaxed);
    for (std::uint64_t next = first; next != pushed; ++next)
    {
      sink(static_cast<const Value&>(this->Slots[this->DrainIndex]));
      this->DrainIndex = this->after(this->DrainIndex);
      this->Drained.store(next + 1, std::memory_order_release);
    }
    return static_cast<std::size_t>(pushed - first);
  }

  std::size_t capacity() const noexcept { return this->Slots.size(); }
  /// Number of waiting values. In the pushing thread it is never too small.
  std::size_t size() const noexcept
  {
    const std::uint64_t drained = this->Drained.load(std::memory_order_acquire);
    return static_cast<std::size_t>(this->Pushed.load(std::memory_order_acquire) - drained);
  }
  /// Number of values that were lost because there was no space.
  std::uint64_t overruns() const noexcept { return this->Overruns.load(std::memory_order_relaxed); }

private:
  std::size_t after(std::size_t index) const noexcept
  {
    return index + 1 < this->Slots.size() ? index + 1 : 0;
  }

  // The members of each thread are in separate cache lines.
  static constexpr std::size_t CacheLine = 64;

  alignas(CacheLine) std::atomic<std::uint64_t> Pushed{ 0 };
  std::atomic<std::uint64_t> Overruns{ 0 };
  std::size_t PushIndex = 0; ///< used only by the pushing thread
  alignas(CacheLine) std::atomic<std::uint64_t> Drained{ 0 };
  std::size_t DrainIndex = 0; ///< used only by the draining thread
  std::vector<Value> Slots;
};
} // namespace palpate

#endif
