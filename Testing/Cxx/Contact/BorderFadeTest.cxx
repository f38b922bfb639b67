// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/BorderFade.h"

#include "SampleBodies.h"
#include "Contact/TriangleTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace palpate::testing
{
namespace
{
/// A body with the fade for any tip below it. There is no fade if the closest point is not on a
/// border.
struct Sheet
{
  explicit Sheet(const Surface& body)
    : mesh(body.packed())
    , tree(mesh)
  {
  }

  BorderFade fade(const Vector3& tip) const
  {
    const Vector3 local = this->mesh.toLocal(tip);
    const SurfacePoint found = this->tree.closestLocal(local);
    if (!found.onBorder)
    {
      return { -found.signedDistance, 1.0 };
    }
    return BorderFade::at(
      this->mesh, found.triangle, found.projection.weights, local - found.projection.point);
  }

  /// The force of the test responses, F = 10 h^1.5, times the fade.
  double force(const Vector3& tip) const
  {
    const BorderFade left = this->fade(tip);
    return left.fraction * 10.0 * std::pow(left.depth, 1.5);
  }

  PackedMesh mesh;
  TriangleTree tree;
};

/// Largest change of the force between ticks of a path, N.
double largestStep(const Sheet& sheet, int ticks, const std::function<Vector3(double)>& path)
{
  double largest = 0.0;
  double last = sheet.force(path(0.0));
  for (int i = 1; i <= ticks; ++i)
  {
    const double force = sheet.force(path(static_cast<double>(i) / ticks));
    largest = std::max(largest, std::abs(force - last));
    last = force;
  }
  return largest;
}

/// Half a pipe with a radius of 10 mm around the y axis, 20 mm long, open at both ends and along
/// its sides. Its normals point to the axis.
Surface gutter()
{
  Surface body = openPlate(20.0, 20);
  for (Vector3& p : body.points)
  {
    const double angle = 3.14159265358979323846 * p.x() / 20.0;
    p = Vector3(-10.0 * std::cos(angle), p.y(), -10.0 * std::sin(angle));
  }
  return body;
}
} // namespace

TEST(BorderFade, AsTheHeaderSays)
{
  const Sheet plate(openPlate(10.0, 10));
  for (const double h : { 0.01, 0.5, 2.0 })
  {
    for (const double l : { 1e-9, 0.1, 0.25, 0.5, 0.9, 1.0, 1.5 })
    {
      // Next to each of the four borders; l in units of h. The float32 coordinates of this plate
      // are exact; products of them are rounded.
      const double x = std::min(l, 1.0);
      const double share = (1.0 - x) * (1.0 - x) * (1.0 + 2.0 * x);
      for (const Vector3& tip : { Vector3(10.0 + l * h, 5.3, -h), Vector3(-l * h, 5.3, -h),
             Vector3(5.3, 10.0 + l * h, -h), Vector3(5.3, -l * h, -h) })
      {
        const BorderFade left = plate.fade(tip);
        EXPECT_NEAR(left.depth, h, 1e-13);
        EXPECT_NEAR(left.fraction, share, 1e-12);
      }
    }
  }
}

TEST(BorderFade, FadesWithoutAStep)
{
  // The tip slides out of the plate at a depth of 1 mm, across the line below the border. The slope
  // of the fade is at most 1.5 per h, times 10 N.
  const Sheet plate(openPlate(10.0, 10));
  const double step =
    largestStep(plate, 4000, [](double t) { return Vector3(8.0 + 4.0 * t, 5.3, -1.0); });
  EXPECT_LE(step, 10.0 * 1.5 * 1e-3 * 1.01);
  EXPECT_GE(step, 10.0 * 1.5 * 1e-3 * 0.99);
  EXPECT_EQ(plate.force(Vector3(11.0, 5.3, -1.0)), 0.0);
  EXPECT_NEAR(plate.force(Vector3(10.0, 5.3, -1.0)), 10.0, 1e-12);
  // There is also no step as the tip rises next to the border to the plane of the plate.
  EXPECT_LE(largestStep(plate, 4000, [](double t) { return Vector3(10.5, 5.3, -2.0 + 2.0 * t); }),
    10.0 * 3.0 * 5e-4 * 3.0); // dF/dh <= 1.5·10·√2 + 10·2.8·1.5/h·(l/h), h >= 0.5
}

TEST(BorderFade, AroundACorner)
{
  // Circles around the corner of a plate at a depth of 1 mm: in and out, from border to border. The
  // slope is at most that of the fade, 1.5 per h.
  const Sheet plate(openPlate(10.0, 10));
  for (const double radius : { 0.05, 0.3, 0.6, 0.95, 3.0 })
  {
    const double step = largestStep(plate, 20000,
      [radius](double t)
      {
        const double a = 2.0 * 3.14159265358979323846 * t;
        return Vector3(10.0 + radius * std::cos(a), 10.0 + radius * std::sin(a), -1.0);
      });
    const double arc = 2.0 * 3.1416 * radius / 20000;
    EXPECT_LE(step, 10.0 * 1.5 * 1.01 * arc) << radius;
  }
  // On the diagonal the distance from the corner has the same effect as the distance from a border.
  const double x = 0.3 * std::sqrt(2.0);
  EXPECT_NEAR(
    plate.force(Vector3(10.3, 10.3, -1.0)), 10.0 * (1 - x) * (1 - x) * (1 + 2 * x), 1e-12);
  EXPECT_EQ(plate.force(Vector3(10.71, 10.71, -1.0)), 0.0);
}

TEST(BorderFade, RoundABentBorder)
{
  // Along the end of a half pipe, half a millimetre beyond it and 1 mm below its facets: from facet
  // to facet, past the corners between them. Between facets, which meet at 9°, the tip moves around
  // the corner at constant depth and distance.
  const Sheet sheet(gutter());
  const double share = 0.5 * 0.5 * 2.0;
  for (int i = 0; i <= 3000; ++i)
  {
    const double angle = 0.3 + 2.5 * i / 3000.0;
    const Vector3 tip(-11.0 * std::cos(angle), 20.5, -11.0 * std::sin(angle));
    const BorderFade left = sheet.fade(tip);
    // The facets are up to 10 (1 - cos 4.5°) = 0.031 mm inside the pipe.
    EXPECT_GE(left.depth, 1.0 - 1e-6);
    EXPECT_LE(left.depth, 1.032);
    EXPECT_NEAR(left.fraction, share, 1.5 * 0.5 * 0.032 + 1e-6); // dshare/dh = 1.5 l/h²
  }
  EXPECT_LE(largestStep(sheet, 20000,
              [](double t)
              {
                const double angle = 0.3 + 2.5 * t;
                return Vector3(-11.0 * std::cos(angle), 20.5, -11.0 * std::sin(angle));
              }),
    0.01);
}

TEST(BorderFade, NeverMoreThanAllNeverLessThanNothing)
{
  const Sheet sheet(gutter());
  for (int i = 0; i < 20000; ++i)
  {
    // Points in a box around the body, with incommensurate steps along the axes.
    const Vector3 tip(std::fmod(0.7548776662 * i, 1.0) * 30.0 - 15.0,
      std::fmod(0.5698402910 * i, 1.0) * 30.0 - 5.0,
      std::fmod(0.4301597090 * i, 1.0) * 20.0 - 15.0);
    const BorderFade left = sheet.fade(tip);
    EXPECT_GE(left.fraction, 0.0);
    EXPECT_LE(left.fraction, 1.0);
    EXPECT_TRUE(std::isfinite(left.depth));
  }
}
} // namespace palpate::testing
