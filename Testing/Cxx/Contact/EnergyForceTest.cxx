// SPDX-License-Identifier: BSD-3-Clause
// The EnergyConsistent force of the whole tick, against differences of the energy Σ n_i e_i, on
// facets and on the smooth surface, with responses that differ from point to point.
#include "SampleResponses.h"
#include "Contact/SmoothContact.h"
#include "Contact/ToolContact.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace palpate::testing;
using palpate::Contact;
using palpate::ContactBody;
using palpate::ContactSettings;
using palpate::ContactState;
using palpate::ContactSurface;
using palpate::ForceForm;
using palpate::ToolContact;
using palpate::Vector3;

namespace
{
/// A ball whose points differ in stiffness by up to 1:5: F = 10 c δ^1.5 up to 2 mm, then the
/// tangent.
struct Ball
{
  Surface surface = icosphere(20.0, 2);
  std::vector<double> factor;
  std::unique_ptr<ContactBody> body;

  Ball()
  {
    ResponseStore store(this->surface.points.size());
    store.normalsFromPoints(this->surface);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> share(0.4F, 2.0F);
    for (std::size_t p = 0; p < this->surface.points.size(); ++p)
    {
      const float scale = share(random);
      this->factor.push_back(static_cast<double>(scale));
      for (std::size_t i = 8 * p; i < 8 * (p + 1); ++i)
      {
        store.force[i] *= scale;
        store.stiffness[i] *= scale;
      }
    }
    this->body = contactBody(this->surface, store);
  }

  double energy(std::int32_t triangle, const Vector3& weights, double depth) const
  {
    double sum = 0.0;
    const auto& corners = this->body->surface.corners(triangle);
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const auto point = static_cast<std::size_t>(
        this->body->surface.inputPoint(corners[static_cast<std::size_t>(k)]));
      sum += weights[k] * this->factor[point] * 4.0 * std::pow(depth, 2.5);
    }
    return sum;
  }
};

ContactSettings energyOn(ContactSurface surface)
{
  ContactSettings settings;
  settings.form = ForceForm::EnergyConsistent;
  settings.surface = surface;
  return settings;
}

/// Energy and triangle at the contact of a tip.
struct Place
{
  double energy;
  std::int32_t triangle;
  double margin; ///< smallest weight, which is near 0 at an edge
};

Place placeOf(const Ball& ball, ContactSurface surface, const Vector3& tip)
{
  const Vector3 local = ball.body->surface.toLocal(tip);
  const palpate::SurfacePoint near = ball.body->tree.closestLocal(local);
  if (surface == ContactSurface::Facets)
  {
    const Vector3& weights = near.projection.weights;
    return { ball.energy(near.triangle, weights, -near.signedDistance), near.triangle,
      weights.minCoeff() };
  }
  palpate::SmoothContact smooth(ball.body->surface, ball.body->response);
  const palpate::ContactPlace at =
    smooth.follow(local, near.triangle, near.projection.weights).place;
  return { ball.energy(at.triangle, at.projection.weights, -at.signedDistance), at.triangle,
    at.projection.weights.minCoeff() };
}

void compareWithDifferences(ContactSurface surface)
{
  const Ball ball;
  std::mt19937 random(2);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> depth(0.2, 1.9);
  const double e = 1e-5;
  int compared = 0;
  double greatestAlong = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    const double x = gauss(random);
    const double y = gauss(random);
    const Vector3 out = Vector3(x, y, gauss(random)).normalized();
    const Vector3 tip =
      (surface == ContactSurface::Facets ? 19.4 : 20.0) * out - depth(random) * out;
    const Contact found = ToolContact(*ball.body, energyOn(surface)).update(tip);
    if (found.state != ContactState::Slide)
    {
      continue; // the tip is outside, or deeper than the curves reach
    }
    const Place here = placeOf(ball, surface, tip);
    Vector3 expected;
    bool sameTriangle = here.margin > 1e-3;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const Vector3 step = e * Vector3::Unit(k);
      const Place after = placeOf(ball, surface, tip + step);
      const Place before = placeOf(ball, surface, tip - step);
      sameTriangle =
        sameTriangle && after.triangle == here.triangle && before.triangle == here.triangle;
      expected[k] = -(after.energy - before.energy) / (2.0 * e);
    }
    if (sameTriangle)
    {
      ++compared;
      // Samples are float32, 6e-8 each. The smooth point has an error of 1e-12, divided by e.
      EXPECT_LE((found.force - expected).norm(), 1e-6 * found.force.norm());
      const Vector3 aside = found.force - found.normal * found.normal.dot(found.force);
      greatestAlong = std::max(greatestAlong, aside.norm() / found.force.norm());
      EXPECT_NEAR(found.normal.dot(found.force), found.normalForce, 1e-9 * found.normalForce);
    }
  }
  EXPECT_GT(compared, 200);
  // the tangential part, which eq. 3 of Mahvash and Hayward does not have
  EXPECT_GT(greatestAlong, 0.05);
}
} // namespace

TEST(EnergyForce, OnFacets)
{
  compareWithDifferences(ContactSurface::Facets);
}

TEST(EnergyForce, OnTheSmoothSurface)
{
  compareWithDifferences(ContactSurface::Smooth);
}

TEST(EnergyForce, EqualResponsesPushAlongTheNormal)
{
  const Surface surface = icosphere(20.0, 2);
  ResponseStore store(surface.points.size());
  store.normalsFromPoints(surface);
  const auto body = contactBody(surface, store);
  for (const ContactSurface on : { ContactSurface::Facets, ContactSurface::Smooth })
  {
    const Contact found = ToolContact(*body, energyOn(on)).update(Vector3(11.0, 10.0, 11.5));
    ASSERT_EQ(found.state, ContactState::Slide);
    EXPECT_EQ(found.force, Vector3(found.normalForce * found.normal));
  }
}

TEST(EnergyForce, PointsWithoutResponseHaveNoSayAcrossAnEdge)
{
  // The contact is on the edge between (0,0) and (5,5), in either of its triangles. The opposite
  // point has no response.
  const Surface surface = openPlate(10.0, 2);
  for (const std::size_t opposite : { 1, 3 })
  {
    for (const ContactSurface on : { ContactSurface::Facets, ContactSurface::Smooth })
    {
      ResponseStore store(surface.points.size());
      for (std::size_t i = 0; i < 8; ++i) // the two ends of the edge differ
      {
        store.force[i] *= 0.5F;
        store.stiffness[i] *= 0.5F;
      }
      store.status[opposite] = 2;
      const auto body = contactBody(surface, store);
      const Contact found = ToolContact(*body, energyOn(on)).update(Vector3(2.0, 2.0, -0.5));
      EXPECT_EQ(found.state, ContactState::Slide);
      EXPECT_TRUE(found.force.allFinite());
      // e = 0.4 f δ, and half of this at one end. Over the 7.1 mm of the edge, at a blended factor
      // of 0.7, the tangential force is 0.020 of the normal force; 0.029 if the contact is in the
      // triangle that has all its responses. If the missing energy counted as 0, it would be 0.06.
      EXPECT_GT(found.force.head<2>().norm(), 0.019 * found.force.z());
      EXPECT_LT(found.force.head<2>().norm(), 0.029 * found.force.z());
    }
  }
}
