// SPDX-License-Identifier: BSD-3-Clause
// Several threads use one body: each ToolContact gives the same bits as alone.
#include "SampleResponses.h"
#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>
#include <vector>

namespace shared_body
{
using namespace palpate::testing;
using palpate::Contact;
using palpate::ToolContact;
using palpate::Vector3;

namespace
{
constexpr int Ticks = 3000;

/// A path in and out of a torus, different for each tool.
Vector3 pathOf(int tool, int tick)
{
  const double t = tick * 1e-3;
  const double r = 6.0 - 1.5 * std::sin(9.0 * t + tool);
  const double v = (1.0 + tool) * t;
  const double u = 2.0 * t + 0.5 * tool;
  const double radius = 20.0 + r * std::cos(v);
  return { radius * std::cos(u), radius * std::sin(u), r * std::sin(v) };
}

std::vector<Contact> run(const palpate::ContactBody& body, int tool)
{
  ToolContact contact(body);
  std::vector<Contact> found;
  found.reserve(Ticks);
  for (int tick = 0; tick < Ticks; ++tick)
  {
    found.push_back(contact.update(pathOf(tool, tick)));
  }
  return found;
}

bool sameBits(const Vector3& a, const Vector3& b)
{
  return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}
} // namespace

TEST(SharedBody, FourThreadsGiveTheBitsOfOne)
{
  const Surface surface = torus(20.0, 6.0, 60, 30);
  ResponseStore store(surface.points.size());
  takeMeshNormals(store, surface);
  store.randomizeCurves(16);
  const auto body = contactBody(surface, store);
  constexpr int Tools = 4;
  std::vector<std::vector<Contact>> together(Tools);
  std::vector<std::thread> threads;
  for (int tool = 0; tool < Tools; ++tool)
  {
    threads.emplace_back(
      [&, tool] { together[static_cast<std::size_t>(tool)] = run(*body, tool); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (int tool = 0; tool < Tools; ++tool)
  {
    const std::vector<Contact> alone = run(*body, tool);
    int touching = 0;
    for (std::size_t i = 0; i < alone.size(); ++i)
    {
      const Contact& other = together[static_cast<std::size_t>(tool)][i];
      ASSERT_TRUE(sameBits(alone[i].force, other.force)) << tool << " at tick " << i;
      ASSERT_TRUE(sameBits(alone[i].contactPoint, other.contactPoint));
      ASSERT_EQ(alone[i].state, other.state);
      ASSERT_EQ(alone[i].triangle, other.triangle);
      touching += alone[i].normalForce > 0.0;
    }
    EXPECT_GT(touching, Ticks / 4);
    EXPECT_LT(touching, Ticks);
  }
}
} // namespace shared_body
