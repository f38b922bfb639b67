// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

namespace simulated_device
{
using Eigen::Vector3d;
using palpate::DeviceSample;
using palpate::Infinity;
using palpate::NotANumber;
using palpate::SimulatedDevice;

namespace
{
SimulatedDevice threePoints()
{
  return SimulatedDevice(
    { { 1.0, { 0.0, 0.0, 0.0 } }, { 2.0, { 0.0, 0.0, -0.5 } }, { 4.0, { 1.0, 0.0, -0.5 } } });
}
} // namespace

TEST(SimulatedDevice, LinearBetweenWayPoints)
{
  SimulatedDevice device = threePoints();
  // Quarters and halves are exact in binary.
  EXPECT_EQ(device.read(1.0).position, Vector3d(0, 0, 0));
  EXPECT_EQ(device.read(1.25).position, Vector3d(0, 0, -0.125));
  EXPECT_EQ(device.read(2.0).position, Vector3d(0, 0, -0.5));
  EXPECT_EQ(device.read(2.5).position, Vector3d(0.25, 0, -0.5));
  EXPECT_EQ(device.read(3.0).position, Vector3d(0.5, 0, -0.5));
  EXPECT_TRUE(device.read(3.0).valid);
}

TEST(SimulatedDevice, RestsAtTheEnds)
{
  SimulatedDevice device = threePoints();
  for (const double time : { -1e9, 0.0, 0.999 })
  {
    EXPECT_EQ(device.read(time).position, Vector3d(0, 0, 0));
    EXPECT_TRUE(device.read(time).valid);
  }
  for (const double time : { 4.0, 4.5, 1e9 })
  {
    EXPECT_EQ(device.read(time).position, Vector3d(1.0, 0, -0.5));
    EXPECT_TRUE(device.read(time).valid);
  }
  EXPECT_EQ(device.duration(), 4.0);
}

TEST(SimulatedDevice, DependsOnTheTimeAlone)
{
  SimulatedDevice device = threePoints();
  const Vector3d first = device.read(1.7).position;
  device.read(3.9);
  device.write(Vector3d(1, 2, 3));
  EXPECT_EQ(device.read(1.7).position, first);
}

TEST(SimulatedDevice, JumpsWhereTimesCoincide)
{
  SimulatedDevice device(
    { { 0.0, { 0, 0, 0 } }, { 1.0, { 1, 0, 0 } }, { 1.0, { 5, 0, 0 } }, { 2.0, { 6, 0, 0 } } });
  EXPECT_EQ(device.read(std::nextafter(1.0, 0.0)).position.x(), std::nextafter(1.0, 0.0));
  EXPECT_EQ(device.read(1.0).position.x(), 5.0);
  EXPECT_EQ(device.read(1.5).position.x(), 5.5);
}

TEST(SimulatedDevice, EmptyPath)
{
  SimulatedDevice device(std::vector<palpate::WayPoint>{});
  EXPECT_FALSE(device.read(0.0).valid);
  EXPECT_EQ(device.read(0.0).position, Vector3d::Zero());
  EXPECT_EQ(device.duration(), 0.0);
}

TEST(SimulatedDevice, OneWayPoint)
{
  SimulatedDevice device({ { 3.0, { 1, 2, 3 } } });
  for (const double time : { 0.0, 3.0, 9.0 })
  {
    EXPECT_EQ(device.read(time).position, Vector3d(1, 2, 3));
  }
}

TEST(SimulatedDevice, TimesThatAreNotFinite)
{
  SimulatedDevice device = threePoints();
  for (const double time : { NotANumber, Infinity, -Infinity })
  {
    const DeviceSample sample = device.read(time);
    EXPECT_FALSE(sample.valid);
    EXPECT_EQ(sample.position, Vector3d::Zero());
  }
}

TEST(SimulatedDevice, KeepsTheLastForce)
{
  SimulatedDevice device = threePoints();
  EXPECT_EQ(device.lastForce(), Vector3d::Zero());
  EXPECT_TRUE(device.write(Vector3d(0, 0, 2.5)));
  EXPECT_EQ(device.lastForce(), Vector3d(0, 0, 2.5));
}

TEST(SimulatedDevice, StatesTheSpecificationItWasGiven)
{
  palpate::DeviceSpecification given;
  given.maximumForce = 3.3;
  given.rate = 4000.0;
  const SimulatedDevice device(std::vector<palpate::WayPoint>{}, given);
  EXPECT_EQ(device.specification().maximumForce, 3.3);
  EXPECT_EQ(device.specification().rate, 4000.0);
}
} // namespace simulated_device
