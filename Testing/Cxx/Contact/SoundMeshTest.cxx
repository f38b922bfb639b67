// SPDX-License-Identifier: BSD-3-Clause
// The orientation of each part, cavities, second bodies, sheets and duplicates. Also random damage,
// after which the distances are those of the body without damage.
#include "BumpySphere.h"
#include "Contact/SoundMesh.h"
#include "Contact/TriangleTree.h"
#include "SampleBodies.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace palpate::testing
{
namespace SoundMeshTest
{
SoundMesh repaired(const Surface& body)
{
  return SoundMesh(body.points.front().data(), body.points.size(), body.triangles.front().data(),
    body.triangles.size());
}

Surface reversed(Surface body)
{
  for (auto& corners : body.triangles)
  {
    std::swap(corners[1], corners[2]);
  }
  return body;
}

/// The body without the triangles whose corners are all above a height.
Surface cutAbove(Surface body, double height)
{
  const Surface given = body;
  body.triangles.erase(std::remove_if(body.triangles.begin(), body.triangles.end(),
                         [&](const auto& corners)
                         {
                           return std::all_of(corners.begin(), corners.end(),
                             [&](std::int32_t i)
                             { return given.points[static_cast<std::size_t>(i)].z() > height; });
                         }),
    body.triangles.end());
  return body;
}

double signedDistance(const Surface& body, const Vector3& tip)
{
  const PackedMesh mesh = body.packed();
  return TriangleTree(mesh).closest(tip).signedDistance;
}
} // namespace SoundMeshTest
using namespace SoundMeshTest;

TEST(SoundMesh, ASoundBodyStaysAsItIs)
{
  const Surface body = torus(20.0, 6.0, 24, 12);
  const SoundMesh mesh = repaired(body);
  EXPECT_EQ(mesh.fault(), "");
  EXPECT_FALSE(mesh.hasJoinedPoints());
  EXPECT_EQ(mesh.defects().turnedTriangles + mesh.defects().repeatedTriangles, 0U);
  EXPECT_TRUE(std::equal(body.triangles.begin(), body.triangles.end(), mesh.triangles().begin()));
}

TEST(SoundMesh, PartsWindOutward)
{
  const Surface ball = icosphere(10.0, 3);
  // A ball with inward winding next to a ball with outward winding; and a ball with a hole of 45
  // degrees.
  const Surface pair = together(ball, reversed(ball), { 30, 0, 0 });
  EXPECT_EQ(repaired(pair).defects().turnedTriangles, ball.triangles.size());
  EXPECT_NEAR(signedDistance(pair, { 30, 0, 9 }), -1.0, 0.1); // facets are 0.06 mm inside the ball
  EXPECT_NEAR(signedDistance(pair, { 0, 0, 9 }), -1.0, 0.1);
  const Surface open = cutAbove(reversed(ball), 7.1);
  EXPECT_EQ(repaired(open).defects().turnedTriangles, open.triangles.size());
  EXPECT_NEAR(signedDistance(open, { 9, 0, 0 }), -1.0, 0.1);
  // Half a ball may be a bowl, so it stays unchanged.
  EXPECT_EQ(repaired(cutAbove(reversed(ball), -0.5)).defects().turnedTriangles, 0U);
  EXPECT_EQ(repaired(openPlate(10.0, 4)).defects().turnedTriangles, 0U);
}

TEST(SoundMesh, CavitiesAndSecondBodies)
{
  const Surface outer = icosphere(20.0, 3);
  const Surface inner = icosphere(5.0, 2);
  const Surface hollow = together(outer, reversed(inner), { 0.3, 0.2, 0.1 });
  EXPECT_EQ(repaired(hollow).fault(), "");
  EXPECT_EQ(repaired(hollow).defects().turnedTriangles, 0U);
  EXPECT_GT(signedDistance(hollow, { 0, 0, 0 }), 4.0); // the cavity is outside the body
  EXPECT_NEAR(signedDistance(hollow, { 6.3, 0.2, 0.1 }), -1.0, 0.2);
  // A separate ball in the cavity stays if its winding is outward, and is reversed if it is inward.
  for (const bool turn : { false, true })
  {
    const Surface grain = turn ? reversed(icosphere(1.0, 1)) : icosphere(1.0, 1);
    const SoundMesh mesh = repaired(together(hollow, grain, { 0.3, 0.2, 0.1 }));
    EXPECT_EQ(mesh.fault(), "");
    EXPECT_EQ(mesh.defects().turnedTriangles, turn ? grain.triangles.size() : 0U);
  }
  EXPECT_THAT(repaired(together(outer, inner, { 0.3, 0.2, 0.1 })).fault(),
    ::testing::AllOf(::testing::HasSubstr("part 2 of 2 (320 triangles, the first is 1280)"),
      ::testing::HasSubstr("inside part 1 of 2"), ::testing::HasSubstr("second body")));
  EXPECT_THAT(repaired(together(outer, inner, { 19, 0, 0 })).fault(),
    ::testing::AllOf(::testing::HasSubstr("part 2 of 2"), ::testing::HasSubstr("overlap")));
  // The ball is inside the bounding box of a ring, but not in the ring.
  EXPECT_EQ(repaired(together(torus(20, 4, 30, 12), icosphere(2.0, 1), { 0, 0, 0 })).fault(), "");
}

TEST(SoundMesh, SheetsWithTwoSidesAreRefused)
{
  const Surface sheet = openPlate(10.0, 6);
  const auto refuses = [](const Surface& body, const char* words)
  { EXPECT_THAT(repaired(body).fault(), ::testing::HasSubstr(words)); };
  // The two sides of the sheet have separate points, the same points, or separate corners for each
  // triangle.
  refuses(together(sheet, reversed(sheet), { 0, 0, 0 }), "encloses no volume");
  Surface shared = sheet;
  const Surface back = reversed(sheet);
  shared.triangles.insert(shared.triangles.end(), back.triangles.begin(), back.triangles.end());
  refuses(shared, "occur with their reverse");
  refuses(triangleSoup(shared), "occur with their reverse");
  // Next to a ball with 35 times as many triangles the sheet is left out without a fault.
  EXPECT_EQ(repaired(together(icosphere(20.0, 4), shared, { 30, 0, 0 })).fault(), "");
}

/// Copies with separate points, in any order: the body is the same as without the copies.
TEST(SoundMesh, CopiesAtOnePlaceAreLeftOut)
{
  const Surface ball = icosphere(10.0, 2);
  Surface patch;
  patch.points = ball.points;
  patch.triangles.assign(ball.triangles.begin(), ball.triangles.begin() + 12);
  for (const Surface& copy : { patch, reversed(patch), ball, reversed(ball) })
  {
    for (const bool isFirst : { false, true })
    {
      const Surface both =
        isFirst ? together(copy, ball, { 0, 0, 0 }) : together(ball, copy, { 0, 0, 0 });
      const SoundMesh mesh = repaired(both);
      EXPECT_EQ(mesh.fault(), "");
      EXPECT_EQ(mesh.defects().repeatedTriangles, copy.triangles.size()) << isFirst;
      for (std::size_t t = 0; t < 12; ++t)
      {
        const Vector3 middle = (ball.corner(static_cast<std::int32_t>(t), 0) +
                                 ball.corner(static_cast<std::int32_t>(t), 1) +
                                 ball.corner(static_cast<std::int32_t>(t), 2)) /
          3.0;
        EXPECT_NEAR(signedDistance(both, 0.95 * middle), -0.05 * middle.norm(), 0.01);
      }
    }
  }
}

/// Blocks with common walls are one body.
TEST(SoundMesh, WallsBetweenTouchingPartsAreLeftOut)
{
  // Opposite faces have the same triangles.
  Surface cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.points.emplace_back(10.0 * (i & 1), 10.0 * (i >> 1 & 1), 10.0 * (i >> 2));
  }
  cube.triangles = { { 0, 3, 1 }, { 0, 2, 3 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 7, 3 }, { 2, 6, 7 }, { 0, 6, 2 }, { 0, 4, 6 }, { 1, 3, 7 }, { 1, 7, 5 } };
  Surface all = cube;
  for (int i = 1; i < 27; ++i)
  {
    all = together(all, cube, { 10.0 * (i % 3), 10.0 * (i / 3 % 3), 10.0 * (i / 9) });
  }
  const SoundMesh mesh = repaired(all);
  EXPECT_EQ(mesh.fault(), "");
  EXPECT_EQ(mesh.defects().repeatedTriangles, 27U * 12U - 6U * 9U * 2U);
  EXPECT_EQ(all.packed().defects().borderEdges, 0U);
  EXPECT_NEAR(signedDistance(all, { 14.0, 13.0, 16.0 }), -13.0, 1e-5);
  EXPECT_NEAR(signedDistance(all, { 10.0, 13.0, 29.0 }), -1.0, 1e-5); // a point near a wall
  for (const Surface& each : { all, reversed(all) }) // also with separate corners for each triangle
  {
    EXPECT_EQ(repaired(triangleSoup(each)).fault(), "");
    EXPECT_NEAR(signedDistance(triangleSoup(each), { 14.0, 13.0, 16.0 }), -13.0, 1e-5);
  }
  // A cavity that reaches the surface is a notch.
  Surface united = all;
  united.triangles.assign(mesh.triangles().begin(), mesh.triangles().end());
  united.triangles.erase(std::remove_if(united.triangles.begin(), united.triangles.end(),
                           [](const auto& corners) { return corners[0] < 0; }),
    united.triangles.end());
  const Surface notched = together(united, reversed(cube), { 20, 10, 10 });
  EXPECT_EQ(repaired(notched).fault(), "");
  EXPECT_NEAR(signedDistance(notched, { 19.0, 15.0, 15.0 }), -1.0, 1e-5);
  EXPECT_NEAR(signedDistance(notched, { 26.0, 15.0, 15.0 }), 5.0, 1e-5);
  // Walls with a different triangulation are rejected.
  EXPECT_THAT(repaired(together(block(10, 10, 20), cube, { 10, 0, 0 })).fault(),
    ::testing::HasSubstr("overlap or touch"));
}

/// Overlapping or touching parts are rejected for any rotation and triangulation, even if a
/// triangle is missing.
TEST(SoundMesh, PartsThatOverlapOrTouchAreRefused)
{
  std::mt19937 random(6);
  std::normal_distribution<double> any;
  Surface ball = icosphere(25.0, 3);
  ball.triangles.pop_back();
  struct Pair
  {
    Surface one;
    Surface other;
    Vector3 by;
    bool isSound;
  };
  const Pair pairs[] = { { block(40, 4, 4), block(4, 40, 4), { 18, -18, 0 },
                           false }, // two crossing bars
    { block(40, 40, 40), block(40, 40, 40), { 34, 34, 34 }, false },
    { block(10, 10, 10), block(10, 10, 10), { 10, 2, 1 }, false },
    { block(10, 10, 10), block(2, 2, 2), { 4, 4, 10 }, false },
    { icosphere(25.0, 3), icosphere(25.0, 3), { 48, 0, 0 }, false },
    { ball, icosphere(25.0, 3), { 30, 0, 0 }, false },
    { block(10, 10, 10), block(10, 10, 10), { 10.01, 2, 1 }, true },
    { icosphere(25.0, 3), icosphere(25.0, 3), { 50.5, 0, 0 }, true } };
  for (const Pair& pair : pairs)
  {
    for (int turn = 0; turn < 12; ++turn)
    {
      Surface both = together(pair.one, pair.other, pair.by);
      const Eigen::Quaterniond rotation = turn == 0
        ? Eigen::Quaterniond::Identity()
        : Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
      for (Vector3& point : both.points)
      {
        point = rotation * point;
      }
      EXPECT_EQ(repaired(both).fault().empty(), pair.isSound)
        << pair.by.transpose() << ", turn " << turn;
    }
  }
}

TEST(SoundMesh, SheetsInsideASolidAreLeftOut)
{
  const Surface ball = icosphere(20.0, 3);
  const Surface sheet = openPlate(8.0, 4);
  const SoundMesh mesh = repaired(together(ball, sheet, { -4, -4, 17 }));
  EXPECT_EQ(mesh.fault(), "");
  EXPECT_EQ(mesh.defects().hiddenTriangles, sheet.triangles.size());
  EXPECT_EQ(mesh.defects().repeatedTriangles, 0U);
  Surface pierced = ball;
  pierced.triangles.pop_back();
  EXPECT_EQ(repaired(together(pierced, sheet, { -4, -4, 17 })).defects().hiddenTriangles,
    sheet.triangles.size());
  // A sheet that extends out of the ball stays, and so does a sheet in an open bowl.
  EXPECT_EQ(repaired(together(ball, sheet, { 15, -4, 0 })).defects().hiddenTriangles, 0U);
  EXPECT_EQ(
    repaired(together(cutAbove(ball, -0.5), sheet, { -4, -4, -10 })).defects().hiddenTriangles, 0U);
}

TEST(SoundMesh, CopiesAreLeftOut)
{
  const Surface ball = icosphere(10.0, 2);
  Surface copied = ball;
  copied.triangles.insert(
    copied.triangles.end(), ball.triangles.begin(), ball.triangles.begin() + 50);
  EXPECT_EQ(repaired(copied).defects().repeatedTriangles, 50U);
  EXPECT_EQ(repaired(copied).defects().nonManifoldEdges, 0U);
  // Reversed copies of triangles of the ball: the copies are left out and the ball keeps its
  // triangles.
  Surface doubled = ball;
  for (std::size_t t = 0; t < 20; ++t)
  {
    doubled.triangles.push_back(
      { ball.triangles[t][0], ball.triangles[t][2], ball.triangles[t][1] });
  }
  const SoundMesh mended = repaired(doubled);
  EXPECT_EQ(mended.fault(), "");
  EXPECT_EQ(mended.defects().repeatedTriangles, 20U);
  EXPECT_EQ(mended.defects().nonManifoldEdges, 0U);
  // A flap: a triangle and its reverse at an edge of the ball.
  Surface flapped = ball;
  const auto tip = static_cast<std::int32_t>(flapped.points.size());
  flapped.points.emplace_back(0, 0, 20);
  const auto& at = ball.triangles.front();
  flapped.triangles.push_back({ at[0], at[1], tip });
  flapped.triangles.push_back({ at[1], at[0], tip });
  EXPECT_EQ(repaired(flapped).defects().repeatedTriangles, 2U);
  EXPECT_EQ(repaired(flapped).defects().nonManifoldEdges, 0U);
}

/// Random reversed triangles, split points, copies, reversed copies and invalid triangles.
TEST(SoundMesh, RandomBreakageChangesNothing)
{
  std::mt19937 random(3);
  const auto chance = [&random](double share)
  { return std::uniform_real_distribution<double>(0.0, 1.0)(random) < share; };
  for (const Surface& sound : { bumpySphere(20), torus(20.0, 6.0, 40, 20), icosphere(20.0, 3) })
  {
    const PackedMesh whole = sound.packed();
    const TriangleTree wholeTree(whole);
    for (int trial = 0; trial < 8; ++trial)
    {
      Surface broken = sound;
      const double flips = trial % 2 == 0 ? 0.1 : 0.45;
      for (std::size_t t = 0; t < sound.triangles.size(); ++t)
      {
        auto& corners = broken.triangles[t];
        if (trial > 3 && chance(0.3)) // gives some triangles separate corners
        {
          for (std::int32_t& corner : corners)
          {
            broken.points.push_back(sound.points[static_cast<std::size_t>(corner)]);
            corner = static_cast<std::int32_t>(broken.points.size() - 1);
          }
        }
        if (chance(flips))
        {
          std::swap(corners[0], corners[1]);
        }
      }
      for (std::size_t t = 0; t < sound.triangles.size(); ++t)
      {
        const auto corners = broken.triangles[t];
        if (chance(0.02))
        {
          broken.triangles.push_back(corners);
        }
        if (chance(0.02))
        {
          broken.triangles.push_back({ corners[0], corners[2], corners[1] });
        }
        if (chance(0.02))
        {
          broken.triangles.push_back({ corners[0], corners[2], corners[2] });
        }
      }
      std::shuffle(broken.triangles.begin(), broken.triangles.end(), random);
      const PackedMesh mended = broken.packed();
      ASSERT_EQ(mended.fault(), "");
      ASSERT_EQ(mended.triangleCount(), whole.triangleCount())
        << trial << ' ' << mended.defects().repeatedTriangles << ' '
        << mended.defects().nonManifoldEdges << ' ' << mended.defects().borderEdges;
      const TriangleTree tree(mended);
      std::uniform_real_distribution<double> place(-27.0, 27.0);
      for (int i = 0; i < 200; ++i)
      {
        const Vector3 tip = whole.centre() + Vector3(place(random), place(random), place(random));
        // Corners in another order cause other rounding: 1e-13 of the distances.
        ASSERT_NEAR(tree.closest(tip).signedDistance, wholeTree.closest(tip).signedDistance, 1e-11);
      }
    }
  }
}
} // namespace palpate::testing
