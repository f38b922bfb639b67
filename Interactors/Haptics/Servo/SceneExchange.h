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
 * Passes scenes from their owner, the thread that makes and frees them, to the servo thread that
 * renders them, and back. Neither thread ever waits. The servo thread frees no scene.
 *
 * The owner offers a scene. The servo thread takes it at a tick, and gives back the scenes that it
 * no longer needs. The owner collects these, which frees them. Of two offers in quick succession
 * the newer one wins: if the older one has not been taken, the owner frees it.
 *
 * A Scene has a member `std::unique_ptr<Scene> next`: scenes that are given back form a list, so
 * that any number of them needs no extra memory. One thread may call offer and collect, one other
 * thread take and giveBack.
 */
template <class Scene>
class SceneExchange
{
public:
  SceneExchange() = default;
  SceneExchange(const SceneExchange&) = delete;
  SceneExchange& operator=(const SceneExchange&) = delete;
  /// Frees a scene that was not taken and those that were not collected.
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

  /// Owner. Frees the scenes that were given back; returns how many.
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
    // Reads first: most ticks find no offer, and an exchange costs many times more.
    return std::unique_ptr<Scene>(this->Offered.load(std::memory_order_relaxed) == nullptr
        ? nullptr
        : this->Offered.exchange(nullptr, std::memory_order_acquire));
  }

  /// Servo thread. Gives back a list of scenes that it no longer needs; null changes nothing.
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
    // Only this thread puts lists here. If the owner collects meanwhile, the owner finds null.
    last->next.reset(this->Returned.exchange(nullptr, std::memory_order_acquire));
    this->Returned.store(list.release(), std::memory_order_release);
  }

private:
  std::atomic<Scene*> Offered{ nullptr };
  std::atomic<Scene*> Returned{ nullptr };
};
} // namespace palpate

#endif
