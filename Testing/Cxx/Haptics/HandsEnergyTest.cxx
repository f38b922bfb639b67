// SPDX-License-Identifier: BSD-3-Clause
// Passivity control of two hands whose contacts lower the surface for each other. In a passive
// scene it does not reduce their forces, even if one hand leaves while the other presses. In an
// active scene both hands together get no more energy than they put in.
#include "Haptics/Servo/ServoStep.h"

#include "CoupledPlate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace hands_energy
{
using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr double Spring = 2.0 * CoupledPlate::Flat; ///< N/mm
constexpr double Period = 1e-3;

/// Two hands on flat ends 5 mm apart, at given depths (mm). Their forces are the forces of the
/// springs times `scale`.
struct TwoHands
{
  TwoHands(const SafetySettings& safety, double scale)
    : mapping(Eigen::Matrix3d::Identity(), Vector3d::Zero(), scale)
    , step(std::make_unique<ServoScene>(CoupledPlate(true).body(), ContactSettings(), 1.0, 2),
        { { mapping, safety }, { mapping, safety } })
  {
  }

  const std::array<Tick, 2>& press(
    double first, double second, const std::array<bool, 2>& areThere = { true, true })
  {
    this->places = { this->mapping.toDevice({ 25.0, 29.3, -first }),
      this->mapping.toDevice({ 30.0, 29.3, -second }) };
    std::array<DeviceSample, 2> samples;
    for (std::size_t i = 0; i < 2; ++i)
    {
      samples[i].valid = areThere[i];
      samples[i].position = this->places[i];
    }
    this->step.step(samples.data(), Period * this->tick++, this->ticks.data());
    return this->ticks;
  }

  WorkspaceMapping mapping;
  ServoStep step;
  std::array<Tick, 2> ticks;
  std::array<Vector3d, 2> places; ///< m
  int tick = 0;
};
} // namespace

// The second hand presses where the first hand has lowered the surface, and leaves after the first
// hand. The second hand gets more energy than it put in; the first hand got less by the same
// amount.
TEST(HandsEnergy, WhatOneLeavesTheOtherGets)
{
  SafetySettings safety = SafetySettings::of({});
  safety.capStiffness = false;
  // 400 and 1000 N/m for one hand; 537 and 1342 N/m for both, less than the device's 1500 N/m.
  for (const double scale : { 0.1, 0.25 })
  {
    TwoHands hands(safety, scale);
    std::array<double, 2> depths{ -0.2, -0.2 };
    double largest = 0.0;
    const auto go = [&](double first, double second)
    {
      const std::array<double, 2> from = depths;
      for (int i = 1; i <= 300; ++i)
      {
        depths = { from[0] + (first - from[0]) * i / 300.0,
          from[1] + (second - from[1]) * i / 300.0 };
        for (const Tick& tick : hands.press(depths[0], depths[1]))
        {
          EXPECT_EQ(tick.acted & static_cast<std::uint16_t>(SafetyLink::Passivity), 0)
            << scale << " at " << depths[0] << ", " << depths[1];
          largest = std::max(largest, tick.deviceForce.z());
        }
      }
    };
    for (int turn = 0; turn < 2; ++turn)
    {
      go(0.8, -0.2);
      go(0.8, 0.8);
      go(-0.2, 0.8);
      go(-0.2, -0.2);
    }
    EXPECT_NEAR(largest, 0.8 * Spring, 1e-5); // rounding of floats
  }
}

// Springs of 4000 N/m on devices whose damping b allows 1500 N/m. The hands move at random and
// independently. Together they get at most b |dx|²/T per tick more than they put in, for any
// transfer of energy between them.
TEST(HandsEnergy, TogetherTheyGetNoMoreThanTheyPutIn)
{
  SafetySettings safety = SafetySettings::of({});
  safety.capStiffness = false;
  safety.maximumForce = std::numeric_limits<double>::infinity();
  const double damping = 0.5 * safety.maximumStiffness * Period;
  std::mt19937 random(5);
  std::normal_distribution<double> step(0.0, 0.08); // mm
  TwoHands hands(safety, 1.0);
  std::array<double, 2> depths{ -0.1, -0.1 };
  std::array<Vector3d, 2> places;
  std::array<Vector3d, 2> forces{ Vector3d::Zero(), Vector3d::Zero() };
  double balance = 0.0; // J
  double least = 0.0;
  int acted = 0;
  for (int tick = 0; tick < 20000; ++tick)
  {
    for (double& depth : depths)
    {
      depth = std::clamp(depth + step(random), -0.3, 1.0);
    }
    const auto& ticks = hands.press(depths[0], depths[1]);
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Vector3d moved = tick > 0 ? Vector3d(hands.places[i] - places[i]) : Vector3d::Zero();
      balance += damping * moved.squaredNorm() / Period - forces[i].dot(moved);
      places[i] = hands.places[i];
      forces[i] = ticks[i].deviceForce;
      acted += (ticks[i].acted & static_cast<std::uint16_t>(SafetyLink::Passivity)) != 0;
    }
    least = std::min(least, balance);
  }
  EXPECT_GE(least, -2.0 * PassivityControl::Slack * 2.0); // the Slack of both hands, and rounding
  EXPECT_GT(acted, 1000);
}

// As above, with gaps of 1 to 15 readings that end no contact. The hands move smoothly. An
// unobserved hand is assumed to accelerate by at most 20 m/s²; these hands accelerate by 0.5 m/s².
TEST(HandsEnergy, GapsGiveThemNoMore)
{
  SafetySettings safety = SafetySettings::of({});
  safety.capStiffness = false;
  safety.maximumForce = std::numeric_limits<double>::infinity();
  const double damping = 0.5 * safety.maximumStiffness * Period;
  std::mt19937 random(7);
  std::uniform_int_distribution<int> length(1, 15);
  TwoHands hands(safety, 1.0);
  std::array<int, 2> missing{ 0, 0 }; // ticks without a reading; negative: with readings
  std::array<Vector3d, 2> places;
  std::array<Vector3d, 2> forces{ Vector3d::Zero(), Vector3d::Zero() };
  double balance = 0.0; // J
  double least = 0.0;
  int continued = 0;
  for (int tick = 0; tick < 20000; ++tick)
  {
    const double t = Period * tick;
    std::array<bool, 2> wereThere{ missing[0] <= 0, missing[1] <= 0 };
    for (int& left : missing)
    {
      left = left == 1 ? -5 * length(random) : left == 0 && tick > 100 ? length(random) : left;
      left += left > 0 ? -1 : left < 0 ? 1 : 0;
    }
    const std::array<bool, 2> areThere{ missing[0] <= 0, missing[1] <= 0 };
    const auto& ticks = hands.press(
      0.3 + 0.7 * std::sin(19.0 * t - 1.5), 0.3 + 0.7 * std::sin(26.0 * t - 1.5), areThere);
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Vector3d moved = tick > 0 ? Vector3d(hands.places[i] - places[i]) : Vector3d::Zero();
      balance += damping * moved.squaredNorm() / Period - forces[i].dot(moved);
      places[i] = hands.places[i];
      forces[i] = ticks[i].deviceForce;
      continued += areThere[i] && !wereThere[i] && ticks[i].contact.normalForce > 0.0 &&
        (ticks[i].acted & static_cast<std::uint16_t>(SafetyLink::Gate)) == 0;
    }
    least = std::min(least, balance);
  }
  EXPECT_GE(least, -2.0 * PassivityControl::Slack * 2.0);
  EXPECT_GT(continued, 300);
}
} // namespace hands_energy
