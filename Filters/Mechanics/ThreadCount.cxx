// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/ThreadCount.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace palpate
{
namespace
{
constexpr std::size_t Most = 1024; // a larger number is assumed to be a typing error

thread_local std::size_t Limit = 0; // 0 if there is no limit

/// Returns the number in PALPATE_THREADS; 0 if it is not set, or is not a positive number.
std::size_t environmentCount() noexcept
{
  const char* text = std::getenv("PALPATE_THREADS");
  const long wish = text != nullptr ? std::strtol(text, nullptr, 10) : 0;
  return wish > 0 ? std::min(Most, static_cast<std::size_t>(wish)) : 0;
}
} // namespace

std::size_t threadCount() noexcept
{
  static const std::size_t wish = environmentCount();
  if (Limit > 0)
  {
    return wish > 0 ? std::min(Limit, wish) : Limit;
  }
  return wish > 0 ? wish : std::max(1U, std::thread::hardware_concurrency());
}

ThreadLimit::ThreadLimit(std::size_t count) noexcept
  : Before(Limit)
{
  Limit = count > 0 ? std::min(Most, count) : Limit;
}

ThreadLimit::~ThreadLimit()
{
  Limit = this->Before;
}
} // namespace palpate
