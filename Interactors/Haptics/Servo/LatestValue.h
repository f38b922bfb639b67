// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LatestValue_h
#define palpate_LatestValue_h

#include <array>
#include <atomic>
#include <cstdint>

namespace palpate
{
/**
 * Passes the newest value from one thread to another thread. Neither thread ever waits.
 *
 * There are three slots. The writer fills its own slot and swaps it with the shared slot. The
 * reader swaps the shared slot with its own if the shared one is newer. Intermediate values are
 * lost; no value is read while it is written. One thread may call write, and one other thread may
 * call read. Copying a Value must neither allocate nor throw.
 */
template <class Value>
class LatestValue
{
public:
  explicit LatestValue(const Value& initial = Value()) { this->Slots.fill(initial); }

  void write(const Value& value) noexcept
  {
    this->Slots[this->Writing] = value;
    const std::uint8_t previous = this->Shared.exchange(
      static_cast<std::uint8_t>(this->Writing | Fresh), std::memory_order_acq_rel);
    this->Writing = previous & Index;
  }

  /// For the writing thread. Fills its slot with a likely value, so that the memory of the slot is
  /// in the caches before the next write. The likely value is not visible to the reader.
  void prepare(const Value& likely) noexcept { this->Slots[this->Writing] = likely; }

  /// The newest value that was written, or the initial value.
  const Value& read() noexcept
  {
    if (this->Shared.load(std::memory_order_relaxed) & Fresh)
    {
      const std::uint8_t previous =
        this->Shared.exchange(static_cast<std::uint8_t>(this->Reading), std::memory_order_acq_rel);
      this->Reading = previous & Index;
    }
    return this->Slots[this->Reading];
  }

private:
  static constexpr std::uint8_t Index = 3;
  static constexpr std::uint8_t Fresh = 4;

  std::array<Value, 3> Slots;
  std::uint8_t Writing = 0; ///< slot of the writer
  std::atomic<std::uint8_t> Shared{ 1 };
  std::uint8_t Reading = 2; ///< slot of the reader
};
} // namespace palpate

#endif
