// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/ForceRelease.h"

#include <chrono>
#include <cstdlib>
#include <exception>
#include <thread>

namespace palpate
{
namespace
{
std::atomic<int> Holding{ 0 };
std::atomic<std::terminate_handler> HandlerBefore{ nullptr };
} // namespace

std::atomic<bool> ForceHold::Releasing{ false };
thread_local ForceHold* ForceHold::Newest = nullptr;

ForceHold::ForceHold(HapticDevice& device) noexcept
  : Device(device)
  , Before(Newest)
{
  Newest = this;
  Holding.fetch_add(1);
}

ForceHold::~ForceHold()
{
  Newest = this->Before;
  Holding.fetch_sub(1);
}

void ForceHold::releaseAll() noexcept
{
  Releasing.store(true);
  while (const ForceHold* const hold = Newest)
  {
    // Removed from the list before the write, because the exception may come from the device's
    // write and may occur again.
    Newest = hold->Before;
    Holding.fetch_sub(1);
    hold->Device.write(Eigen::Vector3d::Zero());
  }
  for (int i = 0; i < 100 && Holding.load() > 0; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void releaseForceOnTerminate() noexcept
{
  const auto handler = []
  {
    ForceHold::releaseAll();
    if (const std::terminate_handler before = HandlerBefore.load())
    {
      before();
    }
    std::abort();
  };
  const std::terminate_handler before = std::set_terminate(handler);
  if (before != static_cast<std::terminate_handler>(handler))
  {
    HandlerBefore.store(before);
  }
}
} // namespace palpate
