// SPDX-License-Identifier: BSD-3-Clause
// The checker of the soak on relaxing bodies, for which only bounds are known.
#include "ExpectFound.h"
#include "TickSeries.h"

#include "Haptics/Servo/ServoStep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

namespace palpate::endurance
{
TEST(TickChecker, AcceptsBodiesThatRelax)
{
  std::uint64_t relaxing = 0;
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const TickSeries series(seed, true, -1.0, 0.0, seed < 6 ? Supplied::Relaxing : Supplied::All);
    const TickSeries::Finding found = series.firstFault();
    EXPECT_EQ(found.fault, TickFault::None)
      << seed << ": tick " << found.tick << ", " << found.text;
    relaxing += series.tally().relaxing;
  }
  EXPECT_GT(relaxing, TickSeries::Length);
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    const TickSeries series(seed, false, -1.0, 0.0, Supplied::Relaxing);
    const TickSeries::Finding found = series.firstFault();
    EXPECT_EQ(found.fault, TickFault::None) << seed << ": " << found.text;
    EXPECT_EQ(series.tally().visits, 2U);
    EXPECT_LT(series.tally().largestGain, 0.0); // relaxation dissipates energy
  }
}

TEST(TickChecker, FindsMoreThanABodyThatRelaxesCanGive)
{
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    const TickSeries series(seed, false, 0.0, 0.0, Supplied::Relaxing);
    std::size_t tried = 0;
    for (std::size_t i = 1; i < TickSeries::Absent; i += 311)
    {
      const TickFacts& tick = series.ticks[i];
      if (tick.sent.norm() < 0.02 || tick.sceneShare < 1.0)
      {
        continue;
      }
      ++tried;
      TickSeries more(series);
      more.ticks[i].contactForce *= 2.2; // larger than the bound, because P = 1
      more.ticks[i].idealForce *= 2.2;
      EXPECT_EQ(more.firstFault().fault, TickFault::Contact) << seed << " " << i;
      TickSeries pull(series);
      pull.ticks[i].contactForce *= -1.0;
      pull.ticks[i].idealForce *= -1.0;
      expectFound(pull, TickFault::Contact, i);
      TickSeries sent(series);
      sent.send(i, 2.5 * tick.idealForce.norm() * tick.sent.normalized());
      expectFound(sent, TickFault::Sent, i);
    }
    EXPECT_GT(tried, 4U);
  }
}

TEST(TickChecker, AcceptsALongWayOverABodyThatRelaxes)
{
  // The tip is held inside the body until most of the force has relaxed. Then it moves by several
  // contact radii in one tick. The drag corresponds to the exchange of all material and is larger
  // than the bound for a short displacement.
  SceneSupply supply(1, Supplied::Relaxing);
  double largest = 0.0; // largest drag divided by the bound for a short displacement
  for (int made = 0; made < 6; ++made)
  {
    const SuppliedScene scene = supply.make();
    for (const int hold : { 400, 4000 })
    {
      ServoStep step(
        std::make_unique<ServoScene>(scene.kernel), TickSeries::mapping(), TickSeries::safety());
      FeltScene frictionless = scene.felt;
      frictionless.friction = 0.0;
      TickChecker checker(TickSeries::frame(), DeviceLimits{}, frictionless);
      for (int i = 0; i < hold + 3; ++i)
      {
        const double high = i == 0 ? 2.0 : -2.5;
        const double angle = i < hold ? 0.0 : 0.3; // rad; about 14 mm
        DeviceSample sample;
        sample.valid = true;
        sample.position = TickSeries::frame().position(supply.centre() +
          (SceneSupply::Radius + high) *
            Vector3(std::cos(angle), std::sin(angle), 0.1).normalized());
        const double time = i / TickSeries::Rate;
        const Tick felt = step.step(sample, time);
        const TickVerdict verdict = checker.check(factsOf(time, sample, felt.deviceForce, felt));
        EXPECT_FALSE(verdict) << made << ", tick " << i << ": " << verdict.text;
        const double radius = frictionless.tool.contactRadius(2.5);
        largest = i == hold ? std::max(largest,
                                felt.contact.friction.norm() /
                                  (frictionless.relaxation * 2.5 *
                                    frictionless.tool.force(2.5, 0.08) / (8.0 * radius)))
                            : largest;
      }
    }
  }
  EXPECT_GT(largest, 1.2); // the bound for a short displacement is exceeded
}

TEST(TickChecker, FindsEnergyThatABodyThatRelaxesGives)
{
  // Exchanges the forces of the way in and the way out. Each tick is within all bounds.
  TickSeries series(1, false, 0.0, 0.0, Supplied::Relaxing);
  for (std::size_t i = 1; i < TickSeries::Length; ++i)
  {
    TickFacts& tick = series.ticks[i];
    const Vector3 way = tick.tip - series.ticks[i - 1].tip;
    const double share = tick.contactForce.dot(way) > 0.0 ? 1.0 : 0.4;
    tick.contactForce *= share;
    tick.idealForce *= share;
    series.send(i, Vector3::Zero());
  }
  EXPECT_EQ(series.firstFault().fault, TickFault::Energy);
}
} // namespace palpate::endurance
