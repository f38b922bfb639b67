// SPDX-License-Identifier: BSD-3-Clause
// Scenes are passed to another thread and returned to the thread that made them, which frees them.
// No scene is leaked, freed while in use, or freed by the thread that uses it. This test also runs
// with the sanitizers.
#include "Haptics/Servo/SceneExchange.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

namespace
{
/// Counts its instances, and records its use and the thread that freed it.
class CountedScene
{
public:
  explicit CountedScene(int number)
    : Number(number)
  {
    ++Alive;
  }
  ~CountedScene()
  {
    EXPECT_EQ(std::this_thread::get_id(), this->Maker);
    EXPECT_FALSE(this->InUse);
    --Alive;
  }
  CountedScene(const CountedScene&) = delete;
  CountedScene& operator=(const CountedScene&) = delete;

  const int Number;
  bool InUse = false;
  std::unique_ptr<CountedScene> next;
  static std::atomic<int> Alive;

private:
  std::thread::id Maker = std::this_thread::get_id();
};
std::atomic<int> CountedScene::Alive{ 0 };

using Exchange = palpate::SceneExchange<CountedScene>;

std::unique_ptr<CountedScene> scene(int number)
{
  return std::make_unique<CountedScene>(number);
}
} // namespace

TEST(SceneExchange, TheNewestOfferWins)
{
  {
    Exchange exchange;
    EXPECT_EQ(exchange.take(), nullptr);
    exchange.offer(scene(1));
    exchange.offer(scene(2));
    EXPECT_EQ(CountedScene::Alive, 1) << "an offer that was not taken is freed by the next";
    std::unique_ptr<CountedScene> taken = exchange.take();
    ASSERT_NE(taken, nullptr);
    EXPECT_EQ(taken->Number, 2);
    EXPECT_EQ(exchange.take(), nullptr);
    exchange.giveBack(std::move(taken));
    EXPECT_EQ(CountedScene::Alive, 1);
    EXPECT_EQ(exchange.collect(), 1u);
    EXPECT_EQ(CountedScene::Alive, 0);
    exchange.offer(scene(3));
    exchange.offer(nullptr);
    EXPECT_EQ(exchange.take(), nullptr) << "withdrawn";
    exchange.offer(scene(4));
  }
  EXPECT_EQ(CountedScene::Alive, 0) << "an offer that nobody took";
}

TEST(SceneExchange, ListsThatComeBackBeforeACollectionAreJoined)
{
  {
    Exchange exchange;
    exchange.giveBack(nullptr);
    EXPECT_EQ(exchange.collect(), 0u);
    std::unique_ptr<CountedScene> two = scene(1);
    two->next = scene(2);
    exchange.giveBack(std::move(two));
    std::unique_ptr<CountedScene> three = scene(3);
    three->next = scene(4);
    three->next->next = scene(5);
    exchange.giveBack(std::move(three));
    EXPECT_EQ(CountedScene::Alive, 5);
    EXPECT_EQ(exchange.collect(), 5u);
    EXPECT_EQ(CountedScene::Alive, 0);
    exchange.giveBack(scene(6));
  }
  EXPECT_EQ(CountedScene::Alive, 0) << "what nobody collected";
}

TEST(SceneExchange, ThousandsBetweenThreads)
{
  constexpr int Offers = 20000;
  // Number of offers in quick succession, before waiting until one was taken.
  constexpr int Together = 8;
  int taken = 0;
  std::size_t collected = 0;
  std::atomic<int> newest{ 0 };
  {
    Exchange exchange;
    std::unique_ptr<CountedScene> first = scene(0);
    std::thread user(
      [&]
      {
        std::unique_ptr<CountedScene> current = std::move(first);
        current->InUse = true;
        while (newest.load(std::memory_order_relaxed) < Offers)
        {
          std::unique_ptr<CountedScene> offered = exchange.take();
          if (offered)
          {
            ASSERT_GT(offered->Number, newest.load(std::memory_order_relaxed));
            ++taken;
            current->InUse = false;
            exchange.giveBack(std::move(current));
            current = std::move(offered);
            current->InUse = true;
            newest.store(current->Number, std::memory_order_relaxed);
          }
        }
        current->InUse = false;
        exchange.giveBack(std::move(current));
      });
    for (int i = 1; i <= Offers; ++i)
    {
      exchange.offer(scene(i));
      collected += exchange.collect();
      while (i % Together == 0 && newest.load(std::memory_order_relaxed) < i)
      {
        std::this_thread::yield();
      }
    }
    user.join();
    collected += exchange.collect();
  }
  EXPECT_GE(taken, Offers / Together);
  EXPECT_EQ(collected, static_cast<std::size_t>(taken) + 1) << "and the first";
  EXPECT_EQ(CountedScene::Alive, 0);
}
