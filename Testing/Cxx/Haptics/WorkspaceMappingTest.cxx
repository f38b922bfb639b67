// SPDX-License-Identifier: BSD-3-Clause
#include "WorkspaceMapping.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

using Eigen::Matrix3d;
using Eigen::Vector3d;
using palpate::WorkspaceMapping;

namespace
{
Vector3d randomPoint(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> coordinate(-size, size);
  const double x = coordinate(random);
  const double y = coordinate(random);
  return { x, y, coordinate(random) };
}

Matrix3d randomRotation(std::mt19937& random)
{
  return Eigen::AngleAxisd(randomPoint(random, 3.0).x(), randomPoint(random, 1.0).normalized())
    .toRotationMatrix();
}
} // namespace

TEST(WorkspaceMapping, MetresBecomeMillimetres)
{
  const WorkspaceMapping mapping;
  EXPECT_EQ(mapping.toBody(Vector3d(0.001, -0.25, 1.0)), Vector3d(1.0, -250.0, 1000.0));
  EXPECT_EQ(mapping.toDevice(Vector3d(1.0, -250.0, 1000.0)), Vector3d(0.001, -0.25, 1.0));
  EXPECT_EQ(mapping.scale(), 1.0);
}

TEST(WorkspaceMapping, ByHand)
{
  // A quarter turn about z takes x to y; then twice the size; then moved.
  Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const WorkspaceMapping mapping(quarter, Vector3d(10, 20, 30), 2.0);
  EXPECT_EQ(mapping.toBody(Vector3d(0.5, 0.25, 0.125)), Vector3d(-490, 1020, 280));
  EXPECT_EQ(mapping.toDevice(Vector3d(-490, 1020, 280)), Vector3d(0.5, 0.25, 0.125));
  // A force along the body's y is one along the device's x, and keeps its size whatever the scale.
  EXPECT_EQ(mapping.forceToDevice(Vector3d(0, 3, 0)), Vector3d(3, 0, 0));
  EXPECT_EQ(mapping.scale(), 2.0);
}

TEST(WorkspaceMapping, ThereAndBack)
{
  std::mt19937 random(1);
  for (const double scale : { 0.1, 1.0, 5.0 })
  {
    for (int i = 0; i < 200; ++i)
    {
      const WorkspaceMapping mapping(randomRotation(random), randomPoint(random, 100.0), scale);
      const Vector3d device = randomPoint(random, 0.1);
      // Rounding of up to 600 mm, divided by 1000 scale.
      EXPECT_LE((mapping.toDevice(mapping.toBody(device)) - device).norm(), 1e-15 / scale);
      const Vector3d body = randomPoint(random, 100.0);
      EXPECT_LE((mapping.toBody(mapping.toDevice(body)) - body).norm(), 1e-12);
    }
  }
}

TEST(WorkspaceMapping, KeepsWorkUpToTheScale)
{
  // Work F·dx on the body's side is 1000·scale times that on the device's: N mm against N m.
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i)
  {
    const double scale = 0.5 + 0.01 * i;
    const WorkspaceMapping mapping(randomRotation(random), randomPoint(random, 100.0), scale);
    const Vector3d force = randomPoint(random, 10.0);
    const Vector3d from = randomPoint(random, 0.1);
    const Vector3d to = randomPoint(random, 0.1);
    const double onBody = force.dot(mapping.toBody(to) - mapping.toBody(from));
    const double onDevice = mapping.forceToDevice(force).dot(to - from);
    EXPECT_NEAR(onBody, 1000.0 * scale * onDevice, 1e-9); // 1e-16 of 10 N · 600 mm, times a few
    EXPECT_NEAR(mapping.forceToDevice(force).norm(), force.norm(), 1e-14);
  }
}
