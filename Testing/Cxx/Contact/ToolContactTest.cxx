// SPDX-License-Identifier: BSD-3-Clause
// A first contact at any place, against a second implementation of the tick: the closest point over
// all triangles, weights by areas (Mahvash and Hayward 2002, eq. 4), and curves as defined by the
// contract.
#include "Contact/ToolContact.h"

#include "BruteForce.h"
#include "SampleResponses.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

using namespace palpate::testing;
using palpate::Contact;
using palpate::ContactState;
using palpate::ForceForm;
using palpate::ToolContact;
using palpate::Vector3;

namespace
{
struct Expected
{
  Vector3 force = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
  double stiffness = 0.0;
  bool beyondRange = false;
};

Expected blend(
  const Surface& body, const ResponseStore& store, const Nearest& nearest, ForceForm form)
{
  std::array<Point, 3> corner;
  for (std::size_t k = 0; k < 3; ++k)
  {
    corner[k] = body.corner(nearest.triangle, k).cast<long double>();
  }
  const long double whole = (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
  Expected expected;
  Vector3 sumOfForces = Vector3::Zero();
  Vector3 sumOfNormals = Vector3::Zero();
  double magnitude = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point& b = corner[(k + 1) % 3];
    const Point& c = corner[(k + 2) % 3];
    const auto weight =
      static_cast<double>((b - nearest.point).cross(c - nearest.point).norm() / whole);
    if (weight < 1e-12) // on an edge or a corner, the opposite corners have no effect
    {
      continue;
    }
    const auto at =
      static_cast<std::size_t>(body.triangles[static_cast<std::size_t>(nearest.triangle)][k]);
    const ContractValue response =
      store.curveOf(at).evaluate(static_cast<double>(nearest.distance));
    magnitude += weight * response.force;
    expected.stiffness += weight * response.stiffness;
    sumOfForces += weight * response.force * store.normalOf(at);
    sumOfNormals += weight * store.normalOf(at);
    expected.beyondRange = expected.beyondRange || response.beyondRange;
  }
  expected.force =
    form == ForceForm::Paper ? sumOfForces : Vector3(magnitude * sumOfNormals.normalized());
  expected.normal = expected.force.normalized();
  return expected;
}

void compareWithBruteForce(const Surface& given, double deepest, int tips)
{
  const Surface body = given.rounded();
  ResponseStore store(body.points.size());
  takeMeshNormals(store, body);
  store.randomizeCurves(13); // other curves at each point
  const auto contact = contactBody(body, store);
  const std::vector<std::int32_t> all = allTriangles(body);
  std::mt19937 random(14);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int inside = 0;
  int beyond = 0;
  for (int i = 0; i < tips; ++i)
  {
    // A tip around a random point of the body, at a distance of at most `deepest`.
    const auto& t =
      body.triangles[static_cast<std::size_t>(share(random) * static_cast<double>(all.size()))];
    Vector3 tip = body.points[static_cast<std::size_t>(t[0])];
    for (double& coordinate : tip)
    {
      coordinate += deepest * (2.0 * share(random) - 1.0);
    }
    const Nearest nearest = nearestOf(body, tip, all);
    const bool isInside = windingNumber(body, tip) > 0.5;
    for (const ForceForm form : { ForceForm::Paper, ForceForm::NormalizedDirection })
    {
      const Contact found = ToolContact(*contact, { form }).update(tip);
      if (!isInside)
      {
        EXPECT_EQ(found.state, ContactState::None);
        EXPECT_EQ(found.force, Vector3::Zero());
        EXPECT_EQ(found.triangle, -1);
        continue;
      }
      const Expected expected = blend(body, store, nearest, form);
      ++inside;
      beyond += expected.beyondRange;
      EXPECT_EQ(
        found.state, expected.beyondRange ? ContactState::BeyondRange : ContactState::Slide);
      // The contact point has an error of 1e-12 of the body's size. Divided by the height of the
      // facets, this is 1e-11 in the weights.
      const double scale = 1e-10 * (1.0 + expected.force.norm());
      EXPECT_LE((found.force - expected.force).norm(), scale);
      EXPECT_LE((found.normal - expected.normal).norm(), 1e-10);
      EXPECT_NEAR(found.normalForce, expected.force.norm(), scale);
      EXPECT_NEAR(found.stiffness, expected.stiffness, 1e-9 * (1.0 + std::abs(expected.stiffness)));
      EXPECT_NEAR(found.deflection, static_cast<double>(nearest.distance), 1e-12);
      EXPECT_LE((found.contactPoint.cast<long double>() - nearest.point).norm(), 1e-11L);
      EXPECT_EQ(found.friction, Vector3::Zero());
    }
  }
  EXPECT_GT(inside, tips / 4);
  EXPECT_GT(beyond, 10);
}
} // namespace

TEST(ToolContact, BruteForceOnAConvexBody)
{
  compareWithBruteForce(icosphere(20.0, 2), 4.0, 600);
}

TEST(ToolContact, BruteForceOnConcaveBodies)
{
  compareWithBruteForce(torus(20.0, 6.0, 30, 15), 4.0, 400);
  compareWithBruteForce(subdivided(grooveBlock(), 2), 4.0, 600);
}

TEST(ToolContact, ContinuesWithTheSameHistoryAsItsTracker)
{
  // The history keeps the contact at the top of a slab beyond its middle: the force is that of the
  // top at the full depth.
  const Surface slab = subdivided(block(40, 40, 3), 4);
  const auto body = uniformBody(slab);
  ToolContact contact(*body);
  for (int i = 1; i <= 190; ++i)
  {
    const double depth = 0.01 * i;
    const Contact found = contact.update(Vector3(20.3, 18.7, 3.0 - depth));
    ASSERT_EQ(found.state, ContactState::Slide);
    EXPECT_NEAR(found.deflection, depth, 1e-14);
    // Samples are float32 with an error of 6e-8; the interpolation multiplies it by a few.
    EXPECT_LE(
      (found.force - Vector3(0, 0, 10.0 * std::pow(depth, 1.5))).norm(), 1e-6 * depth * 10.0);
  }
  contact.reset();
  // the force is that of the bottom
  EXPECT_LT(contact.update(Vector3(20.3, 18.7, 1.1)).force.z(), 0.0);
}
