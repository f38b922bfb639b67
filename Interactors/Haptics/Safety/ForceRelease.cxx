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
thread_local HapticDevice* Held = nullptr; ///< of this servo thread
std::atomic<std::terminate_handler> HandlerBefore{ nullptr };

void letGo() noexcept
{
  Held = nullptr;
  Holding.fetch_sub(1);
}
} // namespace

std::atomic<bool> ForceHold::Releasing{ false };

ForceHold::ForceHold(HapticDevice& device) noexcept
{
  Held = &device;
  Holding.fetch_add(1);
}

ForceHold::~ForceHold()
{
  letGo();
}

void ForceHold::releaseAll() noexcept
{
  Releasing.store(true);
  if (HapticDevice* const device = Held)
  {
    letGo(); // first: it may be the device's write that has thrown, and will again
    device->write(Eigen::Vector3d::Zero());
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
