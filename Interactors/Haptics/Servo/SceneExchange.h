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
 * The owner offers a scene. The servo thread takes it in a tick, and gives back the scenes that it
 * no longer needs. The owner collects and thereby frees the scenes that were given back. A new
 * offer replaces an older one: if the older one has not been taken, the owner frees it.
 *
 * A Scene must have a member `std::unique_ptr<Scene> next`: scenes that are given back form a list,
 * so that any number of scenes needs no extra memory. One thread may call offer and collect, one
 * other thread take and giveBack.
 */
template <class Scene>
class SceneExchange
{
public:
  SceneExchange() = default;
  SceneExchange(const SceneExchange&) = delete;
  SceneExchange& operator=(const SceneExchange&) = delete;
  /// Frees a scene that was not taken, and the scenes that were not collected.
  ~SceneExchange()
  {
    this->offer(nullptr);
    this->collect();
  }

  /// For the owner. Replaces an offer that was not taken; null only withdraws it.
  void offer(std::unique_ptr<Scene> scene) noexcept
  {
    const std::unique_ptr<Scene> outdated(
      this->Offered.exchange(scene.release(), std::memory_order_acq_rel));
  }

  /// For the owner. Frees the scenes that were given back; returns their number.
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

  /// For the servo thread. Takes the newest offer, or null.
  std::unique_ptr<Scene> take() noexcept
  {
    // A load first, because most ticks find no offer, and an exchange costs many times more.
    return std::unique_ptr<Scene>(this->Offered.load(std::memory_order_relaxed) == nullptr
        ? nullptr
        : this->Offered.exchange(nullptr, std::memory_order_acquire));
  }

  /// For the servo thread. Gives back a list of scenes that it no longer needs; null has no effect.
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
    // Only this thread stores lists here. If the owner collects in the meantime, it finds null.
    last->next.reset(this->Returned.exchange(nullptr, std::memory_order_acquire));
    this->Returned.store(list.release(), std::memory_order_release);
  }

private:
  std::atomic<Scene*> Offered{ nullptr };
  std::atomic<Scene*> Returned{ nullptr };
};
} // namespace palpate

#endif
