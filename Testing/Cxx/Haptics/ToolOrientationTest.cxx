// SPDX-License-Identifier: BSD-3-Clause
// Turns of a tool, compared with rotation matrices and with angles computed by hand. Also a hand
// whose orientation is steered.
#include "Haptics/Devices/SteeredAxis.h"
#include "Haptics/Devices/TimedPath.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tool_orientation
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using namespace palpate;
using palpate::NotANumber;

namespace
{
constexpr double Rounding = 1e-14; ///< rounding error of a dozen operations on numbers up to π

Vector3d anyDirection(std::mt19937& random)
{
  std::normal_distribution<double> gauss;
  const double x = gauss(random);
  const double y = gauss(random);
  return Vector3d(x, y, gauss(random)).normalized();
}

double angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}
} // namespace

TEST(ToolOrientation, TheShaftIsTheToolsOwnZ)
{
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3d axis = anyDirection(random);
    EXPECT_LE((shaftOf(orientationAlong(7.0 * axis)) - axis).norm(), Rounding);
    const Matrix3d turn =
      Eigen::AngleAxisd(3.0 * axis.x(), anyDirection(random)).toRotationMatrix();
    ToolOrientation told(turn);
    told.coeffs() *= 1.0 + 1e-4 * axis.y(); // a device may have rounded the quaternion
    EXPECT_LE((shaftOf(told) - turn.col(2)).norm(), Rounding);
  }
  EXPECT_FALSE(isTold(orientationAlong(Vector3d::Zero())));
  EXPECT_FALSE(isTold(orientationAlong(Vector3d(NotANumber, 0.0, 1.0))));
  EXPECT_TRUE(isTold(ToolOrientation(NotANumber, 0.0, 0.0, 0.0)));
  EXPECT_EQ(shaftOf(orientationNotTold()), Vector3d::Zero());
  EXPECT_EQ(shaftOf(ToolOrientation(1.0, NotANumber, 0.0, 0.0)), Vector3d::Zero());
  EXPECT_LE((shaftOf(orientationAlong(-Vector3d::UnitZ())) + Vector3d::UnitZ()).norm(), Rounding);
}

TEST(ToolOrientation, TurnsAreRotationVectors)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-9.0, 0.49); // angles up to 3.1 rad, less than π
  for (int i = 0; i < 500; ++i)
  {
    const double angle = std::pow(10.0, exponent(random));
    const Vector3d turn = angle * anyDirection(random);
    const ToolOrientation from(Eigen::AngleAxisd(2.0, anyDirection(random)).toRotationMatrix());
    EXPECT_LE((turnedBy(turn).toRotationMatrix() -
                Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix())
                .norm(),
      Rounding);
    ToolOrientation to = turnedBy(turn) * from;
    EXPECT_LE((turnBetween(from, to) - turn).norm(), Rounding);
    to.coeffs() = -to.coeffs(); // the same orientation
    EXPECT_LE((turnBetween(from, to) - turn).norm(), Rounding);
  }
  EXPECT_EQ(turnedBy(Vector3d::Zero()).coeffs(), ToolOrientation::Identity().coeffs());
}

TEST(ToolOrientation, LeastTurns)
{
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3d from = anyDirection(random);
    const Vector3d to = i % 20 == 0 ? Vector3d(-from) : anyDirection(random);
    const Vector3d turn = leastTurn(from, 3.0 * to);
    EXPECT_LE((turnedBy(turn) * from - to).norm(), Rounding);
    EXPECT_NEAR(turn.norm(), angleBetween(from, to), Rounding);
  }
  EXPECT_EQ(leastTurn(Vector3d::UnitX(), Vector3d::UnitX()), Vector3d::Zero());
}

TEST(ToolOrientation, ASteeredHandTurnsAsItMoves)
{
  SimulatedDevice hand(Vector3d(0.0, 0.0, 0.01));
  EXPECT_FALSE(isTold(hand.read(0.0).orientation));
  hand.turnTo(Vector3d(0.0, 0.0, 2.0));
  EXPECT_LE(
    // The first orientation is set immediately.
    (shaftOf(hand.read(0.001).orientation) - Vector3d::UnitZ()).norm(), Rounding);
  const Vector3d told = Vector3d(1.0, 2.0, 3.0).normalized();
  const double whole = angleBetween(Vector3d::UnitZ(), told);
  hand.turnTo(told);
  for (int i = 1; i <= 200; ++i)
  {
    const Vector3d shaft = shaftOf(hand.read(0.001 * (i + 1)).orientation);
    // The angle follows the law of SteeredTarget. Each tick has a rounding error.
    EXPECT_NEAR(angleBetween(shaft, told), whole * std::exp(-0.001 * i / 0.03), 1e-12);
    EXPECT_NEAR(shaft.dot(Vector3d::UnitZ().cross(told)), 0.0, 1e-12); // along the shortest path
  }
  hand.turnTo(-shaftOf(hand.read(0.202).orientation)); // towards the opposite direction
  EXPECT_NEAR(shaftOf(hand.read(0.203).orientation).norm(), 1.0, Rounding);
  const Vector3d held = shaftOf(hand.read(0.3).orientation);
  hand.turnTo(Vector3d(NotANumber, 0.0, 0.0));
  EXPECT_GT(shaftOf(hand.read(0.301).orientation).dot(held), 0.99);
  hand.turnTo(Vector3d::Zero());
  EXPECT_FALSE(isTold(hand.read(0.302).orientation));
}

TEST(ToolOrientation, APathTurnsEvenly)
{
  const double angle = 0.6;
  const Vector3d end(std::sin(angle), 0.0, std::cos(angle));
  SimulatedDevice hand({ { 0.0, Vector3d::Zero(), 5.0 * Vector3d::UnitZ() },
    { 1.0, Vector3d::UnitX(), end }, { 2.0, Vector3d::UnitX() } });
  for (const double share : { 0.0, 0.1, 0.5, 0.9 })
  {
    const Vector3d shaft = shaftOf(hand.read(share).orientation);
    const Vector3d expected(std::sin(share * angle), 0.0, std::cos(share * angle));
    EXPECT_LE((shaft - expected).norm(), Rounding) << share;
  }
  EXPECT_FALSE(isTold(hand.read(1.5).orientation));
  EXPECT_FALSE(isTold(hand.read(2.5).orientation));
  EXPECT_EQ(TimedPath({}).axisAt(0.0), Vector3d::Zero());
  EXPECT_NE(TimedPath({ { 0.0, Vector3d::Zero(), Vector3d(NotANumber, 0.0, 0.0) } }).fault(), "");
}
} // namespace tool_orientation
