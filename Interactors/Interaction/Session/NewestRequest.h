// SPDX-License-Identifier: BSD-3-Clause
#ifndef NewestRequest_h
#define NewestRequest_h

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace palpate
{
/**
 * A thread that processes the newest request. A new request replaces waiting requests, and makes
 * the request in progress obsolete. Only the destructor waits for the thread. The thread starts
 * with the first request. It runs at lower priority if the system permits it.
 */
template <class Request, class Result>
class NewestRequest
{
public:
  /// A function that receives the completed fraction of the work. It returns false if the work
  /// should stop, because there is a newer request or the request was cancelled.
  using GoOn = std::function<bool(double)>;
  /// The function that the thread calls. Results of stopped work are discarded.
  using Work = std::function<Result(const Request&, const GoOn&)>;

  explicit NewestRequest(Work work)
    : Compute(std::move(work))
  {
  }
  ~NewestRequest()
  {
    if (this->Thread.joinable())
    {
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Ending = true;
        ++this->Newest;
      }
      this->Wake.notify_one();
      this->Thread.join();
    }
  }
  NewestRequest(const NewestRequest&) = delete;
  NewestRequest& operator=(const NewestRequest&) = delete;

  void submit(Request request)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Waiting = std::move(request);
      this->Done.reset(); // discards the result of an older request
      ++this->Newest;
    }
    if (!this->Thread.joinable())
    {
      this->Thread = std::thread([this] { this->run(); });
    }
    this->Wake.notify_one();
  }

  /// Withdraws the request.
  void cancel()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Waiting.reset();
    this->Done.reset();
    ++this->Newest;
  }

  /// Whether the newest request has no result yet.
  bool isBusy() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Waiting || this->UnderWay == this->Newest;
  }

  /// Completed fraction of the work for the newest request, 0 to 1.
  double fraction() const { return this->Fraction; }

  /// Returns the result of the newest request. Returns an empty value if the result is not ready or
  /// has already been collected.
  std::optional<Result> collect()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return std::exchange(this->Done, std::nullopt);
  }

private:
  void run()
  {
#ifdef __linux__
    constexpr int yielding = 10;
    // The priority applies to this thread and all threads that it starts.
    setpriority(PRIO_PROCESS, 0, yielding);
#endif
    std::unique_lock<std::mutex> lock(this->Mutex);
    while (true)
    {
      this->Wake.wait(lock, [this] { return this->Ending || this->Waiting; });
      if (this->Ending)
      {
        return;
      }
      const Request request = std::move(*std::exchange(this->Waiting, std::nullopt));
      const std::uint64_t mine = this->Newest;
      this->UnderWay = mine;
      this->Fraction = 0.0;
      lock.unlock();
      Result result = this->Compute(request,
        [this, mine](double done)
        {
          this->Fraction = done;
          return this->Newest == mine;
        });
      lock.lock();
      this->UnderWay = None;
      if (this->Newest == mine)
      {
        this->Done = std::move(result);
      }
    }
  }

  static constexpr std::uint64_t None = ~std::uint64_t{ 0 };

  Work Compute;
  mutable std::mutex Mutex;
  std::condition_variable Wake;
  std::optional<Request> Waiting;
  std::optional<Result> Done;
  std::atomic<std::uint64_t> Newest{ 0 }; ///< written under the lock, read without it
  std::uint64_t UnderWay = None;
  std::atomic<double> Fraction{ 0.0 };
  bool Ending = false;
  std::thread Thread;
};
} // namespace palpate

#endif
