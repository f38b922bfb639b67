// SPDX-License-Identifier: BSD-3-Clause
#include "BackgroundLoad.h"

#include "CacheFlush.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace palpate::benchmarks
{
namespace
{
class IdleLoad final : public BackgroundLoad
{
public:
  void runFor(double seconds) override
  {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }
  std::string name() const override { return "idle"; }
  std::string describe() const override { return "nothing else to do in this program"; }
};

class MemoryLoad final : public BackgroundLoad
{
public:
  void runFor(double seconds) override
  {
    std::atomic<bool> done{ false };
    std::vector<std::thread> threads(this->Readers.size());
    for (std::size_t i = 0; i < threads.size(); ++i)
    {
      threads[i] = std::thread(
        [&, i]
        {
          while (!done)
          {
            this->Readers[i]();
          }
        });
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    done = true;
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }
  std::string name() const override { return "memory"; }
  std::string describe() const override
  {
    return std::to_string(this->Readers.size()) + " threads that read " +
      std::to_string(this->Readers.front().bytes() >> 20) + " MiB each, over and over";
  }

private:
  std::vector<CacheFlush> Readers =
    std::vector<CacheFlush>(std::max(1U, std::thread::hardware_concurrency()));
};
} // namespace

std::unique_ptr<BackgroundLoad> makeIdleLoad()
{
  return std::make_unique<IdleLoad>();
}

std::unique_ptr<BackgroundLoad> makeMemoryLoad()
{
  return std::make_unique<MemoryLoad>();
}
} // namespace palpate::benchmarks
