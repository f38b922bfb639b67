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
 * The constructor allocates and touches all memory. If the ring is full because the reader drains
 * too late, the newest value is lost, and the loss is counted. Therefore a record may have a gap,
 * but the size of the gap is known. No value is overwritten while it is read. One thread may call
 * push, one other thread may call drain, and both may read the counts. Copying a Value must neither
 * allocate nor throw.
 */
template <class Value>
class SampleRing
{
public:
  /// `capacity` is the number of slots. With a capacity of 0, no value is stored and none is
  /// counted as lost.
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

  /// For the pushing thread. Fills the slot of the next value with a likely value, so that the
  /// memory of the slot is in the caches. The likely value is not visible to the reader.
  void prepare(const Value& likely) noexcept
  {
    if (this->size() < this->Slots.size())
    {
      this->Slots[this->PushIndex] = likely;
    }
  }

  /// Calls sink(const Value&) for each value that was present when drain began, oldest first, and
  /// removes the value. Returns the number of removed values. If the sink throws, the value that
  /// was passed to it and the following values remain in the ring.
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
  /// Number of values in the ring. In the pushing thread the number is never too small.
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

  // The members of the two threads are in separate cache lines.
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
