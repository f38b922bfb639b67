// SPDX-License-Identifier: BSD-3-Clause
// Stated errors compared with the errors against finite elements, at a few random contacts. The
// study "error" compares many more (Data/Studies/error).
#include "RandomContact.h"

#include <gtest/gtest.h>

#include <string>

using namespace palpate::testing;

namespace
{
void expectBounds(ContactFamily family, unsigned seed, int contacts)
{
  std::mt19937 random(seed);
  int held = 0;
  int all = 0;
  std::string words;
  for (int i = 0; i < contacts; ++i)
  {
    const RandomContact contact = drawContact(family, random);
    for (const JudgedForce& at : contact.forces)
    {
      const bool holds = at.error() <= at.stated + SolverError;
      held += holds ? 1 : 0;
      ++all;
      if (!holds)
      {
        words += contact.tool + ", " + contact.body + ", " + at.law + " at " +
          std::to_string(at.depth) + " mm: " + std::to_string(at.error()) + ", stated " +
          std::to_string(at.stated) + "\n";
      }
    }
  }
  EXPECT_GE(all, 2 * contacts); // three depths for each contact, some with more than one law
  EXPECT_GE(held, 0.95 * all) << words;
}
} // namespace

TEST(RandomContact, OnAHalfSpace)
{
  expectBounds(ContactFamily::HalfSpace, 31, 1);
}

TEST(RandomContact, OnALayer)
{
  expectBounds(ContactFamily::Layer, 32, 2);
}

TEST(RandomContact, OnAStack)
{
  expectBounds(ContactFamily::Stack, 33, 2);
}

TEST(RandomContact, OnABallAndInACavity)
{
  expectBounds(ContactFamily::Ball, 34, 1);
  expectBounds(ContactFamily::Cavity, 35, 1);
}

/// ParaView's result after the six clicks of the manual: a sphere of 5 mm, pressed 1 mm into a body
/// with the local curvature of a ball of 55.5 mm.
TEST(RandomContact, TheTouchOfTheManual)
{
  const RandomContact touch = pressOnBall("sphere:5", 1.0, 55.5, 0.45, 0.1);
  ASSERT_FALSE(touch.forces.empty()) << touch.fault;
  bool isThere = false;
  for (const JudgedForce& at : touch.forces)
  {
    if (at.depth == 1.0 && at.law == "curved")
    {
      isThere = true;
      EXPECT_NEAR(at.force, 0.352, 0.002);
      EXPECT_LE(at.stated, 0.04);
      EXPECT_LE(at.error(), at.stated + SolverError);
    }
  }
  EXPECT_TRUE(isThere);
}
