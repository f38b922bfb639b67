// SPDX-License-Identifier: BSD-3-Clause
// Parts a and b for a body that relaxes: the largest stable slow stiffness of a linear plate, and
// the effect of each link of the safety chain under the strongest push.
#include "LoopPoles.h"
#include "Parts.h"
#include "RelaxingModels.h"
#include "Renderings.h"
#include "Restlessness.h"

#include <cmath>
#include <cstdio>
#include <vector>

namespace palpate::testing
{
namespace
{
constexpr double RestingPush = 1.0; // N

struct RelaxingCase
{
  LoopSetting setting;
  PronySeries series;
  int elements = 16;

  double delay() const { return this->setting.plant.forceDelay * this->setting.rate; }
  /// Order of the loop: mass, branches, delayed forces.
  int order() const
  {
    return 2 + static_cast<int>(this->series.count) +
      static_cast<int>(std::ceil(this->delay() - 1e-9));
  }
  /// A plate with a range of twice the rest depth. Beyond the range the curve continues along its
  /// tangent.
  ServoRendering plate(double stiffness) const
  {
    const double range = 2e3 * RestingPush / stiffness;
    return { relaxingPlate(linearModel("linear", 1e-3 * stiffness, range), this->series),
      safetyOf(Control::None, LoopSetting()), withElements(this->elements) };
  }
  /// Starts at the rest depth under the push, disturbed by a tenth of this depth.
  VirtualLoop disturbed(double stiffness, Rendering& plate) const
  {
    const double depth = this->setting.push / stiffness;
    return VirtualLoop(this->setting,
      { { 0.0, { 0.0, 0.0, -1.1 * depth } }, { 1e-12, { 0.0, 0.0, -depth } } }, plate);
  }
};

bool isStable(const RelaxingCase& given, double stiffness)
{
  ServoRendering plate = given.plate(stiffness);
  VirtualLoop loop = given.disturbed(stiffness, plate);
  loop.run(given.order() - 2); // until the first forces have arrived
  // More poles need more readings to distinguish them.
  return largestSwingingPole(loop.heights(24 * given.order()), given.order()) < 1.0;
}

double largestStiffness(const RelaxingCase& given)
{
  double low = 0.02 * given.setting.passiveStiffness();
  double high = 20.0 * given.setting.passiveStiffness();
  for (int i = 0; i < 40; ++i)
  {
    const double middle = std::sqrt(low * high);
    (isStable(given, middle) ? low : high) = middle;
  }
  return low;
}

/// Ratio of the later swing to the first.
double growth(const RelaxingCase& given, double stiffness)
{
  ServoRendering plate = given.plate(stiffness);
  VirtualLoop loop = given.disturbed(stiffness, plate);
  const int watched = 2 * given.setting.watchedTicks();
  const int window = watched / 8;
  loop.run(window);
  const double first = loop.swing(window);
  loop.run(watched);
  return loop.swing(window) / first;
}

void printLimit(const RelaxingCase& given)
{
  const double limit = largestStiffness(given);
  std::printf("%g,%g,%g,%g,%s,%d,%.8g,%.5g,%.5g\n", given.setting.rate, given.setting.plant.mass,
    given.setting.plant.damping, given.delay(), materialOf(given.series).c_str(), given.elements,
    limit, growth(given, 0.99 * limit), growth(given, 1.01 * limit));
  std::fflush(stdout);
}

/// The tip is released 1 mm above the body, under the strongest push.
void printPress(
  const RelaxingCase& given, const ResponseModel& model, double modulus, Control control)
{
  ServoRendering rendering(relaxingPlate(model, given.series), safetyOf(control, given.setting),
    withElements(given.elements));
  VirtualLoop loop(given.setting, { { 0.0, { 0.0, 0.0, 1e-3 } } }, rendering);
  const Course course = anyMotion(loop, given.setting.watchedTicks());
  std::printf("%s,%g,%g,%s,%d,%s,%d,%.5g,%.4g,%.4g\n", model.name.c_str(), modulus,
    given.setting.rate, materialOf(given.series).c_str(), given.elements, nameOf(control),
    course.rests ? 1 : 0, course.peakForce, 1e3 * course.speed, 1e3 * course.generated);
  std::fflush(stdout);
}
} // namespace

void relaxingLimits(bool isQuick)
{
  std::puts("rate_Hz,mass_kg,damping_Ns_per_m,delay_ticks,material,elements,limit_N_per_m,"
            "growth_below,growth_above");
  for (const double rate : { 1000.0, 4000.0 })
  {
    for (const PronySeries& series : relaxingMaterials())
    {
      for (const double delay : { 0.0, 1.0 })
      {
        for (const int elements : AllElements)
        {
          if (isQuick && (rate != 1000.0 || elements == 0))
          {
            continue;
          }
          RelaxingCase given;
          given.series = series;
          given.elements = elements;
          given.setting.rate = rate;
          given.setting.push = RestingPush;
          given.setting.hand = Nobody;
          given.setting.plant.damping = 1.0;
          given.setting.plant.forceDelay = delay / rate;
          printLimit(given);
        }
      }
    }
  }
}

void relaxingPress(bool isQuick)
{
  std::puts("model,modulus_MPa,rate_Hz,material,elements,control,rests,peak_force_N,"
            "last_speed_mm_s,generated_mJ");
  std::vector<PronySeries> materials = relaxingMaterials();
  materials.insert(materials.begin(), PronySeries());
  constexpr double modulus = 1.0; // MPa: stiff tissue
  for (const double rate : { 1000.0, 4000.0 })
  {
    for (const char* tool : { "sphere:6.35", "flat:1.6" })
    {
      const ResponseModel model = toolModel(tool, modulus, 1.5 * StrongestPush);
      for (const PronySeries& series : materials)
      {
        for (const int elements : AllElements)
        {
          if (isQuick && (rate != 1000.0 || *tool == 'f'))
          {
            continue;
          }
          for (const Control control : AllControls)
          {
            RelaxingCase given;
            given.series = series;
            given.elements = elements;
            given.setting.rate = rate;
            given.setting.push = StrongestPush;
            given.setting.hand = Nobody;
            printPress(given, model, modulus, control);
          }
        }
      }
    }
  }
}
} // namespace palpate::testing
