// SPDX-License-Identifier: BSD-3-Clause
// Friction in the servo loop: a mass on a plane, held by friction against a force that oscillates
// within the limit, and the largest stiffness that a sampled loop can hold.
#include "Contact/Friction.h"
#include "FrictionCurves.h"

#include "Agreement.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <vector>

using palpate::Friction;
using palpate::FrictionModel;
using palpate::FrictionSettings;
using palpate::Pi;
using palpate::Vector3;
using palpate::testing::agrees;
using palpate::testing::PowerCurve;

namespace
{
constexpr double Mass = 0.1;    // kg
constexpr double Period = 1e-3; // s
constexpr double NormalForce = 1.0;
const PowerCurve Curve{ 1.0, 1.0, 2.0 }; // 1 N at 1 mm

/// A free mass with damping b (N·s/m), moved exactly under a force that is constant over a period.
class HeldMass
{
public:
  explicit HeldMass(double damping)
    : Damping(damping)
    , Decay(std::exp(-damping * Period / Mass))
  {
  }
  /// Position in mm.
  double position() const { return 1e3 * this->X; }
  void push(double force)
  {
    const double end = force / this->Damping;
    const double excess = this->V - end;
    this->X += end * Period + excess * Mass / this->Damping * (1.0 - this->Decay);
    this->V = end + excess * this->Decay;
  }

private:
  double Damping;
  double Decay;
  double X = 0.0;
  double V = 0.0;
};

double tangentialForce(Friction& friction, double x)
{
  return friction.update({ x, 0.0, 0.0 }, Vector3::UnitZ(), NormalForce, 1.0, Curve).force.x();
}

/// z_max = 1 mm under 1 N. Returns the drift in mm of 0.1 kg in 8 s under 0.5 + 0.2 sin(2π 2 t) N
/// with a friction limit of 1 N: the difference between the mean positions of the last and the
/// first cycle. Load and oscillation are raised slowly, so that no ringing remains.
double drift(const FrictionSettings& settings, double damping)
{
  Friction friction(settings);
  HeldMass mass(damping);
  std::vector<double> positions;
  const double rise = 4.0;
  const auto ticks = static_cast<int>((rise + 8.5) / Period);
  for (int i = 0; i < ticks; ++i)
  {
    const double time = i * Period - rise;
    const double grown = 0.5 - 0.5 * std::cos(Pi * std::min(1.0 + time / rise, 1.0));
    const double load = grown * (0.5 + 0.2 * std::sin(2.0 * Pi * 2.0 * time));
    mass.push(load + tangentialForce(friction, mass.position()));
    if (time >= 0.0)
    {
      positions.push_back(mass.position());
    }
  }
  const std::size_t cycle = 500;
  double first = 0.0;
  double last = 0.0;
  for (std::size_t i = 0; i < cycle; ++i)
  {
    first += positions[i] / cycle;
    last += positions[positions.size() - cycle + i] / cycle;
  }
  return last - first;
}

/// ln of the growth of the amplitude of a sticking mass in 200 s.
double growth(double stiffness, double damping)
{
  FrictionSettings settings = frictionOf(FrictionModel::ElastoPlastic, 1.0, 1.0);
  settings.coefficient = 1e9; // large, so that the contact never slides
  settings.tangentialStiffness = 1e-3 * stiffness;
  Friction friction(settings);
  HeldMass mass(damping);
  tangentialForce(friction, 0.0);
  mass.push(1e-3); // small initial push
  const auto amplitude = [&]
  {
    double largest = 0.0;
    for (int i = 0; i < 1000; ++i)
    {
      mass.push(tangentialForce(friction, mass.position()));
      largest = std::max(largest, std::abs(mass.position()));
    }
    return largest;
  };
  const double before = amplitude();
  double after = before;
  for (int i = 0; i < 199; ++i)
  {
    after = amplitude();
  }
  return std::log(after / before);
}
} // namespace

TEST(FrictionDrift, DahlPerCycle)
{
  // Between z = 0.3 and 0.7 z_max: forwards ln((1-z₁)/(1-z₂)), backwards ln((1+z₂)/(1+z₁)).
  Friction friction(frictionOf(FrictionModel::Dahl, 1.0, 1.0));
  double x = 0.0;
  tangentialForce(friction, x);
  x -= std::log(1.0 - 0.3);
  EXPECT_TRUE(agrees(tangentialForce(friction, x), -0.3, 1e-14));
  const double start = x;
  const int cycles = 20;
  for (int i = 0; i < cycles; ++i)
  {
    x += std::log(0.7 / 0.3);
    EXPECT_TRUE(agrees(tangentialForce(friction, x), -0.7, 1e-13)); // rounding of x
    x -= std::log(1.7 / 1.3);
    EXPECT_TRUE(agrees(tangentialForce(friction, x), -0.3, 1e-13));
  }
  EXPECT_TRUE(agrees((x - start) / cycles, 0.5790338738, 1e-10)); // the reference has ten digits
}

TEST(FrictionDrift, UnderASwingingLoad)
{
  for (const double damping : { 1.0, 5.0 })
  {
    const double dahl = drift(frictionOf(FrictionModel::Dahl, 1.0, 1.0), damping);
    // 16 cycles of the closed form. Inertia and damping (0.006 and 0.008 N per N·s/m) change the
    // oscillation of 0.2 N at the contact by 3 %. The drift is proportional to the square of the
    // oscillation.
    EXPECT_NEAR(dahl, 16.0 * 0.5790338738, 0.08 * 9.26) << damping;

    FrictionSettings eight = frictionOf(FrictionModel::ElastoPlastic, 1.0, 1.0);
    eight.breakaway = 0.0;
    const double smooth = drift(eight, damping);
    EXPECT_GT(dahl, 20.0 * smooth) << damping;
    EXPECT_GT(smooth, 0.05); // mm: it creeps by about 6 µm per cycle
    eight.stickRadius = 0.5;
    EXPECT_GT(drift(eight, damping), 2.0);

    // With the default settings, and with stick and slide, there is no drift except for the
    // remaining ringing.
    EXPECT_LT(std::abs(drift(frictionOf(FrictionModel::ElastoPlastic, 1.0, 1.0), damping)), 1e-6);
    FrictionSettings hard = frictionOf(FrictionModel::ElastoPlastic, 1.0, 1.0);
    hard.breakaway = 1.0;
    hard.stickRadius = 1.0;
    EXPECT_LT(std::abs(drift(hard, damping)), 1e-6);
  }
}

TEST(FrictionDrift, ShapeDerivedStopsDrifting)
{
  // Masing's loops are closed, so there is no drift after the first loading.
  FrictionSettings settings = frictionOf(FrictionModel::ShapeDerived, 1.0, 1.0);
  EXPECT_LT(std::abs(drift(settings, 1.0)), 1e-3);
}

TEST(FrictionDrift, StickStiffnessLimit)
{
  // Limit for a mass with damping and a force that is constant over a period (reference: the poles
  // of the discrete loop): K = b(1-e)/[(m/b)(1-e) - eT], e = exp(-bT/m), which is 2003.33889 N/m
  // for b = 1 N·s/m. Passivity requires K <= 2b/T = 2000 N/m.
  const struct
  {
    double damping;
    double limit;
  } cases[] = { { 0.5, 1000.8340280185877 }, { 1.0, 2003.338892591564 },
    { 2.0, 4013.377836939064 } };
  for (const auto& one : cases)
  {
    const double e = std::exp(-one.damping * Period / Mass);
    EXPECT_TRUE(agrees(
      one.damping * (1.0 - e) / (Mass / one.damping * (1.0 - e) - e * Period), one.limit, 1e-9));
    // The larger pole has the squared magnitude e + K/b (...), which is linear in K: the growth per
    // tick is (K/K* - 1) bT/2m.
    for (const double share : { -2e-3, -1e-3, 1e-3, 2e-3 })
    {
      const double expected = share * 0.5 * one.damping * Period / Mass * 199000.0;
      EXPECT_NEAR(
        growth((1.0 + share) * one.limit, one.damping), expected, 0.05 * std::abs(expected) + 0.01)
        << one.damping << ' ' << share;
    }
    EXPECT_LT(growth(2.0 * one.damping / Period, one.damping), 0.0);
  }
}
