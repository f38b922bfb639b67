// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReportSequence_h
#define palpate_ReportSequence_h

#include "Mechanics/PalpateExport.h"

#include <cstdint>

namespace palpate
{
/**
 * Tracks the sequence numbers of one sender's reports, and decides which reports are new.
 *
 * Numbers are compared modulo 2³², so that they may wrap around. Old and repeated numbers are
 * stale; gaps are counted as lost. A number that is more than 2¹⁶ reports ahead, or a stale number,
 * may be that of a restarted sender. It is accepted after Confirmations consecutive reports. Until
 * then these reports are stale. The cost is constant, and no memory is allocated.
 */
class PALPATE_EXPORT ReportSequence
{
public:
  static constexpr std::uint32_t LargestGap = 65536;
  static constexpr std::uint32_t Confirmations = 8;

  enum class Verdict : std::uint8_t
  {
    New,
    Stale,    ///< the report must not be used
    Restarted ///< the report may be used; the sender has restarted
  };
  Verdict judge(std::uint32_t number) noexcept;

  /// Prepares for another sender or a new connection, so that the next number counts as the first
  /// one.
  void restart() noexcept;

  std::uint32_t newest() const noexcept { return this->Newest; }
  std::uint64_t stale() const noexcept { return this->StaleReports; }
  std::uint64_t lost() const noexcept { return this->LostReports; }

private:
  Verdict doubt(std::uint32_t number) noexcept;

  bool Started = false;
  std::uint32_t Newest = 0;
  std::uint32_t Doubtful = 0; ///< the last number that was not accepted
  std::uint32_t Run = 0;      ///< number of consecutive numbers that were not accepted
  std::uint64_t StaleReports = 0;
  std::uint64_t LostReports = 0;
};
} // namespace palpate

#endif
