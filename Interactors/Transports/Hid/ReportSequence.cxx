// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Hid/ReportSequence.h"

namespace palpate
{
ReportSequence::Verdict ReportSequence::judge(std::uint32_t number) noexcept
{
  if (!this->Started)
  {
    this->Started = true;
    this->Newest = number;
    this->Run = 0;
    return Verdict::New;
  }
  const std::uint32_t ahead = number - this->Newest; // difference modulo 2³²
  if (ahead == 0 || ahead > LargestGap)
  {
    return this->doubt(number);
  }
  this->LostReports += ahead - 1;
  this->Newest = number;
  this->Run = 0;
  return Verdict::New;
}

ReportSequence::Verdict ReportSequence::doubt(std::uint32_t number) noexcept
{
  const std::uint32_t ahead = number - this->Doubtful;
  const bool follows = this->Run > 0 && ahead > 0 && ahead <= LargestGap;
  this->Run = follows ? this->Run + 1 : 1;
  this->Doubtful = number;
  if (this->Run < Confirmations)
  {
    ++this->StaleReports;
    return Verdict::Stale;
  }
  this->Newest = number;
  this->Run = 0;
  return Verdict::Restarted;
}

void ReportSequence::restart() noexcept
{
  this->Started = false;
  this->Run = 0;
}
} // namespace palpate
