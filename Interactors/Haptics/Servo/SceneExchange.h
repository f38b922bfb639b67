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
 * Passes scenes between two threads: from their owner, which makes and frees them, to the servo
 * thread, which renders them, and back to the owner. Neither thread ever waits. The servo thread
 * frees no scene.
 *
 * The owner offers a scene. The servo thread takes the scene in a tick, and gives back the scenes
 * that it no longer needs. The owner collects the scenes that were given back, which frees them. A
 * new offer replaces an older one; if the older scene has not been taken, the owner frees it.
 *
 * A Scene must have a member `std::unique_ptr<Scene> next`: scenes that are given back form a list,
 * so that any number of scenes needs no extra memory. One thread may call offer and collect, and
 * one other thread may call take and giveBack.
 */
template <class Scene>
class SceneExchange
{
public:
  SceneExchange() = default;
  SceneExchange(const SceneExchange&) = delete;
  SceneExchange& operator=(const SceneExchange&) = delete;
  /// Frees the offered scene if it was not taken, and the scenes that were not collected.
  ~SceneExchange()
  {
    this->offer(nullptr);
    this->collect();
  }

  /// For the owner. Offers a scene and frees the previous offer if it was not taken. If `scene` is
  /// null, only the previous offer is withdrawn.
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

  /// For the servo thread. Takes the newest offer; returns null if there is none.
  std::unique_ptr<Scene> take() noexcept
  {
    // A load precedes the exchange, because most ticks find no offer, and an exchange costs many
    // times more than a load.
    return std::unique_ptr<Scene>(this->Offered.load(std::memory_order_relaxed) == nullptr
        ? nullptr
        : this->Offered.exchange(nullptr, std::memory_order_acquire));
  }

  /// For the servo thread. Gives back a list of scenes that the thread no longer needs. Null has no
  /// effect.
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
    // Only the servo thread stores lists here. If the owner collects between the exchange and the
    // store, it finds null.
    last->next.reset(this->Returned.exchange(nullptr, std::memory_order_acquire));
    this->Returned.store(list.release(), std::memory_order_release);
  }

private:
  std::atomic<Scene*> Offered{ nullptr };
  std::atomic<Scene*> Returned{ nullptr };
};
} // namespace palpate

#endif
