// SPDX-License-Identifier: BSD-3-Clause
// Force and torque have a common energy account. The promise holds for any motion and any scene.
// Without torque the results do not change.
#include "Haptics/Safety/PassivityControl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace passivity_torque
{
using Eigen::Vector3d;
using namespace palpate;

namespace
{
constexpr double Stiffest = 2000.0; // N/m
constexpr double Torsion = 0.5;     // N m/rad
constexpr double Period = 1e-3;     // s

class Anything
{
public:
  explicit Anything(unsigned seed)
    : Random(seed)
  {
  }
  double normal() { return this->Gauss(this->Random); }
  Vector3d vector(double size)
  {
    const double x = this->normal();
    const double y = this->normal();
    return size * Vector3d(x, y, this->normal());
  }

private:
  std::mt19937 Random;
  std::normal_distribution<double> Gauss;
};
} // namespace

TEST(PassivityTorque, NoSceneAndNoMotionGetsMoreOutThanWentIn)
{
  // Some forces and torques act along the hand's next motion, which is the most active case. Others
  // are independent of the motion. Turns are about one axis, so that the work is exactly M · φ.
  int cut = 0;
  for (unsigned seed = 0; seed < 24; ++seed)
  {
    Anything any(seed);
    PassivityControl control(Stiffest, Period, 0.0, Torsion);
    const Vector3d about = any.vector(1.0).normalized();
    const double leap = std::pow(10.0, -1.0 - seed % 4); // rad
    Vector3d place = Vector3d::Zero();
    double angle = 0.0;
    double given = 0.0;
    double damping = 0.0;
    for (int i = 0; i < 3000; ++i)
    {
      const Vector3d way = any.vector(seed % 3 == 0 ? 1e-5 : 1e-4);
      const double turn = leap * any.normal();
      control.observe(Period * i, place, turnedBy(angle * about));
      const bool knows = seed % 2 == 0;
      Wrench wanted{ knows ? Vector3d(3.0 * way.normalized()) : any.vector(2.0),
        knows ? Vector3d(std::copysign(0.05, turn) * about) : any.vector(0.03) };
      const Wrench sent = control.limit(wanted);
      control.sent(Period * i, sent);
      cut += sent.force != wanted.force ? 1 : 0;
      // One factor applies to both and is at most 1.
      const double share = sent.force.norm() / wanted.force.norm();
      ASSERT_LE(share, 1.0 + 1e-15);
      ASSERT_LE((sent.torque - share * wanted.torque).norm(), 1e-15);
      given += sent.force.dot(way) + sent.torque.dot(turn * about);
      damping += 0.5 * Stiffest * way.squaredNorm() + 0.5 * Torsion * turn * turn;
      place += way;
      angle += turn;
      // 1e-10 is for the rounding of an angle that has changed by some rad, relative 1e-15 in each
      // tick.
      ASSERT_LE(given, damping + PassivityControl::Slack + 1e-10) << seed << ' ' << i;
    }
  }
  EXPECT_GT(cut, 10000); // of 72000 ticks; the control was needed
}

TEST(PassivityTorque, CountsTheWorkOfBothInEachHold)
{
  PassivityControl control(Stiffest, Period, 0.0, Torsion);
  control.observe(0.0, Vector3d::Zero(), ToolOrientation::Identity());
  control.grant(2.0, 1e-3, 0.1); // 2 mJ; the energies of springs, F²/2K = 1 mJ and M²/2K_θ = 10 mJ,
                                 // are larger together
  EXPECT_NEAR(control.energy(), 11e-3, 1e-15);
  const Wrench sent{ Vector3d(0.0, 0.0, 1.0), Vector3d(0.05, 0.0, 0.0) };
  control.sent(0.0, sent);
  control.observe(Period, Vector3d(0.0, 0.0, 1e-3), turnedBy(Vector3d(0.02, 0.0, 0.0)));
  const double work = 1.0 * 1e-3 + 0.05 * 0.02;
  const double damping = 0.5 * Stiffest * 1e-6 + 0.5 * Torsion * 4e-4;
  EXPECT_NEAR(control.energy(), 11e-3 - work + damping, 1e-15);
  // A turn that is not reported may have given M²/2K_θ. It gets no credit.
  control.sent(Period, sent);
  control.observe(2.0 * Period, Vector3d(0.0, 0.0, 1e-3));
  EXPECT_NEAR(control.energy(), 11e-3 - work + damping - 0.05 * 0.05 / (2.0 * Torsion), 1e-15);
}

TEST(PassivityTorque, WhatWasPressedInIsTurnedOutOnce)
{
  // A scene with a grant of 6.25 mJ, F²/2K for 5 N, turns the hand continuously.
  PassivityControl control(Stiffest, Period, 0.0, Torsion);
  control.observe(0.0, Vector3d::Zero(), ToolOrientation::Identity());
  control.grant(5.0, 0.0);
  const double whole = 5.0 * 5.0 / (2.0 * Stiffest);
  constexpr double Turn = 1e-3; // rad per tick
  double given = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const Wrench sent = control.limit(Wrench{ Vector3d::Zero(), Vector3d(0.05, 0.0, 0.0) });
    control.sent(Period * i, sent);
    given += sent.torque.x() * Turn;
    const Vector3d angle(Turn * (i + 1), 0.0, 0.0);
    control.observe(Period * (i + 1), Vector3d::Zero(), turnedBy(angle));
  }
  const double damping = 1000 * 0.5 * Torsion * Turn * Turn;
  EXPECT_LE(given, whole + damping + PassivityControl::Slack + 1e-12); // 1e-12 for rounding
  EXPECT_GT(given, 0.9 * whole);                                       // nearly all of it
}

TEST(PassivityTorque, DoesNothingToASpringOfForceAndTorque)
{
  // U = ½ K_max z² + ½ K_θ θ² is the stiffest allowed potential. Here U = ½ (½K z² + 2 · ½√(K K_θ)
  // z θ + ½K_θ θ²): half of each term, plus a coupling. Its largest stiffness in scaled coordinates
  // is also K.
  PassivityControl control(Stiffest, Period, 0.0, Torsion);
  const double both = 0.5 * std::sqrt(Stiffest * Torsion);
  Anything any(1);
  for (int i = 0; i < 20000; ++i)
  {
    const double t = Period * i;
    const double z = 2e-3 * std::sin(20.0 * t) + 1e-5 * any.normal();
    const double angle = 0.1 * std::sin(33.0 * t) + 1e-3 * any.normal();
    const Wrench spring{ Vector3d(0.0, 0.0, -0.5 * Stiffest * z - both * angle),
      Vector3d(-0.5 * Torsion * angle - both * z, 0.0, 0.0) };
    control.observe(t, Vector3d(0.0, 0.0, z), turnedBy(Vector3d(angle, 0.0, 0.0)));
    if (i == 0)
    {
      control.grant(spring.force.norm(), 0.0, spring.torque.norm());
    }
    const Wrench sent = control.limit(spring);
    ASSERT_EQ(sent.force, spring.force) << i;
    ASSERT_EQ(sent.torque, spring.torque) << i;
    control.sent(t, sent);
  }
}

TEST(PassivityTorque, WithoutTorqueAllIsAsBefore)
{
  for (const double delay : { 0.0, 2.5e-3 })
  {
    Anything any(8);
    PassivityControl plain(Stiffest, Period, delay);
    PassivityControl turning(Stiffest, Period, delay, Torsion);
    Vector3d place = Vector3d::Zero();
    for (int i = 0; i < 5000; ++i)
    {
      const double t = Period * i;
      place += any.vector(1e-4);
      const Vector3d wanted = any.vector(2.0);
      plain.observe(t, place);
      turning.observe(t, place); // without an orientation, so no turn is counted
      plain.bound(wanted.norm(), 1e-3);
      turning.bound(wanted.norm(), 1e-3);
      const Vector3d sent = plain.limit(wanted);
      const Wrench same = turning.limit(Wrench{ wanted, Vector3d::Zero() });
      ASSERT_EQ(sent, same.force);
      ASSERT_EQ(same.torque, Vector3d::Zero());
      plain.sent(t, sent);
      turning.sent(t, same);
      ASSERT_EQ(plain.energy(), turning.energy());
      ASSERT_EQ(plain.holdTime(), turning.holdTime());
      if (i % 97 == 0)
      {
        plain.interrupt(t + 0.5 * Period);
        turning.interrupt(t + 0.5 * Period);
      }
    }
  }
}

TEST(PassivityTorque, LimitsThatAreNone)
{
  const Wrench wanted{ Vector3d(1.0, 0.0, 0.0), Vector3d(0.0, 0.2, 0.0) };
  PassivityControl none(Stiffest, Period);
  EXPECT_EQ(none.limit(wanted).torque, Vector3d::Zero());
  PassivityControl negative(Stiffest, Period, 0.0, -1.0);
  EXPECT_EQ(negative.limit(wanted).torque, Vector3d::Zero());
  const double infinity = std::numeric_limits<double>::infinity();
  PassivityControl unlimited(infinity, Period, 0.0, Torsion);
  EXPECT_EQ(unlimited.limit(wanted).force, wanted.force);
  EXPECT_EQ(unlimited.limit(wanted).torque, wanted.torque);
  PassivityControl uncounted(Stiffest, Period, 0.0, infinity);
  EXPECT_EQ(uncounted.limit(wanted).torque, wanted.torque);
  EXPECT_LT(uncounted.limit(wanted).force.norm(), 1e-2); // no energy has been put in
}
} // namespace passivity_torque
