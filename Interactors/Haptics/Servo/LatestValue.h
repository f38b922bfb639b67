// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LatestValue_h
#define palpate_LatestValue_h

#include <array>
#include <atomic>
#include <cstdint>

namespace palpate
{
/**
 * Hands the newest value from one thread to one other; neither ever waits.
 *
 * Three slots: the writer fills its own and swaps it with the shared one, the reader swaps the
 * shared one with its own when it is newer. Values in between are lost, none is ever torn. One
 * thread may call write, one other read. Copying a Value must neither allocate nor throw.
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

  /// Writer: fills its slot, so that the memory is at hand when a value is written. Nobody reads it
  /// before.
  void prepare(const Value& likely) noexcept { this->Slots[this->Writing] = likely; }

  /// The newest value written, or the initial one.
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
  std::uint8_t Writing = 0; ///< the writer's
  std::atomic<std::uint8_t> Shared{ 1 };
  std::uint8_t Reading = 2; ///< the reader's
};
} // namespace palpate

#endif
