// SPDX-License-Identifier: BSD-3-Clause
// After a change of body, tool or material under the tip, the force changes within 50 ms, without a
// jump.
#include "Haptics/Servo/SceneSwitch.h"

#include "Contact/CappedResponse.h"
#include "SampleResponses.h"
#include "StiffenedBody.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace palpate;
using palpate::Infinity;
using namespace palpate::testing;

namespace
{
constexpr double Period = 1e-3; // s
constexpr double PerTick = Period / 0.05;

std::unique_ptr<ServoScene> sceneOf(
  const std::shared_ptr<const ContactBody>& body, double forceFactor = 1.0, double friction = 0.0)
{
  ContactSettings settings;
  settings.friction.coefficient = friction;
  settings.friction.tangentialStiffness = 10.0; // N/mm
  return std::make_unique<ServoScene>(body, settings, forceFactor);
}

/// Presses 0.3 to 1.2 mm deep into a ball of 20 mm, and moves back and forth over it.
Vector3 tipAt(int tick)
{
  const double t = Period * tick;
  const double along = 0.1 * std::sin(9.0 * t);
  return (19.25 + 0.45 * std::sin(25.0 * t)) *
    Vector3(std::sin(along), std::cos(along) * std::sin(0.3), std::cos(along) * std::cos(0.3));
}

int count(std::unique_ptr<ServoScene> list)
{
  int scenes = 0;
  for (const ServoScene* scene = list.get(); scene; scene = scene->next.get())
  {
    ++scenes;
  }
  return scenes;
}

/// The force of a scene alone. Its contact starts from the contact of the previous scene.
struct Alone
{
  explicit Alone(const ServoScene& scene)
    : contact(*scene.body, scene.settings)
    , factor(scene.forceFactor)
  {
  }
  void update(const Vector3& tip)
  {
    this->before = this->sent;
    this->sent = this->factor * this->contact.update(tip).force;
  }

  ToolContact contact;
  double factor;
  Vector3 sent = Vector3::Zero();
  Vector3 before = Vector3::Zero();
};
} // namespace

TEST(SceneSwitch, WithoutAChangeItIsTheContactToTheBit)
{
  const auto body = stiffened(icosphere(20.0, 3), 1.0F);
  SceneSwitch scenes(sceneOf(body, 0.5, 0.4));
  Alone alone(*sceneOf(body, 0.5, 0.4));
  for (int i = 0; i < 300; ++i)
  {
    const SceneForce felt = scenes.update(tipAt(i), Period, Infinity);
    const Contact expected = alone.contact.update(tipAt(i));
    ASSERT_EQ(felt.contact.force, expected.force);
    EXPECT_EQ(felt.idealForce, expected.force);
    EXPECT_EQ(felt.cappedForce, expected.force);
    EXPECT_EQ(felt.contact.state, expected.state);
    EXPECT_EQ(felt.forceFactor, 0.5);
    EXPECT_EQ(felt.share, 1.0);
    EXPECT_FALSE(felt.changing || felt.outside);
  }
  EXPECT_EQ(scenes.changes(), 0U);
}

TEST(SceneSwitch, ForceGoesOverWithoutAStepFactorsIncluded)
{
  const Surface ball = icosphere(20.0, 3);
  const auto soft = stiffened(ball, 1.0F);
  const auto hard = stiffened(ball, 8.0F);
  for (const double friction : { 0.0, 0.5 })
  {
    for (const double factor : { 1.0, 0.1 }) // force factor of the hard scene
    {
      SceneSwitch scenes(sceneOf(soft, 1.0, friction));
      Alone before(*sceneOf(soft, 1.0, friction));
      Alone after(*sceneOf(hard, factor, friction));
      Vector3 last = Vector3::Zero();
      double leap = 0.0; // jump of the force without a ramp
      int ramped = 0;
      for (int i = 0; i < 200; ++i)
      {
        const Contact old = before.contact.update(tipAt(i));
        before.before = before.sent;
        before.sent = old.force;
        if (i == 100)
        {
          scenes.change(sceneOf(hard, factor, friction));
          EXPECT_TRUE(scenes.isSwitching());
          after.contact.update(old.contactPoint + 0.1 * (tipAt(i) - old.contactPoint));
          after.contact.assumeFriction(before.contact);
        }
        if (i >= 100)
        {
          after.update(tipAt(i));
        }
        const SceneForce felt = scenes.update(tipAt(i), Period, Infinity);
        const Vector3 sent = felt.forceFactor * felt.idealForce;
        const double way = std::min(1.0, PerTick * std::max(0, i - 100));
        // The force is the linear blend of the forces of both scenes.
        EXPECT_LE((sent - (1.0 - way) * before.sent - way * after.sent).norm(), 1e-12) << i;
        EXPECT_EQ(felt.changing, i > 100 && i <= 150);
        ramped += felt.share > 0.0 && felt.share < 1.0;
        if (i > 100)
        {
          // The step is at most the change by motion, plus T / 50 ms of the difference of both
          // scenes.
          const double motion =
            std::max((before.sent - before.before).norm(), (after.sent - after.before).norm());
          const double range = (after.before - before.before).norm();
          EXPECT_LE((sent - last).norm(), motion + range * PerTick + 1e-12) << i;
          EXPECT_LE((factor * felt.contact.force - after.sent).norm(), 1e-14) << "of the newest";
        }
        else if (i > 0)
        {
          EXPECT_LE((sent - last).norm(), (before.sent - before.before).norm() + 1e-12);
        }
        if (i == 100)
        {
          EXPECT_EQ(sent, before.sent) << "the first tick is the old one's";
          leap = (after.sent - before.sent).norm();
        }
        EXPECT_EQ(scenes.changes(), i < 100 ? 0U : 1U);
        last = sent;
      }
      EXPECT_GE(ramped, 49);
      EXPECT_FALSE(scenes.isSwitching());
      EXPECT_EQ(count(scenes.takeRetired()), 1);
      EXPECT_EQ(count(scenes.takeRetired()), 0);
      if (factor == 1.0)
      {
        EXPECT_GT(leap, 10.0); // N; the ramp allows 2 % of this jump per tick
      }
    }
  }
}

TEST(SceneSwitch, BothFitToTheDeviceTheBlendIsToo)
{
  // 10 N at factor 1 and 100 N at factor 0.1 give the same sent force of 10 N. If factor and force
  // were interpolated separately, the sent force would reach 30 N ((1+0.1)/2 of (10+100)/2).
  const Surface ball = icosphere(20.0, 3);
  SceneSwitch scenes(sceneOf(stiffened(ball, 1.0F)));
  const Vector3 still = tipAt(0);
  const double force = scenes.update(still, Period, Infinity).idealForce.norm();
  scenes.change(sceneOf(stiffened(ball, 10.0F), 0.1));
  for (int i = 0; i < 60; ++i)
  {
    const SceneForce felt = scenes.update(still, Period, Infinity);
    // Curves are stored as float32.
    EXPECT_NEAR(felt.forceFactor * felt.idealForce.norm(), force, 1e-6 * force);
  }
  EXPECT_FALSE(scenes.isSwitching());
}

TEST(SceneSwitch, StiffnessesAreCappedEachByItsOwnFactor)
{
  const Surface ball = icosphere(20.0, 3);
  const auto soft = stiffened(ball, 1.0F);
  const auto hard = stiffened(ball, 8.0F);
  const double limit = 12.0; // N/mm; 15 √δ and 120 √δ exceed it
  SceneSwitch scenes(sceneOf(soft));
  SceneSwitch reference(sceneOf(hard, 0.2));
  const Vector3 still = 19.0 * tipAt(0).normalized();
  const SceneForce alone = reference.update(still, Period, limit);
  ToolContact contact(*hard);
  const Contact felt = contact.update(still);
  const CappedResponse curve(contact.response(), limit / 0.2);
  EXPECT_LE((alone.cappedForce - curve.evaluate(felt.deflection).force * felt.normal).norm(), 1e-9);
  EXPECT_LT(alone.cappedForce.norm(), 0.9 * alone.idealForce.norm());

  const SceneForce first = scenes.update(still, Period, limit);
  EXPECT_LT(first.cappedForce.norm(), first.idealForce.norm());
  scenes.change(sceneOf(hard, 0.2));
  for (int i = 0; i <= 25; ++i)
  {
    const SceneForce mixed = scenes.update(still, Period, limit);
    const double way = PerTick * i;
    const Vector3 line = (1.0 - way) * first.cappedForce + way * 0.2 * alone.cappedForce;
    EXPECT_LE((mixed.forceFactor * mixed.cappedForce - line).norm(), 1e-12);
  }
}

TEST(SceneSwitch, TheNewestOfThoseThatWaitIsTakenAfterTheRamp)
{
  const Surface ball = icosphere(20.0, 3);
  std::vector<std::shared_ptr<const ContactBody>> bodies;
  for (const float factor : { 1.0F, 4.0F, 20.0F, 2.0F })
  {
    bodies.push_back(stiffened(ball, factor));
  }
  SceneSwitch scenes(sceneOf(bodies[0]));
  Vector3 last = scenes.update(tipAt(0), Period, Infinity).idealForce;
  const double force = last.norm();
  scenes.change(nullptr); // no effect
  EXPECT_FALSE(scenes.isSwitching());
  scenes.change(sceneOf(bodies[1]));
  std::vector<double> felt;
  for (int i = 0; i < 130; ++i)
  {
    if (i == 10)
    {
      scenes.change(sceneOf(bodies[2]));
      EXPECT_EQ(count(scenes.takeRetired()), 0);
    }
    if (i == 20) // replaces the third scene, which is never used
    {
      scenes.change(sceneOf(bodies[3]));
      EXPECT_EQ(count(scenes.takeRetired()), 1);
    }
    const Vector3 now = scenes.update(tipAt(0), Period, Infinity).idealForce;
    // The largest change is from 1 to 4.
    EXPECT_LE((now - last).norm(), 3.0 * force * PerTick + 1e-6);
    last = now;
    felt.push_back(now.norm() / force);
  }
  EXPECT_NEAR(felt[0], 1.0, 1e-6);  // float32 curves, as below
  EXPECT_NEAR(felt[25], 2.5, 1e-5); // in the middle of the ramp
  EXPECT_NEAR(*std::max_element(felt.begin(), felt.end()), 4.0, 1e-5);
  EXPECT_NEAR(felt[49], 4.0, 0.061); // at the end of the ramp, less one tick
  EXPECT_NEAR(felt.back(), 2.0, 1e-5);
  EXPECT_EQ(scenes.changes(), 2U);
  EXPECT_FALSE(scenes.isSwitching());
  EXPECT_EQ(count(scenes.takeRetired()), 2);
}

TEST(SceneSwitch, TheSideOfAThinBodyIsKept)
{
  const Surface slab = subdivided(block(40, 40, 3), 4);
  SceneSwitch scenes(sceneOf(stiffened(slab, 1.0F)));
  scenes.update(Vector3(20.3, 18.7, 2.0), Period, Infinity);
  // Beyond the middle; the contact remains on the top, where it began.
  const Vector3 deep(20.3, 18.7, 1.2);
  EXPECT_GT(scenes.update(deep, Period, Infinity).idealForce.z(), 0.0);
  scenes.change(sceneOf(stiffened(slab, 2.0F)));
  for (int i = 0; i < 60; ++i)
  {
    const SceneForce felt = scenes.update(deep, Period, Infinity);
    ASSERT_GT(felt.idealForce.z(), 0.0) << i;
    EXPECT_NEAR(felt.contact.deflection, 1.8, 1e-6);
  }
  // On another body, the contact does not continue on this side: a new contact begins.
  scenes.change(sceneOf(stiffened(subdivided(block(40, 40, 2.5), 4), 1.0F)));
  for (int i = 0; i < 60; ++i)
  {
    scenes.update(deep, Period, Infinity);
  }
  EXPECT_EQ(scenes.update(deep, Period, Infinity).contact.state, ContactState::Slide);
}

TEST(SceneSwitch, FrictionContinuesWithinTheLimitOfTheNewContact)
{
  const auto body = stiffened(subdivided(block(40, 40, 10), 4), 1.0F);
  const auto with = [&body](FrictionModel model, double coefficient, double stiffness)
  {
    ContactSettings settings;
    settings.friction.model = model;
    settings.friction.coefficient = coefficient;
    settings.friction.tangentialStiffness = stiffness;
    return std::make_unique<ServoScene>(body, settings);
  };
  // The old contact slides at μ 10 N = 5 N, with z = 0.5 mm at 10 N/mm.
  const struct
  {
    FrictionModel model;
    double coefficient;
    double stiffness;                                             // N/mm
    double expected;                                              // N
  } cases[] = { { FrictionModel::ElastoPlastic, 0.5, 10.0, 5.0 }, // the same
    { FrictionModel::ElastoPlastic, 0.2, 10.0, 2.0 },             // the limit
    { FrictionModel::ElastoPlastic, 0.5, 20.0, 5.0 },             // stiffer: the force is kept
    { FrictionModel::ElastoPlastic, 0.5, 4.0, 2.0 },   // softer: the displacement is kept
    { FrictionModel::Dahl, 0.5, 4.0, 2.0 },            // the same z
    { FrictionModel::ElastoPlastic, 0.0, 10.0, 0.0 },  // no friction
    { FrictionModel::ShapeDerived, 0.5, 10.0, 0.0 } }; // other displacements: from rest
  for (const auto& next : cases)
  {
    SceneSwitch scenes(with(FrictionModel::ElastoPlastic, 0.5, 10.0));
    Vector3 tip(15.0, 20.0, 9.0);
    for (int i = 0; i < 1000; ++i) // slides 5 mm
    {
      tip.x() += 0.005;
      scenes.update(tip, Period, Infinity);
    }
    EXPECT_NEAR(scenes.update(tip, Period, Infinity).contact.friction.x(), -5.0, 1e-3); // float32
    scenes.change(with(next.model, next.coefficient, next.stiffness));
    for (int i = 0; i <= 50; ++i) // the tip is at rest
    {
      const SceneForce felt = scenes.update(tip, Period, Infinity);
      EXPECT_NEAR(felt.contact.friction.x(), -next.expected, 1e-3);
      EXPECT_NEAR(
        felt.idealForce.x(), -(1.0 - PerTick * i) * 5.0 - PerTick * i * next.expected, 2e-3);
    }
  }
}

TEST(SceneSwitch, StuckFrictionFromTheResponseContinues)
{
  const auto body = stiffened(subdivided(block(40, 40, 10), 4), 1.0F);
  ContactSettings settings;
  settings.friction.model = FrictionModel::ShapeDerived;
  settings.friction.coefficient = 0.5;
  SceneSwitch scenes(std::make_unique<ServoScene>(body, settings));
  Vector3 tip(15.0, 20.0, 9.0);
  scenes.update(tip, Period, Infinity);
  tip.x() += 0.05; // of μ c δ = 0.75 mm at which it slides
  const double stuck = scenes.update(tip, Period, Infinity).contact.friction.x();
  EXPECT_LT(stuck, -0.1);
  scenes.change(std::make_unique<ServoScene>(body, settings));
  for (int i = 0; i <= 50; ++i)
  {
    EXPECT_NEAR(scenes.update(tip, Period, Infinity).contact.friction.x(), stuck, 1e-9);
  }
  // A smaller Poisson's ratio: c falls from 1.5 to 1, the tangential springs are 1.5 times as
  // stiff, and they keep their force.
  settings.friction.poissonRatio = 0.0;
  scenes.change(std::make_unique<ServoScene>(body, settings));
  EXPECT_NEAR(scenes.update(tip, Period, Infinity).contact.friction.x(), stuck, 1e-9);
}

TEST(SceneSwitch, ReachIsWhatTheContactCanGiveBack)
{
  const Surface slab = subdivided(block(40, 40, 10), 4);
  const auto body = stiffened(slab, 1.0F);
  SceneSwitch smooth(sceneOf(body));
  SceneSwitch rough(sceneOf(body, 1.0, 0.5));
  const Vector3 tip(20.0, 20.0, 9.0);
  EXPECT_NEAR(smooth.update(tip, Period, Infinity).reach, 1.0, 1e-6);
  rough.update(tip, Period, Infinity);
  const SceneForce stretched = rough.update(tip + Vector3(0.3, 0, 0), Period, Infinity);
  EXPECT_NEAR(stretched.reach, 1.3, 1e-6); // below breakaway the distance moved by the tip is added
  EXPECT_EQ(smooth.update(Vector3(20, 20, 11), Period, Infinity).reach, 0.0);
  EXPECT_TRUE(smooth.update(Vector3(20, 20, 11), Period, Infinity).outside);
}

TEST(SceneSwitch, ForgettingEndsTheRampAndFreesNothing)
{
  const auto body = stiffened(icosphere(20.0, 2), 1.0F);
  const auto other = stiffened(icosphere(20.0, 2), 2.0F);
  SceneSwitch scenes(sceneOf(body));
  scenes.update(tipAt(0), Period, Infinity);
  scenes.change(sceneOf(body));
  scenes.change(sceneOf(other));
  scenes.update(tipAt(1), Period, Infinity);
  const SceneSwitch copy(scenes);
  EXPECT_TRUE(copy.isSwitching());
  EXPECT_EQ(other.use_count(), 3); // references: this variable, the waiting scene, and its copy
  scenes.forget();
  EXPECT_FALSE(scenes.isSwitching());
  EXPECT_EQ(scenes.changes(), 2U);
  EXPECT_TRUE(copy.isSwitching());
  const SceneForce felt = scenes.update(tipAt(2), Period, Infinity);
  EXPECT_EQ(felt.share, 1.0);
  EXPECT_EQ(felt.idealForce, ToolContact(*other).update(tipAt(2)).force) << "the newest of all";
  // References: this variable, both discarded scenes, and the two scenes of the copy
  EXPECT_EQ(body.use_count(), 5);
  EXPECT_EQ(count(scenes.takeRetired()), 2);
  EXPECT_EQ(body.use_count(), 3);
}

TEST(SceneSwitch, OutsideAndTouchingAreOfBoth)
{
  // The tip is 1 mm above the small ball and 1 mm inside the large one.
  SceneSwitch scenes(sceneOf(stiffened(icosphere(20.0, 3), 1.0F)));
  const Vector3 tip(0.0, 0.0, 21.0);
  EXPECT_TRUE(scenes.update(tip, Period, Infinity).outside);
  scenes.change(sceneOf(stiffened(icosphere(22.0, 3), 1.0F)));
  double last = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    const SceneForce felt = scenes.update(tip, Period, Infinity);
    EXPECT_FALSE(felt.outside);
    EXPECT_EQ(felt.contact.state, ContactState::Slide);
    // A change of 10 N over 50 ms.
    EXPECT_LE(std::abs(felt.idealForce.z() - last), 10.0 * PerTick + 1e-6);
    last = felt.idealForce.z();
  }
  EXPECT_GT(last, 9.5); // 10 δ^1.5, less the sag of the facets
  // During the change back, the tip is "outside" only after the ramp.
  scenes.change(sceneOf(stiffened(icosphere(20.0, 3), 1.0F)));
  for (int i = 0; i < 60; ++i)
  {
    const SceneForce felt = scenes.update(tip, Period, Infinity);
    EXPECT_EQ(felt.contact.state, ContactState::None);
    EXPECT_EQ(felt.outside, !scenes.isSwitching());
    EXPECT_EQ(felt.outside, felt.idealForce == Vector3::Zero());
  }
  EXPECT_FALSE(scenes.isSwitching());
}

TEST(SceneSwitch, AFactorOutOfItsRangeGivesNoForce)
{
  const auto body = stiffened(icosphere(20.0, 2), 1.0F);
  for (const double factor : { 0.0, -1.0, 1.5, std::nan("") })
  {
    SceneSwitch scenes(sceneOf(body));
    scenes.update(tipAt(0), Period, Infinity);
    scenes.change(sceneOf(body, factor));
    for (int i = 0; i < 60; ++i)
    {
      const SceneForce felt = scenes.update(tipAt(0), Period, 5.0);
      EXPECT_TRUE(felt.idealForce.allFinite() && felt.cappedForce.allFinite());
      EXPECT_NEAR(felt.forceFactor, std::max(0.0, 1.0 - PerTick * i), 1e-12);
    }
  }
}
