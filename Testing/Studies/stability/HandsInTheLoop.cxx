// SPDX-License-Identifier: BSD-3-Clause
// Two coupled devices on one half-space: the largest stable stiffness of their opposite and of
// their common motion, and the effect of each link of the chain under the strongest push on both.
#include "EnergyAudit.h"
#include "Haptics/Servo/ServoStep.h"
#include "LoopPoles.h"
#include "Parts.h"
#include "Renderings.h"
#include "ResponseModels.h"
#include "Restlessness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace palpate::testing
{
namespace
{
constexpr double EachPush = 1.0; // N
constexpr double Circle = 3.14159265358979323846;
constexpr double FlatRadius = 1.6;                   // mm
constexpr double RadiusInMetres = 1e-3 * FlatRadius; // m
constexpr std::size_t Hands = 2;
using Heights = std::array<double, Hands>; // m

/// Two masses that move up and down at a distance (m), each under the push of the setting, with one
/// ServoStep.
class TwoHands
{
public:
  TwoHands(const LoopSetting& setting, std::shared_ptr<const ContactBody> body,
    const SafetySettings& safety, double apart, const Heights& begin)
    : Setting(setting)
    , Step(std::make_unique<ServoScene>(std::move(body), ContactSettings(), 1.0, Hands),
        { { {}, safety }, { {}, safety } })
    , Audit(setting.plant.damping, setting.period(),
        static_cast<int>(std::lround(setting.plant.forceDelay * setting.rate)))
  {
    for (std::size_t i = 0; i < Hands; ++i)
    {
      const double x = (static_cast<double>(i) - 0.5) * apart;
      this->Devices[i] = std::make_unique<SimulatedDevice>(setting.plant, setting.hand,
        std::vector<WayPoint>{ { 0.0, { x, 0.0, begin[i] } } }, setting.specification());
    }
  }

  void tick()
  {
    const double time = this->Ticks++ * this->Setting.period();
    std::array<DeviceSample, Hands> samples;
    for (std::size_t i = 0; i < Hands; ++i)
    {
      samples[i] = this->Devices[i]->read(time);
      this->Place[static_cast<int>(i)] = this->Devices[i]->truePosition().z();
    }
    // Both move along one axis only, so the sum of their works equals that of one motion in a
    // plane.
    this->Audit.moved(this->Place);
    std::array<Tick, Hands> felt;
    this->Step.step(samples.data(), time, felt.data());
    Eigen::Vector3d forces = Eigen::Vector3d::Zero();
    bool isFree = true;
    for (std::size_t i = 0; i < Hands; ++i)
    {
      const double force = felt[i].deviceForce.z();
      forces[static_cast<int>(i)] = force;
      isFree = isFree && felt[i].contact.state == ContactState::None && force == 0.0;
      this->Peak = std::max(this->Peak, force);
      this->Devices[i]->write({ 0.0, 0.0, force - this->Setting.push });
    }
    this->Audit.told(forces, isFree);
  }
  /// Runs the loop and returns the largest speed of either mass (m/s) at the ticks.
  double peakSpeed(int ticks)
  {
    double peak = 0.0;
    for (int i = 0; i < ticks; ++i)
    {
      this->tick();
      for (const auto& device : this->Devices)
      {
        peak = std::max(peak, device->trueVelocity().norm());
      }
    }
    return peak;
  }
  /// Runs the loop and returns first + `sign` second, m, at the ticks.
  std::vector<double> motion(double sign, int ticks)
  {
    std::vector<double> found;
    for (int i = 0; i < ticks; ++i)
    {
      this->tick();
      found.push_back(this->Place[0] + sign * this->Place[1]);
    }
    return found;
  }
  double swing(double sign, int ticks)
  {
    const std::vector<double> found = this->motion(sign, ticks);
    const auto [low, high] = std::minmax_element(found.begin(), found.end());
    return *high - *low;
  }
  double peakForce() const { return this->Peak; }
  double generated() const { return this->Audit.mostGenerated(); }

private:
  LoopSetting Setting;
  ServoStep Step;
  EnergyAudit Audit;
  std::array<std::unique_ptr<SimulatedDevice>, Hands> Devices;
  Eigen::Vector3d Place = Eigen::Vector3d::Zero(); ///< heights of both, m
  int Ticks = 0;
  double Peak = 0.0;
};

/// Two flat ends with a radius of 1.6 mm on a half-space; each has the stiffness K = 2aE*.
struct Pair
{
  LoopSetting setting;
  double radii = 0.0;     ///< distance of the axes, in radii
  bool isOpposite = true; ///< which of the two motions is disturbed

  double apart() const { return this->radii * RadiusInMetres; }
  /// K C by Boussinesq for a flat end: the coupling relative to the stiffness of a single one.
  double share() const { return 2.0 / (Circle * this->radii); }
  double sign() const { return this->isOpposite ? -1.0 : 1.0; }
  int order() const
  {
    return 2 +
      static_cast<int>(std::ceil(this->setting.plant.forceDelay * this->setting.rate - 1e-9));
  }
  TwoHands disturbed(double stiffness) const
  {
    const double modulus = 1e-3 * stiffness / (2.0 * FlatRadius); // MPa
    const double range = 4e3 * EachPush / stiffness;
    // Each end carries its push. The surface under each end is also lowered by the other push.
    const double depth = EachPush / stiffness * (1.0 + this->share());
    const double swing = 0.05 * depth;
    return { this->setting, coupledPlate(linearModel("linear", 1e-3 * stiffness, range), modulus),
      safetyOf(Control::None, LoopSetting()), this->apart(),
      { -depth + swing, -depth + this->sign() * swing } };
  }
};

double largestStiffness(const Pair& pair)
{
  const int order = pair.order();
  double low = 0.02 * pair.setting.passiveStiffness();
  double high = 20.0 * pair.setting.passiveStiffness();
  for (int i = 0; i < 40; ++i)
  {
    const double middle = std::sqrt(low * high);
    TwoHands hands = pair.disturbed(middle);
    hands.motion(pair.sign(), order + 2); // runs until the first forces and rounds have arrived
    const bool isStable = largestPole(hands.motion(pair.sign(), 2 * order + 4), order) < 1.0;
    (isStable ? low : high) = middle;
  }
  return low;
}

double growth(const Pair& pair, double stiffness)
{
  TwoHands hands = pair.disturbed(stiffness);
  const int watched = pair.setting.watchedTicks();
  const int window = watched / 4;
  hands.motion(pair.sign(), window);
  const double first = hands.swing(pair.sign(), window);
  hands.motion(pair.sign(), watched);
  return hands.swing(pair.sign(), window) / first;
}

void printLimit(const Pair& pair)
{
  const double limit = largestStiffness(pair);
  std::printf("%g,%g,%g,%g,%g,%s,%.8g,%.5g,%.5g\n", pair.setting.rate, pair.setting.plant.mass,
    pair.setting.plant.damping, pair.setting.plant.forceDelay * pair.setting.rate, pair.radii,
    pair.isOpposite ? "opposite" : "common", limit, growth(pair, 0.99 * limit),
    growth(pair, 1.01 * limit));
  std::fflush(stdout);
}

/// Both tools are released above the body, one after the other.
void printPress(
  const LoopSetting& setting, const char* tool, double modulus, double apart, Control control)
{
  TwoHands hands(setting, coupledPlate(toolModel(tool, modulus, 1.5 * StrongestPush), modulus),
    safetyOf(control, setting), 1e-3 * apart, { 1e-3, 1.7e-3 });
  const int ticks = setting.watchedTicks();
  hands.peakSpeed(5 * ticks);
  const double last = hands.peakSpeed(ticks);
  std::printf("%s,%g,%g,%g,%s,%d,%.5g,%.4g,%.4g\n", tool, modulus, setting.rate, apart,
    nameOf(control), last < StillSpeed ? 1 : 0, hands.peakForce(), 1e3 * last,
    1e3 * hands.generated());
  std::fflush(stdout);
}

LoopSetting settingOf(double rate, double push, double delay)
{
  LoopSetting setting;
  setting.rate = rate;
  setting.push = push;
  setting.hand = Nobody;
  setting.plant.damping = 1.0;
  setting.plant.forceDelay = delay / rate;
  return setting;
}
} // namespace

void handsLimits(bool isQuick)
{
  std::puts("rate_Hz,mass_kg,damping_Ns_per_m,delay_ticks,apart_radii,motion,limit_N_per_m,"
            "growth_below,growth_above");
  for (const double rate : { 1000.0, 4000.0 })
  {
    for (const double delay : { 0.0, 1.0 })
    {
      for (const double radii : { 2.0, 2.5, 4.0, 10.0 })
      {
        for (const bool isOpposite : { true, false })
        {
          if (!isQuick || (rate == 1000.0 && radii < 3.0))
          {
            printLimit({ settingOf(rate, EachPush, delay), radii, isOpposite });
          }
        }
      }
    }
  }
}

void handsPress(bool isQuick)
{
  std::puts("model,modulus_MPa,rate_Hz,apart_mm,control,rests,peak_force_N,last_speed_mm_s,"
            "generated_mJ");
  constexpr double modulus = 1.0; // MPa: stiff tissue
  for (const double rate : { 1000.0, 4000.0 })
  {
    for (const char* tool : { "sphere:6.35", "flat:1.6" })
    {
      for (const double apart : { 4.0, 10.0, 30.0 })
      {
        if (*tool == 's' && apart < 10.0)
        {
          continue; // under the push the balls would overlap
        }
        for (const Control control : AllControls)
        {
          if (!isQuick || (rate == 1000.0 && apart == 10.0 && *tool == 's'))
          {
            printPress(settingOf(rate, StrongestPush, 0.0), tool, modulus, apart, control);
          }
        }
      }
    }
  }
}
} // namespace palpate::testing
