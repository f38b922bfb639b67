// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SceneExchange_h
#define palpate_SceneExchange_h

#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace palpate
{
/**
 * Hands scenes from the thread that makes and frees them, the owner, to the servo thread that
 * renders them, and gets them back. Neither ever waits; the servo thread frees none.
 *
 * The owner offers a scene; the servo thread takes it at a tick and, once it has let go of others,
 * gives these back; the owner collects them, which frees them. Of two offers in quick succession
 * the newer one wins: the older is freed by the owner if it has not been taken.
 *
 * A Scene has a member `std::unique_ptr<Scene> next`: scenes that are given back are a list, so
 * that there may be any number of them without memory for it. One thread may call offer and
 * collect, one other take and giveBack.
 */
template <class Scene>
class SceneExchange
{
public:
  SceneExchange() = default;
  SceneExchange(const SceneExchange&) = delete;
  SceneExchange& operator=(const SceneExchange&) = delete;
  /// Frees what was not taken and what was not collected.
  ~SceneExchange()
  {
    this->offer(nullptr);
    this->collect();
  }

  /// Owner. Replaces an offer that was not taken; null only withdraws it.
  void offer(std::unique_ptr<Scene> scene) noexcept
  {
    const std::unique_ptr<Scene> outdated(
      this->Offered.exchange(scene.release(), std::memory_order_acq_rel));
  }

  /// Owner. Frees what was given back; returns how many.
  std::size_t collect() noexcept
  {
    std::unique_ptr<Scene> list(this->Returned.exchange(nullptr, std::memory_order_acquire));
    std::size_t count = 0;
    for (; list; ++count)
    {
      list = std::move(list->next);
    }
    return count;
  }

  /// Servo thread. The newest offer, or null.
  std::unique_ptr<Scene> take() noexcept
  {
    // A read first: most ticks find nothing, and an exchange is many times dearer.
    return std::unique_ptr<Scene>(this->Offered.load(std::memory_order_relaxed) == nullptr
        ? nullptr
        : this->Offered.exchange(nullptr, std::memory_order_acquire));
  }

  /// Servo thread. A list of scenes that it has let go of; null is none.
  void giveBack(std::unique_ptr<Scene> list) noexcept
  {
    if (!list)
    {
      return;
    }
    Scene* last = list.get();
    while (last->next)
    {
      last = last->next.get();
    }
    // Only this thread puts lists there: what the owner may find meanwhile is nothing.
    last->next.reset(this->Returned.exchange(nullptr, std::memory_order_acquire));
    this->Returned.store(list.release(), std::memory_order_release);
  }

private:
  std::atomic<Scene*> Offered{ nullptr };
  std::atomic<Scene*> Returned{ nullptr };
};
} // namespace palpate

#endif
