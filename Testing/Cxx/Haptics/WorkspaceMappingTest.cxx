// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/WorkspaceMapping.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
  // A quarter turn about z maps x to y. Then follow a scale of 2 and a translation.
  Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const WorkspaceMapping mapping(quarter, Vector3d(10, 20, 30), 2.0);
  EXPECT_EQ(mapping.toBody(Vector3d(0.5, 0.25, 0.125)), Vector3d(-490, 1020, 280));
  EXPECT_EQ(mapping.toDevice(Vector3d(-490, 1020, 280)), Vector3d(0.5, 0.25, 0.125));
  // A force along the body's y is a force along the device's x. Its magnitude does not depend on
  // the scale.
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
      // Rounding error of up to 600 mm, divided by 1000 scale.
      EXPECT_LE((mapping.toDevice(mapping.toBody(device)) - device).norm(), 1e-15 / scale);
      const Vector3d body = randomPoint(random, 100.0);
      EXPECT_LE((mapping.toBody(mapping.toDevice(body)) - body).norm(), 1e-12);
    }
  }
}

TEST(WorkspaceMapping, KeepsWorkUpToTheScale)
{
  // The work F·dx in the body is 1000·scale times that at the device: N mm and N m.
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
    EXPECT_NEAR(onBody, 1000.0 * scale * onDevice, 1e-9); // a few times 1e-16 of 10 N · 600 mm
    EXPECT_NEAR(mapping.forceToDevice(force).norm(), force.norm(), 1e-14);
  }
}

TEST(WorkspaceMapping, VelocityIsTheRateOfThePosition)
{
  std::mt19937 random(3);
  const WorkspaceMapping mapping(randomRotation(random), randomPoint(random, 100.0), 1.7);
  for (const WorkspaceMapping& each : { mapping, mapping.planar() })
  {
    const Vector3d from = randomPoint(random, 0.1);
    const Vector3d velocity = randomPoint(random, 1.0);
    const double step = 0.125; // s; the mapping is linear, so any step is valid
    const Vector3d rate = (each.toBody(from + step * velocity) - each.toBody(from)) / step;
    // Relative rounding 1e-16 of 300 mm, divided by step.
    EXPECT_LE((each.velocityToBody(velocity) - rate).norm(), 1e-10);
  }
}

TEST(WorkspaceMapping, StiffnessIsFeltScaled)
{
  // The device moves a spring of the body, K = 2 N/mm along y: dF/dx in the device's frame.
  std::mt19937 random(4);
  for (const double scale : { 0.2, 1.0, 3.0 })
  {
    const WorkspaceMapping mapping(randomRotation(random), randomPoint(random, 100.0), scale);
    const auto springForce = [&](const Vector3d& device)
    { return mapping.forceToDevice(Vector3d(0, -2.0 * mapping.toBody(device).y(), 0)); };
    const Vector3d along = mapping.forceToDevice(Vector3d::UnitY());
    const double step = 0.01; // m
    const double felt =
      (springForce(Vector3d::Zero()) - springForce(step * along)).dot(along) / step;
    // Relative rounding 1e-16 of 200 N over 10 mm.
    EXPECT_NEAR(mapping.stiffnessToDevice(2.0), felt, 1e-9 * felt);
    EXPECT_DOUBLE_EQ(mapping.stiffnessToDevice(2.0), 2000.0 * scale);
    EXPECT_DOUBLE_EQ(mapping.lengthToDevice(1000.0 * scale), 1.0);
    EXPECT_LE((mapping.forceToBody(along) - Vector3d::UnitY()).norm(), 1e-15);
  }
}

TEST(WorkspaceMapping, PlanarDevicesMoveInAPlaneOfTheBody)
{
  // The device's x is along the body's y, and its y along the body's z: the plane x = 7.
  const WorkspaceMapping mapping =
    WorkspaceMapping::inPlane(Vector3d(7, 1, 2), Vector3d::UnitY(), Vector3d::UnitZ(), 2.0);
  EXPECT_TRUE(mapping.isPlanar());
  EXPECT_FALSE(mapping.fault());
  // The z of the device has no effect.
  EXPECT_EQ(mapping.toBody(Vector3d(0.01, 0.02, 0.5)), Vector3d(7, 21, 42));
  EXPECT_EQ(mapping.toBody(Vector3d(0.01, 0.02, std::nan(""))), Vector3d(7, 21, 42));
  EXPECT_EQ(mapping.toDevice(Vector3d(-50, 21, 42)), Vector3d(0.01, 0.02, 0));
  EXPECT_EQ(mapping.velocityToBody(Vector3d(0.5, 0.25, 9)), Vector3d(0, 1000, 500));
  // Only the part of a force in the plane is passed on.
  EXPECT_EQ(mapping.forceToDevice(Vector3d(5, 3, -4)), Vector3d(3, -4, 0));
  EXPECT_EQ(mapping.forceToBody(Vector3d(3, -4, 11)), Vector3d(0, 3, -4));
  EXPECT_FALSE(WorkspaceMapping().isPlanar());
}

TEST(WorkspaceMapping, FitsABodyIntoTheWorkspace)
{
  std::mt19937 random(5);
  const Vector3d workspace(0.08, 0.06, 0.03);
  for (int i = 0; i < 100; ++i)
  {
    const Vector3d lower = randomPoint(random, 100.0);
    const Vector3d upper = lower + randomPoint(random, 50.0).cwiseAbs();
    const double margin = 0.1 * i;
    const WorkspaceMapping turned(randomRotation(random), Vector3d::Zero(), 1.0);
    for (const bool planar : { false, true })
    {
      const WorkspaceMapping mapping =
        (planar ? turned.planar() : turned).fitted(lower, upper, workspace, margin);
      ASSERT_FALSE(mapping.fault());
      EXPECT_EQ(mapping.rotation(), turned.rotation());
      // Check by enumeration: all corners, moved outward by the margin along the axes of the
      // device, are in the workspace, and the farthest corner is at its border.
      double farthest = 0.0;
      for (int corner = 0; corner < 8; ++corner)
      {
        const Vector3d place((corner & 1) != 0 ? lower.x() : upper.x(),
          (corner & 2) != 0 ? lower.y() : upper.y(), (corner & 4) != 0 ? lower.z() : upper.z());
        const Vector3d out = mapping.toDevice(place).cwiseAbs() +
          Vector3d::Constant(margin / (1000.0 * mapping.scale()));
        for (int axis = 0; axis < (planar ? 2 : 3); ++axis)
        {
          farthest = std::max(farthest, out[axis] / workspace[axis]);
        }
      }
      EXPECT_NEAR(farthest, 1.0, 1e-12); // relative rounding 1e-16 of 250 mm in 6 mm
      EXPECT_LE((mapping.toBody(Vector3d::Zero()) - 0.5 * (lower + upper)).norm(), 1e-13);
    }
  }
}

TEST(WorkspaceMapping, FaultsAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Matrix3d unit = Matrix3d::Identity();
  const Vector3d origin = Vector3d::Zero();
  EXPECT_FALSE(WorkspaceMapping().fault());
  Matrix3d mirror = unit;
  mirror(2, 2) = -1.0; // a device with left-handed axes
  EXPECT_FALSE(WorkspaceMapping(mirror, origin, 1.0).fault());
  Matrix3d typed;
  typed << 0.7071068, -0.7071068, 0, 0.7071068, 0.7071068, 0, 0, 0, 1; // rounded to seven digits
  EXPECT_FALSE(WorkspaceMapping(typed, origin, 1.0).fault());

  Matrix3d skew = unit;
  skew(0, 1) = 1e-3;
  Matrix3d hole = unit;
  hole(1, 1) = nan;
  for (const Matrix3d& wrong : { skew, hole, Matrix3d(2.0 * unit), Matrix3d(Matrix3d::Zero()) })
  {
    EXPECT_EQ(WorkspaceMapping(wrong, origin, 1.0).fault().name, "Rotation");
  }
  EXPECT_NE(
    WorkspaceMapping(2.0 * unit, origin, 1.0).fault().remark.find("off by 3"), std::string::npos);
  EXPECT_EQ(WorkspaceMapping(unit, Vector3d(0, infinity, 0), 1.0).fault().name, "Translation");
  for (const double wrong : { 0.0, -1.0, nan, infinity })
  {
    EXPECT_EQ(WorkspaceMapping(unit, origin, wrong).fault().name, "Scale") << wrong;
  }
  // Axes of a plane that are not perpendicular; a box with wrong bounds; no workspace; no margin.
  EXPECT_EQ(
    WorkspaceMapping::inPlane(origin, Vector3d::UnitX(), Vector3d(1, 1, 0).normalized(), 1.0)
      .fault()
      .name,
    "Rotation");
  const Vector3d one = Vector3d::Ones();
  const WorkspaceMapping usual;
  EXPECT_EQ(usual.fitted(one, -one, one, 0.0).fault().name, "Scale");
  EXPECT_EQ(usual.fitted(-one, one, Vector3d(0.1, 0.1, 0.0), 0.0).fault().name, "Scale");
  EXPECT_EQ(usual.fitted(-one, one, Vector3d(-0.1, 0.1, 0.1), 0.0).fault().name, "Scale");
  EXPECT_EQ(usual.fitted(-one, one, one, -1.0).fault().name, "Scale");
  EXPECT_EQ(usual.fitted(-one, one, one, nan).fault().name, "Scale");
  EXPECT_TRUE(usual.fitted(-one, nan * one, one, 0.0).fault());
  EXPECT_FALSE(usual.planar().fitted(-one, one, Vector3d(0.1, 0.1, 0.0), 0.0).fault());
}
