// SPDX-License-Identifier: BSD-3-Clause
// The two links that depend only on the force: the limits of its magnitude and of its rate.
#include "Haptics/Safety/SafetyLinks.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

namespace force_limits
{
using Eigen::Vector3d;
using palpate::ForceLimit;
using palpate::ForceRateLimit;
using palpate::Infinity;
using palpate::NotANumber;

TEST(ForceLimit, KeepsTheDirection)
{
  const ForceLimit limit(2.5);
  EXPECT_EQ(limit.limit(Vector3d(0.7, -0.2, 1.9)), Vector3d(0.7, -0.2, 1.9));
  EXPECT_EQ(limit.limit(Vector3d(0.0, 2.5, 0.0)), Vector3d(0.0, 2.5, 0.0));
  const Vector3d large(3.0, -4.0, 12.0); // magnitude 13 N
  EXPECT_LE((limit.limit(large) - 2.5 / 13.0 * large).norm(), 1e-15);
  EXPECT_EQ(limit.limit(Vector3d::Zero()), Vector3d::Zero());
  // A value whose sum of squares overflows.
  EXPECT_NEAR(limit.limit(Vector3d(1e200, 0.0, 0.0)).x(), 2.5, 1e-15);
}

TEST(ForceLimit, LimitsThatAreNone)
{
  const Vector3d force(1.0, 2.0, 3.0);
  EXPECT_EQ(ForceLimit(Infinity).limit(force), force);
  for (const double none : { 0.0, -1.0, NotANumber, -Infinity })
  {
    EXPECT_EQ(ForceLimit(none).limit(force), Vector3d::Zero()) << none;
    EXPECT_EQ(ForceLimit(none).limit(Vector3d::Zero()), Vector3d::Zero()) << none;
  }
}

TEST(ForceRateLimit, RisesAndFallsAlongTheStraightLine)
{
  ForceRateLimit slew(100.0); // 0.1 N per ms
  const Vector3d target(3.0, 0.0, 4.0);
  EXPECT_EQ(slew.limit(0.0, target), Vector3d::Zero()); // no time has passed
  slew.sent(0.0, Vector3d::Zero());
  for (int tick = 1; tick <= 49; ++tick)
  {
    const Vector3d force = slew.limit(1e-3 * tick, target);
    EXPECT_LE((force - 0.02 * tick * target).norm(), 1e-12);
    slew.sent(1e-3 * tick, force);
  }
  EXPECT_EQ(slew.limit(0.0501, target), target);
  slew.sent(0.050, target);
  EXPECT_EQ(slew.limit(0.050, -target), target); // the time of the previous call
  EXPECT_LE((slew.limit(0.060, -target) - 0.8 * target).norm(), 1e-12);
  EXPECT_EQ(slew.limit(0.15001, -target), -target);
}

TEST(ForceRateLimit, StartsFromWhatWasSent)
{
  ForceRateLimit slew(100.0);
  slew.sent(1.0, Vector3d(0.0, 0.0, 5.0));
  slew.sent(1.001, Vector3d(0.0, 0.0, 1.0)); // reduced by another link
  EXPECT_NEAR(slew.limit(1.002, Vector3d(0.0, 0.0, 5.0)).z(), 1.1, 1e-12);
  slew.reset();
  EXPECT_EQ(slew.limit(1.003, Vector3d(0.0, 0.0, 5.0)), Vector3d::Zero());
  slew.sent(1.003, Vector3d::Zero());
  EXPECT_NEAR(slew.limit(1.004, Vector3d(0.0, 0.0, 5.0)).z(), 0.1, 1e-12);
}

TEST(ForceRateLimit, LimitsThatAreNone)
{
  const Vector3d force(1.0, 2.0, 3.0);
  ForceRateLimit unlimited(Infinity);
  EXPECT_EQ(unlimited.limit(0.0, force), force);
  EXPECT_EQ(unlimited.limit(NotANumber, force), force); // the time is not used
  for (const double none : { 0.0, -1.0, NotANumber, -Infinity })
  {
    ForceRateLimit slew(none);
    slew.sent(0.0, Vector3d::Zero());
    EXPECT_EQ(slew.limit(1.0, force), Vector3d::Zero()) << none;
  }
}
} // namespace force_limits
