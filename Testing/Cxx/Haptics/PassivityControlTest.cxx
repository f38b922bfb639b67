// SPDX-License-Identifier: BSD-3-Clause
// For any scene, no motion gets more energy from the sent forces than the hand put in plus the
// energy that the device's own damping dissipates. A passive scene is not changed.
#include "Haptics/Safety/PassivityControl.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace passivity_control
{
using Eigen::Vector3d;
using palpate::ForcesUnderWay;
using palpate::Infinity;
using palpate::NotANumber;
using palpate::PassivityControl;

namespace
{
constexpr double Stiffest = 2000.0; // N/m
constexpr double Period = 1e-3;     // s

/// Runs a control and computes the energies independently: the work of the sent forces, and the
/// minimum of the energy that the damping of the device dissipates.
struct Audit
{
  PassivityControl control{ Stiffest, Period };
  double given = 0.0;   ///< work on the hand, J
  double damping = 0.0; ///< b |d|²/T
  int cut = 0;
  Vector3d sent = Vector3d::Zero();

  Vector3d tick(int i, const Vector3d& position, const Vector3d& force, double depth = Infinity)
  {
    if (i > 0)
    {
      const Vector3d moved = position - this->Last;
      this->given += this->sent.dot(moved);
      this->damping += 0.5 * Stiffest * moved.squaredNorm();
    }
    this->Last = position;
    this->control.observe(Period * i, position);
    this->control.bound(force.norm(), depth);
    this->sent = this->control.limit(force);
    this->cut += this->sent != force;
    this->control.sent(Period * i, this->sent);
    return this->sent;
  }

private:
  Vector3d Last = Vector3d::Zero();
};

/// Motions of all kinds: smooth, noisy, jumping, at rest except for one encoder step.
class Motion
{
public:
  explicit Motion(unsigned seed)
    : Random(seed)
    , Kind(static_cast<int>(seed % 4))
  {
  }
  Vector3d next()
  {
    const Vector3d noise(this->Gauss(Random), this->Gauss(Random), this->Gauss(Random));
    switch (this->Kind)
    {
      case 0: // up to about 0.3 m/s
        this->Velocity += 2e-5 * noise - 0.02 * this->Velocity - 2e-4 * this->Place;
        this->Place += this->Velocity;
        break;
      case 1:
        this->Place = 0.9 * this->Place + 1e-3 * noise;
        break;
      case 2:
        this->Place = 4e-3 * noise;
        break;
      default:
        this->Velocity = 0.995 * this->Velocity + 2e-6 * noise - 3e-5 * this->Place;
        this->Place += this->Velocity;
        return (this->Place / 2e-5).array().round() * 2e-5;
    }
    return this->Place;
  }

private:
  std::mt19937 Random;
  std::normal_distribution<double> Gauss;
  int Kind;
  Vector3d Place = Vector3d(0.0, 0.0, 2e-3);
  Vector3d Velocity = Vector3d::Zero();
};
} // namespace

TEST(PassivityControl, CountsTheExactWorkOfEachHold)
{
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  PassivityControl control(Stiffest, Period);
  Vector3d last = Vector3d::Zero();
  Vector3d sent = Vector3d::Zero();
  double energy = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3d place = 1e-3 * Vector3d(gauss(random), gauss(random), gauss(random));
    control.observe(Period * i, place);
    energy += i > 0 ? 0.5 * Stiffest * (place - last).squaredNorm() - sent.dot(place - last) : 0.0;
    // Rounding error of a thousand sums of about 1e-2 J, and of the duration of the hold (relative
    // 1e-13).
    ASSERT_NEAR(control.energy(), energy, 1e-12);
    sent = Vector3d(gauss(random), gauss(random), gauss(random));
    control.sent(Period * i, sent);
    last = place;
  }
}

TEST(PassivityControl, TicksWithoutANewReadingCountByTheirMean)
{
  PassivityControl control(Stiffest, Period);
  control.observe(0.0, Vector3d::Zero());
  control.sent(0.0, Vector3d(1.0, 0.0, 0.0));
  control.sent(0.001, Vector3d(2.0, 0.0, 0.0));
  control.sent(0.003, Vector3d(5.0, 0.0, 0.0));
  control.observe(0.004, Vector3d(1e-3, 7.0, 0.0) - Vector3d(0.0, 7.0, 0.0));
  // 1 N for 1 ms, 2 N for 2 ms and 5 N for 1 ms have a mean of 2.5 N, over 1 mm. A hold of 4 T has
  // a quarter of the credit.
  EXPECT_NEAR(control.energy(), 0.25 * 0.5 * Stiffest * 1e-6 - 2.5e-3, 1e-15);
}

TEST(PassivityControl, NoSceneAndNoMotionGetsMoreOutThanWentIn)
{
  // Some forces are independent of the motion. The others are the most active possible: they act
  // along the hand's next motion.
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    Audit audit;
    Motion motion(seed);
    std::mt19937 random(seed + 99);
    std::normal_distribution<double> gauss;
    const bool knows = seed % 3 != 0;
    double asked = 0.0;
    Vector3d place = motion.next();
    for (int i = 0; i < 4000; ++i)
    {
      const Vector3d next = motion.next();
      const Vector3d noise(gauss(random), gauss(random), gauss(random));
      const Vector3d wanted =
        knows ? Vector3d(3.0 * (next - place).normalized() + 0.3 * noise) : Vector3d(3.0 * noise);
      const Vector3d sent = audit.tick(i, place, wanted);
      asked += wanted.dot(next - place);
      place = next;
      // The full promise, for every hold so far: the energy given to the hand is at most the energy
      // put in, plus the dissipated energy, plus the Slack that is not reclaimed. 1e-12 is for
      // rounding.
      ASSERT_LE(audit.given, audit.damping + PassivityControl::Slack + 1e-12) << seed << ' ' << i;
      // The control only reduces the force. The direction does not change, and the magnitude does
      // not increase.
      ASSERT_LE(sent.norm(), wanted.norm() * (1.0 + 1e-15));
      ASSERT_NEAR(sent.dot(wanted), sent.norm() * wanted.norm(), 1e-14 * wanted.squaredNorm());
    }
    if (knows && seed % 4 != 2) // for jumps of some mm per tick, the damping alone dissipates more
    {
      EXPECT_GT(asked, 0.1);
      EXPECT_GT(audit.cut, 500) << seed;
    }
  }
}

TEST(PassivityControl, TheWorstThrow)
{
  // The hand is pressed 1 mm into a spring. Then an active scene requests more force, and the hand
  // is moved along the force over various distances. They include the worst distance, F/K_max
  // divided by the fraction of the damping.
  for (const double asked : { 2.0, 2.05, 2.5, 6.0 })
  {
    for (double way = 0.2; way < 3.0; way += 0.05)
    {
      Audit audit;
      int i = 0;
      for (; i <= 20; ++i)
      {
        const double depth = 5e-5 * i;
        audit.tick(i, Vector3d(0.0, 0.0, -depth), Vector3d(0.0, 0.0, Stiffest * depth));
      }
      Vector3d place(0.0, 0.0, -1e-3);
      for (; i <= 30; ++i)
      {
        const Vector3d sent = audit.tick(i, place, Vector3d(0.0, 0.0, asked));
        place += way / Stiffest * sent;
      }
      EXPECT_LE(audit.given, audit.damping + PassivityControl::Slack + 1e-15)
        << asked << ' ' << way;
    }
  }
}

TEST(PassivityControl, DoesNothingOnAPassiveScene)
{
  // Potentials U with second derivatives up to K_max, and F = -∇U: a tool in a half-space of the
  // largest stiffness, softer half-spaces, the law of a sphere, a ball, a corner of two planes, a
  // bounded force, a valley that is entered from its edge (everywhere inside).
  const auto along = [](double force, const Vector3d& direction) -> Vector3d
  { return force * direction; };
  struct Scene
  {
    std::function<Vector3d(const Vector3d&)> force;
    std::function<double(const Vector3d&)> depth;
  };
  const auto below = [](const Vector3d& p) { return std::max(0.0, -p.z()); };
  const auto inBall = [](const Vector3d& p) { return std::max(0.0, 0.006 - p.norm()); };
  const double most = 0.02; // m; deeper than the motions
  const Scene scenes[] = {
    { [&](const Vector3d& p) { return along(Stiffest * below(p), Vector3d::UnitZ()); }, below },
    { [&](const Vector3d& p) { return along(150.0 * below(p), Vector3d::UnitZ()); }, below },
    { [&](const Vector3d& p) {
       return along(Stiffest / 1.5 / std::sqrt(most) * std::pow(below(p), 1.5), Vector3d::UnitZ());
     },
      below },
    { [&](const Vector3d& p) -> Vector3d
      { return p.norm() > 0.0 ? along(Stiffest * inBall(p), p.normalized()) : Vector3d::Zero(); },
      inBall },
    { [&](const Vector3d& p)
      { return along(std::min(1.3, Stiffest * below(p)), Vector3d::UnitZ()); },
      below },
    { [&](const Vector3d& p) -> Vector3d { return -Stiffest * p; },
      [](const Vector3d& p) { return p.norm(); } },
    { [&](const Vector3d& p) -> Vector3d
      { return Stiffest * Vector3d(std::max(0.0, -p.x()), 0.0, std::max(0.0, -p.z())); },
      [](const Vector3d& p) { return std::hypot(std::max(0.0, -p.x()), std::max(0.0, -p.z())); } },
  };
  for (const Scene& scene : scenes)
  {
    for (const bool knowsDepth : { false, true })
    {
      for (unsigned seed = 0; seed < 12; ++seed)
      {
        Audit audit;
        Motion motion(seed);
        double strongest = 0.0;
        for (int i = 0; i < 4000; ++i)
        {
          const Vector3d place =
            i == 0 ? Vector3d(0.0, 0.0, &scene == &scenes[5] ? 0.0 : 0.01) : motion.next();
          const Vector3d force = scene.force(place);
          const double depth = knowsDepth ? scene.depth(place) : Infinity;
          ASSERT_EQ(audit.tick(i, place, force, depth), force)
            << &scene - scenes << ' ' << seed << ' ' << i;
          strongest = std::max(strongest, force.norm());
        }
        EXPECT_GT(strongest, 0.05) << &scene - scenes << ' ' << seed;
      }
    }
  }
}

TEST(PassivityControl, TheHoldLeaksWhatTheDampingTakes)
{
  // A press and release of a linear spring at speed v gives F_max v T to the hand. The observed
  // energy E ends above zero, because the device's own damping has dissipated K_max v T x_max.
  const double stiffness = 1500.0;
  const double speed = 0.1; // 0.1 mm per tick
  const int turn = 50;      // 5 mm
  Audit audit;
  for (int i = 0; i <= 2 * turn; ++i)
  {
    const double depth = speed * Period * (i <= turn ? i : 2 * turn - i);
    audit.tick(i, Vector3d(0.0, 0.0, -depth), Vector3d(0.0, 0.0, stiffness * depth));
  }
  const double largest = stiffness * speed * Period * turn;
  EXPECT_NEAR(audit.given, largest * speed * Period, 1e-12);
  EXPECT_NEAR(audit.damping, Stiffest / stiffness * largest * speed * Period, 1e-12);
  EXPECT_EQ(audit.cut, 0);
}

TEST(PassivityControl, AnOverStiffSpringIsFeltAsOneThatIsNot)
{
  // For a scene that is five times too stiff, half of the damping and half of the allowed stiffness
  // are left. For a scene that is slightly too stiff, most of the stiffness is left.
  for (const double share : { 5.0, 1.1 })
  {
    Audit audit;
    const double speed = 0.05;
    for (int i = 0; i <= 100; ++i)
    {
      const double depth = speed * Period * i;
      const Vector3d sent =
        audit.tick(i, Vector3d(0.0, 0.0, -depth), Vector3d(0.0, 0.0, share * Stiffest * depth));
      EXPECT_LE(sent.z(), Stiffest * depth + 2.1e-3); // √(2 K_max Slack) = 2 mN
      EXPECT_GE(sent.z(), (share > 2.0 ? 0.5 : 0.8) * Stiffest * depth);
    }
    EXPECT_GT(audit.cut, 95);
  }
}

TEST(PassivityControl, WhatFrictionTookIsNotLent)
{
  // A force of up to 5 N opposes the hand over 5 mm, like friction: 12.5 mJ. Then the scene pushes
  // with 5 N at a depth of 2 mm. It may return 5 N over 2 mm.
  for (const bool knowsDepth : { true, false })
  {
    Audit audit;
    const double depth = knowsDepth ? 2e-3 : Infinity;
    int i = 0;
    for (; i < 100; ++i)
    {
      audit.tick(i, Vector3d(5e-5 * i, 0.0, 0.0), Vector3d(-0.05 * i, 0.0, 0.0), depth);
    }
    const double before = audit.given;
    for (; i < 400; ++i)
    {
      audit.tick(i, Vector3d(5e-5 * i, 0.0, 0.0), Vector3d(5.0, 0.0, 0.0), depth);
    }
    const double credit = 300 * 0.5 * Stiffest * 5e-5 * 5e-5;
    EXPECT_EQ(audit.given - before <= 10e-3 + credit + 1e-8, knowsDepth);
  }
}

TEST(PassivityControl, GrantsWhatIsChangedOnPurpose)
{
  PassivityControl control(Stiffest, Period);
  const Vector3d force(0.0, 0.0, 4.0);
  control.observe(0.0, Vector3d::Zero());
  EXPECT_LE(control.limit(force).norm(), 2.1e-3); // √(2 K_max Slack)
  control.grant(4.0, Infinity);
  EXPECT_NEAR(control.energy(), 0.5 * 16.0 / Stiffest, 1e-15);
  EXPECT_EQ(control.limit(force), force);
  control.grant(4.0, 3e-3); // more, because the depth is known
  EXPECT_NEAR(control.energy(), 12e-3, 1e-15);
  control.grant(4.0, 1e-3); // a smaller energy changes nothing
  EXPECT_NEAR(control.energy(), 12e-3, 1e-15);
  control.bound(4.0, 2e-3);
  EXPECT_NEAR(control.energy(), 8e-3, 1e-15);
  control.bound(0.0, Infinity);
  EXPECT_EQ(control.energy(), 0.0);
}

TEST(PassivityControl, ALateHoldIsPaidFor)
{
  // The hand is pressed 1 mm into the stiffest spring, then moved outward by 3 mm within one hold
  // of ten periods.
  PassivityControl control(Stiffest, Period);
  int i = 0;
  for (; i <= 20; ++i)
  {
    const double depth = 5e-5 * i;
    control.observe(Period * i, Vector3d(0.0, 0.0, -depth));
    const Vector3d force(0.0, 0.0, Stiffest * depth);
    ASSERT_EQ(control.limit(force), force);
    control.sent(Period * i, force);
  }
  const double before = control.energy();
  const double late = Period * (i + 9);
  control.observe(late, Vector3d(0.0, 0.0, 2e-3));
  // The loss in this hold: 2 N over 3 mm, less a tenth of the credit for 3 mm.
  const double after = before - 2.0 * 3e-3 + 0.1 * 0.5 * Stiffest * 9e-6;
  EXPECT_NEAR(control.energy(), after, 1e-12);
  EXPECT_LT(after, 0.0);
  EXPECT_EQ(control.limit(Vector3d(0.0, 0.0, 1.0)), Vector3d::Zero());
  control.sent(late, Vector3d::Zero());
  control.bound(0.0, 0.0); // outside: a debt remains
  EXPECT_NEAR(control.energy(), after, 1e-12);
  // Motion of 2 mm at 1 mm per tick repays 1 mJ per tick.
  control.observe(late + Period, Vector3d(0.0, 0.0, 3e-3));
  EXPECT_NEAR(control.energy(), after + 1e-3, 1e-12);
}

TEST(PassivityControl, LimitsThatAreNone)
{
  const Vector3d force(0.0, 3.0, 4.0);
  PassivityControl unlimited(Infinity, Period);
  for (int i = 0; i < 10; ++i)
  {
    unlimited.observe(Period * i, Vector3d(1e-3 * i, 0.0, 0.0));
    unlimited.bound(5.0, Infinity);
    EXPECT_EQ(unlimited.limit(force), force);
    unlimited.sent(Period * i, force);
    EXPECT_EQ(unlimited.energy(), 0.0);
  }
  for (const double none : { 0.0, -1.0, NotANumber })
  {
    PassivityControl control(none, Period);
    control.observe(0.0, Vector3d::Zero());
    control.grant(5.0, 1.0);
    control.observe(Period, Vector3d(1e-3, 0.0, 0.0));
    EXPECT_EQ(control.limit(force), Vector3d::Zero()) << none;
  }
  // After a jump whose square overflows, the energy is still a number, and the force is zero.
  PassivityControl jumped(Stiffest, Period);
  jumped.observe(0.0, Vector3d::Zero());
  jumped.sent(0.0, force);
  jumped.observe(Period, Vector3d(1e200, 1e200, 0.0));
  EXPECT_EQ(jumped.energy(), 0.0);
  EXPECT_TRUE(jumped.limit(force).allFinite());
  EXPECT_FALSE(jumped.isNew());
  jumped.reset();
  EXPECT_TRUE(jumped.isNew());
}

// Determined by trial: no larger force keeps the sum of squares within the bound.
TEST(PassivityControl, ForcesUnderWayLeaveRoomForOneMore)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> upTo(0.0, 3.0);
  for (int n = 1; n <= 8; ++n)
  {
    ForcesUnderWay forces(n * Period, Period);
    EXPECT_EQ(forces.late(), static_cast<std::size_t>(n));
    std::vector<double> sent; // sent forces, newest first
    for (int i = 0; i < 200; ++i)
    {
      const double size = upTo(random);
      forces.sent({ Vector3d(0.0, size, 0.0), Vector3d::Zero() });
      sent.insert(sent.begin(), size);
      const auto sum = [&](double next)
      {
        double squares = 0.0;
        for (int hold = 0; hold <= n; ++hold)
        {
          double most = next;
          for (int age = 0; age < n - hold && age < static_cast<int>(sent.size()); ++age)
          {
            most = std::max(most, sent[static_cast<std::size_t>(age)]);
          }
          squares += most * most;
        }
        return squares;
      };
      const double square = 3.0 * n * upTo(random);
      const double found = forces.largestWithin(square);
      if (found > 0.0)
      {
        ASSERT_LE(sum(found), square * (1.0 + 1e-12));
        ASSERT_GT(sum(found * 1.001 + 1e-9), square);
      }
      else
      {
        ASSERT_GE(sum(0.0), square * (1.0 - 1e-12));
      }
    }
  }
  EXPECT_EQ(ForcesUnderWay(NotANumber, Period).late(), 0U);
  EXPECT_EQ(ForcesUnderWay(-1.0, Period).late(), 0U);
  EXPECT_EQ(ForcesUnderWay(1.0, Period).late(), ForcesUnderWay::Most);
  EXPECT_EQ(ForcesUnderWay(1e-3 + 1e-15, Period).late(), 1U); // rounding adds no tick
}

// Forces act up to n ticks late, at random. The hand gains no more energy than the device's damping
// dissipates, as long as its motion is possible for a real hand.
TEST(PassivityControl, AStatedDelayGivesNoEnergy)
{
  double withoutBound = 0.0;
  for (const int late : { 1, 2, 5 })
  {
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
      for (const bool isTold : { true, false })
      {
        std::mt19937 random(seed);
        std::normal_distribution<double> gauss;
        PassivityControl control(Stiffest, Period, isTold ? late * Period : 0.0);
        std::vector<Vector3d> sent = { Vector3d::Zero() };
        Vector3d place(0.0, 0.0, 2e-3);
        Vector3d velocity = Vector3d::Zero();
        double given = 0.0;
        double most = 0.0;
        double forces = 0.0;
        for (int i = 0; i < 20000; ++i)
        {
          if (i > 0)
          {
            // Back and forth through the surface, with at most 20 m/s².
            Vector3d push(gauss(random), gauss(random), gauss(random));
            push = 5e-3 * push - 2.0 * place - 0.01 * velocity;
            velocity += push / std::max(1.0, push.norm() / 0.02);
            const Vector3d moved = Period * velocity;
            place += moved;
            const std::size_t age =
              std::min<std::size_t>(random() % static_cast<unsigned>(late + 1), sent.size() - 1);
            given += sent[sent.size() - 1 - age].dot(moved) - 0.5 * Stiffest * moved.squaredNorm();
            most = std::max(most, given);
          }
          const double depth = std::max(0.0, -place.z());
          const Vector3d wanted(0.0, 0.0, 0.6 * Stiffest * depth);
          control.observe(Period * i, place);
          control.bound(wanted.norm(), depth);
          sent.push_back(control.limit(wanted));
          forces += sent.back().norm();
          control.sent(Period * i, sent.back());
          given = depth == 0.0 ? std::min(given, 0.0) : given; // a new contact has no debt
        }
        EXPECT_GT(forces / 20000.0, 0.05) << late << " " << seed;
        if (isTold)
        {
          EXPECT_LE(most, 2.0 * PassivityControl::Slack) << late << " " << seed;
        }
        else
        {
          withoutBound = std::max(withoutBound, most);
        }
      }
    }
  }
  EXPECT_GT(withoutBound, 1e-6); // J; without the stated delay the promise is not kept
}

// If the force is held for the returned time, it gives the hand at most the energy put in, for any
// motion that a hand can make. Here the hand moves along the force as fast as possible.
TEST(PassivityControl, AForceIsToldForAsLongAsItIsPaidFor)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int finite = 0;
  for (int i = 0; i < 500; ++i)
  {
    PassivityControl control(Stiffest, Period);
    // First into the body, then further in or out.
    const double speed = 0.3 * (2.0 * share(random) - 1.0);
    double depth = 0.0;
    double time = 0.0;
    double force = 0.0;
    for (int tick = 0; tick < 60; ++tick)
    {
      depth = std::max(0.0, depth + Period * (tick < 50 ? 0.1 : speed));
      control.observe(time, Vector3d(0.0, 0.0, -depth));
      const Vector3d wanted(0.0, 0.0, 0.4 * Stiffest * depth);
      control.bound(wanted.norm(), depth);
      const Vector3d sent = control.limit(wanted);
      control.sent(time, sent);
      force = sent.z();
      time += Period;
    }
    const double hold = control.holdTime();
    if (force == 0.0)
    {
      EXPECT_EQ(hold, Infinity);
      continue;
    }
    ++finite;
    const double acceleration =
      PassivityControl::HandAcceleration + force / PassivityControl::LightestHandle;
    const double way =
      std::max(0.0, -speed) * hold + 0.5 * acceleration * hold * hold; // outward, along the force
    EXPECT_LE(force * way, control.energy() * (1.0 + 1e-9));
    EXPECT_GT(force * way * 1.01, control.energy()) << "no shorter than need be";
  }
  EXPECT_GT(finite, 300);
  EXPECT_EQ(PassivityControl(Infinity, Period).holdTime(), Infinity);
}
} // namespace passivity_control
