// SPDX-License-Identifier: BSD-3-Clause
// Equation 3 of Mahvash and Hayward 2002 adds unit normals of different directions, which makes the
// force too small. Blending magnitude and direction separately does not have this error.
#include "BruteForce.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace palpate::testing;
using palpate::ForceForm;
using palpate::ToolContact;
using palpate::Vector3;

namespace
{
struct Facet
{
  Vector3 centroid;
  Vector3 normal;
  double squaredEdges; ///< sum over the three edges
};

Facet facetOf(const Surface& body, std::int32_t triangle)
{
  const Vector3 a = body.corner(triangle, 0);
  const Vector3 b = body.corner(triangle, 1);
  const Vector3 c = body.corner(triangle, 2);
  return { (a + b + c) / 3.0, (b - a).cross(c - a).normalized(),
    (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm() };
}
} // namespace

TEST(ForceForm, LossAtTheCentreOfAFacet)
{
  const double R = 20.0;
  const double depth = 0.5;
  for (int times = 0; times <= 3; ++times)
  {
    const Surface sphere = icosphere(R, times).rounded();
    ResponseStore store(sphere.points.size());
    store.normalsFromPoints(sphere);
    const auto body = contactBody(sphere, store);
    const double force = store.curveOf(0).evaluate(depth).force;
    for (std::int32_t t = 0; t < 20; ++t)
    {
      const Facet facet = facetOf(sphere, t);
      const Vector3 tip = facet.centroid - depth * facet.normal;
      const auto whole = ToolContact(*body, { ForceForm::NormalizedDirection }).update(tip);
      const auto paper = ToolContact(*body, { ForceForm::Paper }).update(tip);
      ASSERT_EQ(whole.triangle, t);
      // Normals are float32: 6e-8 each.
      EXPECT_NEAR(whole.normalForce, force, 1e-12 * force);
      EXPECT_NEAR(whole.force.norm(), force, 1e-12 * force);
      // For three unit vectors from the centre to the corners of a triangle, the length of their
      // mean is √(1 - Σ edge²/9R²).
      const double kept = std::sqrt(1.0 - facet.squaredEdges / (9.0 * R * R));
      EXPECT_NEAR(paper.normalForce / whole.normalForce, kept, 2e-7);
      EXPECT_NEAR(paper.force.norm() / whole.force.norm(), kept, 2e-7);
      // To first order the loss is h²/(6R²); the next term is half of the square of the loss.
      const double h2 = facet.squaredEdges / 3.0;
      const double first = h2 / (6.0 * R * R);
      EXPECT_NEAR(1.0 - paper.normalForce / whole.normalForce, first, first * first + 2e-7);
      // with one law the direction is the same
      EXPECT_LE((paper.normal - whole.normal).norm(), 1e-12);
    }
  }
}

TEST(ForceForm, AgreeAtAPoint)
{
  // Above a corner only the normal of the corner counts.
  const Surface sphere = icosphere(20.0, 2);
  ResponseStore store(sphere.points.size());
  store.normalsFromPoints(sphere);
  const auto body = contactBody(sphere, store);
  for (std::size_t i = 0; i < sphere.points.size(); i += 7)
  {
    // A tip below a convex corner is nearer to a facet. For a tip 2e-6 mm below the corner, the
    // projection is about 1e-6 mm away from it.
    const Vector3 tip = sphere.points[i] * (1.0 - 1e-7);
    const auto whole = ToolContact(*body, { ForceForm::NormalizedDirection }).update(tip);
    const auto paper = ToolContact(*body, { ForceForm::Paper }).update(tip);
    // The loss is weight·h²/R², and the weight of the other corners is 1e-7.
    EXPECT_NEAR(paper.normalForce, whole.normalForce, 1e-6 * whole.normalForce);
    EXPECT_LE((whole.normal - store.normalOf(i)).norm(), 1e-6);
  }
}

TEST(ForceForm, DirectionsDifferWhenResponsesDo)
{
  // A corner with a larger stiffness turns the force of the paper towards its own normal, but not
  // the blended normal.
  Surface sphere = icosphere(20.0, 1);
  ResponseStore store(sphere.points.size());
  store.normalsFromPoints(sphere);
  const Facet facet = facetOf(sphere, 0);
  const auto stiff = static_cast<std::size_t>(sphere.triangles[0][0]);
  for (std::size_t i = 8 * stiff; i < 8 * stiff + 8; ++i)
  {
    store.force[i] *= 10.0F;
    store.stiffness[i] *= 10.0F;
  }
  const auto body = contactBody(sphere, store);
  const Vector3 tip = facet.centroid - 0.5 * facet.normal;
  const auto whole = ToolContact(*body, { ForceForm::NormalizedDirection }).update(tip);
  const auto paper = ToolContact(*body, { ForceForm::Paper }).update(tip);
  const Vector3 towards = store.normalOf(stiff);
  EXPECT_GT(paper.normal.dot(towards), whole.normal.dot(towards) + 0.01);
  EXPECT_LE((whole.normal - facet.centroid.normalized()).norm(), 1e-2);
  // (1+1+10)/3 times the force of a single curve.
  ResponseStore single(1);
  EXPECT_NEAR(whole.normalForce, 4.0 * single.curveOf(0).evaluate(0.5).force, 1e-5);
}

/// No form presses the tool into the body, neither on a fin whose vertex normals point away from
/// its faces, nor with normals that point inward.
TEST(ForceForm, NoneIsDirectedIntoTheBody)
{
  const Surface ball = icosphere(20.0, 1);
  std::mt19937 random(4);
  std::normal_distribution<double> any;
  for (const bool inward : { true, false })
  {
    ResponseStore store(ball.points.size());
    store.normalsFromPoints(ball);
    for (std::size_t i = 0; i < ball.points.size(); ++i)
    {
      const Vector3 normal = inward ? Vector3(-ball.points[i].normalized())
                                    : Vector3(any(random), any(random), any(random)).normalized();
      Eigen::Map<Eigen::Vector3f>(store.normal.data() + 3 * i) = normal.cast<float>();
    }
    const auto body = contactBody(ball, store);
    for (const ForceForm form :
      { ForceForm::Paper, ForceForm::NormalizedDirection, ForceForm::EnergyConsistent })
    {
      for (std::int32_t t = 0; t < 80; ++t)
      {
        const Facet facet = facetOf(ball, t);
        const auto felt = ToolContact(*body, { form }).update(facet.centroid - 0.5 * facet.normal);
        // Normals are float32.
        EXPECT_GE(felt.force.dot(facet.normal), -1e-6 * felt.force.norm());
        EXPECT_GT(felt.force.norm(), 0.0);
      }
    }
  }
}

/// The same holds beyond open borders, in concave places and near edges: force · (contact point -
/// tip) >= 0 along paths over open fans and rough bodies, whose curves differ from point to point.
TEST(ForceForm, NoneLeadsAwayFromTheContactPoint)
{
  std::mt19937 random(11);
  std::normal_distribution<double> any;
  const auto rough = [&](Surface body, double noise)
  {
    for (Vector3& point : body.points)
    {
      point *= 1.0 + noise * std::clamp(any(random), -2.0, 2.0);
    }
    return body;
  };
  const auto fan = [&]()
  {
    Surface body;
    body.points.emplace_back(0.0, 0.0, 0.0);
    for (int k = 0; k < 4; ++k)
    {
      body.points.emplace_back(10.0 * std::cos(k), 10.0 * std::sin(k), 5.0 * any(random));
    }
    body.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 } };
    return body;
  };
  std::vector<Surface> bodies;
  for (int trial = 0; trial < 4; ++trial)
  {
    bodies.push_back(fan());
    bodies.push_back(rough(icosphere(6.0, 0), 0.35));
    bodies.push_back(rough(icosphere(20.0, 2), 0.03));
  }
  bodies.push_back(block(6.0, 5.0, 3.0));
  std::size_t presses = 0;
  std::size_t beyondBorders = 0;
  for (std::size_t number = 0; number < bodies.size(); ++number)
  {
    const Surface& surface = bodies[number];
    for (const bool hasEdges : { false, true })
    {
      ResponseStore store(surface.points.size());
      takeMeshNormals(store, surface);
      store.randomizeCurves(static_cast<unsigned>(number));
      store.edges = hasEdges ? sphereOverEdges() : EdgeTerms{};
      const auto body = contactBody(surface, store);
      for (const palpate::ContactSettings& settings : allFormsAndSurfaces())
      {
        ToolContact contact(*body, settings);
        for (int start = 0; start < 40; ++start)
        {
          const auto near = static_cast<std::size_t>(random()) % surface.points.size();
          Vector3 tip = surface.points[near] + Vector3(any(random), any(random), any(random));
          contact.reset();
          for (int step = 0; step < 25; ++step)
          {
            tip += 0.15 * Vector3(any(random), any(random), any(random));
            const auto felt = contact.update(tip);
            const Vector3 out = felt.contactPoint - tip;
            presses += felt.force.norm() > 0.0;
            beyondBorders += felt.state == palpate::ContactState::LostAtBorder;
            // Normals and coordinates are float32.
            EXPECT_GE(felt.force.dot(out), -1e-6 * felt.force.norm() * out.norm())
              << "body " << number << (hasEdges ? " with edges" : "") << ", tip "
              << tip.transpose();
          }
        }
      }
    }
  }
  EXPECT_GT(presses, 10000U);
  EXPECT_GT(beyondBorders, 100U);
}
