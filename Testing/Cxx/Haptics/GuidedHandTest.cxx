// SPDX-License-Identifier: BSD-3-Clause
// A hand that a pointer steers. It moves around the body, and never presses deeper than set. Every
// tick is checked by the contact that the servo loop computes, and by the shape in closed form.
#include "Haptics/Guidance/FreeSpace.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "GuidedBodies.h"
#include "SampleResponses.h"

#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <random>
#include <sstream>
#include <string>

using namespace palpate;
using namespace palpate::testing;

namespace
{
/// A place of the surface, with the normal along which a tool presses there.
struct SurfacePlace
{
  Vector3 point;
  Vector3 normal;
};

/// A steered device over a body, and the contact of its tip.
struct GuidedSteering
{
  static constexpr double Period = 1e-3;     // s
  static constexpr double HoverHeight = 3.0; // mm
  static constexpr double FastestStep = 1.0; // mm in a tick; from GuidedHand::FastestSpeed
  // mm; rounding of positions that are converted to m and back
  static constexpr double Rounding = 1e-9;
  // Ticks from 2 mm below to 3 mm above the surface: two time constants.
  static constexpr int LongestLift = 60;

  explicit GuidedSteering(const GuidedShape& shape)
    : Shape(shape)
    , Body(uniformBody(shape.surface))
    , Touch(*this->Body)
  {
    this->Device.setBody(this->Body, WorkspaceMapping());
  }

  SurfacePlace placeAt(const Vector3& near) const
  {
    const SurfacePoint found = this->Body->tree.closest(near);
    return { found.projection.point,
      surfaceNormal(*this->Body, found.triangle, found.projection.weights) };
  }
  SurfacePlace anyPlace(std::mt19937& random) const
  {
    const auto count = static_cast<std::int32_t>(this->Body->surface.triangleCount());
    const std::int32_t triangle = std::uniform_int_distribution<std::int32_t>(0, count - 1)(random);
    std::exponential_distribution<double> part;
    Vector3 weights(part(random), part(random), part(random));
    weights /= weights.sum();
    Vector3 point = this->Body->surface.centre();
    for (int k = 0; k < 3; ++k)
    {
      point += weights[k] * this->Body->surface.corner(triangle, k);
    }
    return { point, surfaceNormal(*this->Body, triangle, weights) };
  }

  /// Steers the hand; a height of 0 or less presses.
  void steer(const SurfacePlace& place, double height)
  {
    this->At = place;
    this->Height = height;
    this->Set = std::max(0.0, -height);
    this->Since = 0;
    this->Device.touch(place.point, place.normal, height);
  }

  /// Runs one tick and checks all promises.
  void tick()
  {
    const double time = Period * this->Ticks++;
    const DeviceSample sample = this->Device.read(time);
    ASSERT_TRUE(sample.valid);
    const Vector3 tip = MillimetresPerMetre * sample.position;
    if (this->Ticks > 1)
    {
      ASSERT_LE((tip - this->Tip).norm(), FastestStep + Rounding) << this->words();
    }
    const Vector3 before = this->Tip;
    this->Tip = tip;
    ++this->Since;
    const Contact contact = this->Touch.update(tip);
    const double depth = contact.force.isZero(0.0) ? 0.0 : contact.deflection;
    ASSERT_NE(contact.state, ContactState::Invalid);
    if (depth > 0.0)
    {
      // The hand may be deeper than set only while it rises from a greater depth. The tolerance is
      // the rounding of the tip.
      constexpr double rising = 1e-9;
      ASSERT_TRUE(depth <= this->Set + Rounding || depth <= this->Depth + rising)
        << this->words() << depth << " mm deep, before " << this->Depth << " at "
        << before.transpose();
      ASSERT_TRUE(this->Set > 0.0 || this->Since < LongestLift) << this->words();
      this->Pressed += this->Set > 0.0;
    }
    else
    {
      ASSERT_GE(this->Shape.outside(tip), -this->Shape.facets - this->Set) << this->words();
    }
    this->Depth = depth;
  }
  void ticks(int count)
  {
    for (int i = 0; i < count && !::testing::Test::HasFatalFailure(); ++i)
    {
      this->tick();
    }
  }
  std::string words() const
  {
    std::ostringstream text;
    text << this->Shape.name << ", tick " << this->Ticks << ", " << this->Since
         << " after the goal " << this->At.point.transpose() << " normal "
         << this->At.normal.transpose() << " height " << this->Height << ", tip "
         << this->Tip.transpose() << ": ";
    return text.str();
  }

  const GuidedShape& Shape;
  std::shared_ptr<const ContactBody> Body;
  ToolContact Touch;
  SimulatedDevice Device{ Vector3(0.0, 0.0, 0.0) };
  SurfacePlace At{ Vector3::Zero(), Vector3::UnitZ() };
  double Height = HoverHeight;
  double Set = 0.0;   ///< the depth set, mm
  double Depth = 0.0; ///< depth in the last tick, mm
  Vector3 Tip = Vector3::Zero();
  int Ticks = 0;
  int Since = 0;   ///< ticks since the last goal
  int Pressed = 0; ///< ticks in contact
};

class GuidedHandOver : public ::testing::TestWithParam<std::size_t>
{
};
} // namespace

/// Two thousand jumps on each of five bodies, with drags, wheel and button. Some jumps begin before
/// the previous motion has ended.
TEST_P(GuidedHandOver, JumpsAroundTheBody)
{
  const GuidedShape shape = guidedShapes()[GetParam()];
  GuidedSteering hand(shape);
  std::mt19937 random(20 + static_cast<unsigned>(GetParam()));
  std::uniform_real_distribution<double> unit;
  hand.steer(hand.anyPlace(random), GuidedSteering::HoverHeight);
  constexpr int jumps = 2000;
  constexpr int framesTicks = 16;
  int arrived = 0;
  for (int jump = 0; jump < jumps && !HasFatalFailure(); ++jump)
  {
    const bool presses = unit(random) < 0.4;
    const double height = presses ? -0.05 - 1.95 * unit(random) : GuidedSteering::HoverHeight;
    hand.steer(hand.anyPlace(random), height);
    hand.ticks(unit(random) < 0.3 ? 1 + static_cast<int>(30.0 * unit(random))
                                  : 30 + static_cast<int>(170.0 * unit(random)));
    const int drags = unit(random) < 0.3 ? 5 : 0;
    for (int drag = 0; drag < drags && !HasFatalFailure(); ++drag)
    {
      const Vector3 by(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
      hand.steer(hand.placeAt(hand.At.point + 6.0 * by), hand.Height);
      hand.ticks(framesTicks);
    }
    if (jump % 50 == 0 && !HasFatalFailure())
    {
      // 1 s is longer than any path at 1000 mm/s plus 23 time constants, after which 1e-10 remains.
      hand.ticks(1500);
      const double rest =
        hand.Height > 0.0 ? (hand.Tip - hand.At.point).dot(hand.At.normal) : hand.Height;
      EXPECT_LE((hand.Tip - hand.At.point - rest * hand.At.normal).norm(), 1e-8) << hand.words();
      EXPECT_TRUE(hand.Height < 0.0 ||
        (rest > 0.0 && rest <= GuidedSteering::HoverHeight + GuidedSteering::Rounding));
      ++arrived;
    }
  }
  EXPECT_EQ(arrived, jumps / 50);
  EXPECT_GT(hand.Pressed, 10000);
  std::printf("%s: %d ticks, %d pressed\n", shape.name.c_str(), hand.Ticks, hand.Pressed);
}

/// A place off the surface, also outside the sphere around the body, is replaced by the closest
/// place on the surface.
TEST(GuidedHand, APlaceOffTheSurfaceIsPutOnIt)
{
  const GuidedShape shape = guidedShapes().front();
  GuidedSteering hand(shape);
  std::mt19937 random(7);
  hand.steer(hand.anyPlace(random), -0.5);
  hand.ticks(300);
  for (const double factor : { 1.1, 2.0, 3.0, 40.0 })
  {
    const SurfacePlace place = hand.anyPlace(random);
    const SurfacePlace off{ factor * place.point, place.normal };
    const SurfacePlace nearest = hand.placeAt(off.point);
    hand.steer(off, -0.5);
    hand.At = nearest;
    hand.ticks(1500);
    EXPECT_LE((hand.Tip - nearest.point + 0.5 * nearest.normal).norm(), 1e-6) << factor;
  }
}

INSTANTIATE_TEST_SUITE_P(FiveBodies, GuidedHandOver, ::testing::Range<std::size_t>(0, 5));
