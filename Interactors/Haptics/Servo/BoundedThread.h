// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BoundedThread_h
#define palpate_BoundedThread_h

#include <chrono>
#include <functional>
#include <future>
#include <thread>
#include <utility>

namespace palpate
{
/**
 * A thread for whose end the owner waits only a limited time. It is used for calls into a driver
 * that may hang.
 *
 * finish waits for the end of the work up to a limit. After this limit the thread is detached and
 * continues alone; therefore the work must own all data that it uses.
 */
class BoundedThread
{
public:
  explicit BoundedThread(std::function<void()> work)
  {
    std::packaged_task<void()> task(std::move(work));
    this->Ended = task.get_future();
    this->Thread = std::thread(std::move(task));
  }
  ~BoundedThread() { this->finish(std::chrono::milliseconds(0)); }
  BoundedThread(const BoundedThread&) = delete;
  BoundedThread& operator=(const BoundedThread&) = delete;

  /// Waits up to `limit` for the end of the work. Returns whether the work has ended. The caller
  /// must have asked the work to end before this call.
  bool finish(std::chrono::milliseconds limit)
  {
    if (!this->Thread.joinable())
    {
      return true;
    }
    if (this->Ended.wait_for(limit) == std::future_status::ready)
    {
      this->Thread.join();
      return true;
    }
    this->Thread.detach();
    return false;
  }

private:
  std::future<void> Ended;
  std::thread Thread;
};
} // namespace palpate

#endif
