// SPDX-License-Identifier: BSD-3-Clause
// A single tip inside a closed body has a contact, on thin, bumpy and star-shaped bodies, also with
// the law of edges. A tip outside has none. The winding number determines what is inside.
#include "BruteForce.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace palpate::testing
{
namespace
{
struct SampleBody
{
  std::string name;
  Surface surface;
};

/// A stretched sphere of 10 mm, with a star of `tips` rays around z.
Surface star(int tips, const Vector3& stretch)
{
  Surface body = icosphere(1.0, 3);
  for (Vector3& point : body.points)
  {
    const double flat = 1.0 - point.z() * point.z();
    const double ray = 0.6 * std::sin(tips * std::atan2(point.y(), point.x())) * flat * flat;
    point = (1.0 + ray) * point.cwiseProduct(stretch);
  }
  return body;
}

/// A sphere of 10 mm whose points are moved along the radius at random, which makes bumps and pits
/// with edges of 20° to 90°.
Surface rough(unsigned seed)
{
  Surface body = icosphere(10.0, 3);
  std::mt19937 random(seed);
  std::normal_distribution<double> bump(1.0, 0.1);
  for (Vector3& point : body.points)
  {
    point *= bump(random);
  }
  return body;
}

std::vector<SampleBody> sampleBodies()
{
  return { { "lens", star(0, { 20.0, 10.0, 0.3 }) }, { "star", star(5, { 10.0, 10.0, 3.0 }) },
    { "thin star", star(7, { 10.0, 10.0, 0.5 }) }, { "rough ball", rough(1) },
    { "thin block", block(40.0, 20.0, 0.4) } };
}
} // namespace

TEST(TipsInside, HaveAContactWithAndWithoutEdges)
{
  constexpr int tips = 400;
  for (const SampleBody& sample : sampleBodies())
  {
    const Surface body = sample.surface.rounded();
    const Eigen::AlignedBox3d box = boxOf(body);
    for (const EdgeTerms& edges : { EdgeTerms{}, sphereOverEdges() })
    {
      const auto contactBody = uniformBody(body, edges);
      for (const ContactSettings& settings : allFormsAndSurfaces())
      {
        if (settings.surface == ContactSurface::Smooth)
        {
          // the smooth surface is partly above and partly below the facets, so its inside differs
          continue;
        }
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        int inside = 0;
        int without = 0;
        int outside = 0;
        for (int i = 0; i < tips; ++i)
        {
          const Vector3 part(unit(random), unit(random), unit(random));
          const Vector3 tip = box.min() + part.cwiseProduct(box.sizes());
          ToolContact contact(*contactBody, settings);
          const Contact found = contact.update(tip);
          if (windingNumber(body, tip) > 0.5)
          {
            ++inside;
            without += !(found.normalForce > 0.0);
          }
          else
          {
            outside += found.normalForce > 0.0;
          }
        }
        SCOPED_TRACE(sample.name + (edges.areFelt() ? ", edges" : ""));
        EXPECT_GT(inside, tips / 8);
        EXPECT_EQ(without, 0);
        EXPECT_EQ(outside, 0);
      }
    }
  }
}

TEST(TipsInside, StayInContactUntilTheyAreOutside)
{
  // A tip moves from inside along the line to the contact point and beyond: it has a force until it
  // is outside, and none outside.
  const Surface body = rough(2).rounded();
  const auto contactBody = uniformBody(body, sphereOverEdges());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-6.0, 6.0);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 tip(unit(random), unit(random), unit(random));
    if (windingNumber(body, tip) < 0.5)
    {
      continue;
    }
    ToolContact contact(*contactBody, {});
    const Contact first = contact.update(tip);
    ASSERT_GT(first.normalForce, 0.0);
    constexpr int steps = 200;
    for (int k = 1; k <= steps; ++k)
    {
      const double part = 1.2 * k / steps;
      const Vector3 moved = tip + part * (first.contactPoint - tip);
      const Contact found = contact.update(moved);
      ASSERT_TRUE(std::isfinite(found.normalForce));
      ASSERT_FALSE(
        part > 1.0 + 1e-6 && found.normalForce > 0.0 && windingNumber(body, moved) < 0.5);
    }
  }
}
} // namespace palpate::testing
