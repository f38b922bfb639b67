// SPDX-License-Identifier: BSD-3-Clause
// A running servo loop receives other scenes. It renders the newest scene. The owner frees all
// scenes. This test also runs with the sanitizers.
#include "SampleResponses.h"
#include "Haptics/Servo/ServoLoop.h"
#include "StandingDevice.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
const Vector3d Inside(0.0, 0.0, 0.0195); // m: half a millimetre deep in a ball of 20 mm

/// Makes scenes that record, when they are freed, whether the right thread frees them.
class SceneSource
{
public:
  std::unique_ptr<ServoScene> make(const std::shared_ptr<const ContactBody>& body)
  {
    ++this->Made;
    const auto freed = [this, body](const ContactBody*)
    {
      this->Freed.fetch_add(1);
      this->Elsewhere.fetch_add(std::this_thread::get_id() == this->Owner ? 0 : 1);
    };
    return std::make_unique<ServoScene>(
      std::shared_ptr<const ContactBody>(body.get(), freed), ContactSettings());
  }

  const std::thread::id Owner = std::this_thread::get_id();
  int Made = 0;
  std::atomic<int> Freed{ 0 };
  std::atomic<int> Elsewhere{ 0 };
};

std::shared_ptr<const ContactBody> bodyOf(float factor)
{
  const Surface ball = icosphere(20.0, 3);
  ResponseStore store(ball.points.size());
  store.normalsFromPoints(ball);
  for (float& force : store.force)
  {
    force *= factor;
  }
  for (float& stiffness : store.stiffness)
  {
    stiffness *= factor;
  }
  return contactBody(ball, store);
}

ServoStep stepOn(SceneSource& source, const std::shared_ptr<const ContactBody>& body)
{
  return { source.make(body), WorkspaceMapping(), SafetySettings::magnitudeOnly(100.0) };
}
} // namespace

TEST(SceneChange, TheNewSceneIsRenderedAndTheOldOneFreed)
{
  const auto soft = bodyOf(1.0F);
  const auto hard = bodyOf(2.0F);
  SceneSource source;
  StandingDevice device(Inside);
  {
    ServoLoop loop(device, stepOn(source, soft), 4000.0);
    ASSERT_EQ(loop.start(), "");
    waitForTicks(loop, 20);
    const double before = loop.newest().appliedForce.norm();
    EXPECT_GT(before, 1.0);
    loop.changeScene(source.make(hard));
    while (loop.freeScenes() == 0)
    {
      std::this_thread::yield(); // waits for the ramp of 50 ms
    }
    waitForTicks(loop, loop.ticks() + 2);
    const Tick& after = loop.newest();
    EXPECT_EQ(after.scene, 1u);
    EXPECT_EQ(after.sceneShare, 1.0);
    // A body with twice the stiffness gives twice the force, up to the rounding at the end of the
    // ramp.
    EXPECT_NEAR(after.appliedForce.norm(), 2.0 * before, 1e-9);
    EXPECT_EQ(source.Freed, 1);
    EXPECT_EQ(loop.statistics().sceneChanges, 1u);
  }
  EXPECT_EQ(source.Freed, source.Made);
  EXPECT_EQ(source.Elsewhere, 0);
}

TEST(SceneChange, OneOfferedToALoopThatRestsIsRenderedFromItsStart)
{
  const auto soft = bodyOf(1.0F);
  const auto hard = bodyOf(2.0F);
  SceneSource source;
  StandingDevice device(Inside);
  {
    ServoLoop loop(device, stepOn(source, soft), 4000.0);
    loop.changeScene(source.make(hard));
    loop.changeScene(source.make(hard));
    EXPECT_EQ(source.Freed, 1) << "the first was not taken";
    ASSERT_EQ(loop.start(), "");
    while (loop.freeScenes() == 0)
    {
      std::this_thread::yield();
    }
    EXPECT_EQ(loop.newest().scene, 1u);
    EXPECT_EQ(source.Freed, 2);
    loop.changeScene(source.make(soft)); // the scene is freed once, whether the loop uses it or not
    loop.stop();
  }
  EXPECT_EQ(source.Freed, source.Made);
  EXPECT_EQ(source.Elsewhere, 0);
}

TEST(SceneChange, ThousandsWhileTheLoopRuns)
{
  constexpr int Changes = 4000;
  const auto soft = bodyOf(1.0F);
  const auto hard = bodyOf(2.0F);
  SceneSource source;
  StandingDevice device(Inside);
  std::uint64_t taken = 0;
  {
    ServoLoop loop(device, stepOn(source, soft), 8000.0);
    ASSERT_EQ(loop.start(), "");
    for (int i = 1; i <= Changes; ++i)
    {
      loop.changeScene(source.make(i % 2 == 0 ? soft : hard));
      if (i % 4 == 0) // four changes in quick succession, then a change that is certainly used
      {
        waitForTicks(loop, loop.ticks() + 2);
      }
    }
    // The last scene is rendered at the end. Changes is even, so the last scene is the soft one.
    const double expected =
      stepOn(source, soft).step(StandingDevice(Inside).read(0.0), 0.0).appliedForce.norm();
    while (loop.newest().sceneShare < 1.0 || loop.newest().appliedForce.norm() != expected)
    {
      std::this_thread::yield();
    }
    taken = loop.statistics().sceneChanges;
  }
  EXPECT_GE(taken, static_cast<std::uint64_t>(Changes / 4));
  EXPECT_EQ(source.Freed, source.Made);
  EXPECT_EQ(source.Elsewhere, 0);
  EXPECT_EQ(device.Last, Vector3d::Zero());
}
