// SPDX-License-Identifier: BSD-3-Clause
// Part b: the settings at which the cylinder of Mahvash and Hayward (2002, section 5) is free of
// oscillation. The mesh has radial normals and the responses of Table 1 at every vertex; the force
// is that of eq. 3.
#include "Parts.h"
#include "Renderings.h"
#include "ResponseModels.h"
#include "RestingDepth.h"
#include "Restlessness.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>
#include <memory>

namespace palpate::testing
{
namespace
{
constexpr double Radius = 50.0; // mm; the paper says only "large"
constexpr double Push = 5.0;    // N

/// A cylinder along y; its highest line is z = 0.
Surface cylinder()
{
  constexpr int around = 160; // spacing of 2 mm
  constexpr int along = 30;
  Surface body;
  for (int i = 0; i <= along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const double angle = 6.283185307179586 * (j + 0.3) / around;
      body.points.emplace_back(
        Radius * std::sin(angle), 2.0 * i - 30.7, Radius * (std::cos(angle) - 1.0));
      if (i < along)
      {
        const int a = i * around + j;
        const int b = i * around + (j + 1) % around;
        body.triangles.push_back({ a, b, b + around });
        body.triangles.push_back({ a, b + around, a + around });
      }
    }
  }
  return body;
}

std::shared_ptr<const ContactBody> cylinderOf(const ResponseModel& model)
{
  const Surface surface = cylinder();
  ResponseStore store = storedAt(surface, model);
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const Vector3 radial(surface.points[p].x(), 0.0, surface.points[p].z() + Radius);
    Eigen::Map<Eigen::Vector3f>(store.normal.data() + 3 * p) = (radial / Radius).cast<float>();
  }
  return bodyOf(surface, store, model);
}

ResponseModel table1(const char* tool, double modulus)
{
  ResponseModel model = toolModel(tool, modulus, 1.5 * Push);
  model.range = 30.0; // soft bodies need a larger range than the other bodies of the study
  model.range = model.depthOf(1.5 * Push);
  return model;
}

/// A tip pressed with 5 N and disturbed by a thousandth of the depth, normal and tangential,
/// without any control.
Course pressed(const LoopSetting& base, const char* tool, double modulus)
{
  LoopSetting setting = base;
  setting.push = Push;
  const ResponseModel model = table1(tool, modulus);
  ContactSettings paper;
  paper.form = ForceForm::Paper;
  const auto body = cylinderOf(model);
  const SafetySettings none = safetyOf(Control::None, setting);
  ServoRendering probe(body, none, paper);
  ServoRendering rendering(body, none, paper);
  const double depth = restingDepth(probe, Push);
  const double stiffness = stiffnessAt(probe, depth);
  VirtualLoop loop(setting,
    { { 0.0, { 1e-6, 0.0, -1.001 * depth } }, { 1e-12, { 0.0, 0.0, -depth } } }, rendering);
  return smallSwing(
    loop, setting.watchedTicks(), 0.1 * depth * std::sqrt(stiffness / setting.plant.mass));
}

double largestModulus(const LoopSetting& setting, const char* tool)
{
  double low = 0.02;
  double high = 1e3;
  for (int i = 0; i < 16; ++i)
  {
    const double middle = std::sqrt(low * high);
    (pressed(setting, tool, middle).rests ? low : high) = middle;
  }
  return low;
}
} // namespace

void cylinderSettings(bool isQuick)
{
  std::puts("tool,push_N,rate_Hz,damping_Ns_per_m,hand_N_per_m,hand_Ns_per_m,modulus_MPa,stiffness_"
            "N_per_m");
  // The hand must hold the tip sideways; otherwise the tip leaves the top.
  for (const HandModel& hand : { HandModel{ 300.0, 0.0 }, HandModel{ 300.0, 5.0 } })
  {
    for (const double rate : { 500.0, 1000.0, 2000.0, 4000.0, 8000.0 })
    {
      for (const char* tool : { "flat:1.6", "paraboloid:1.6", "paraboloid:6.35", "cone:60" })
      {
        if (isQuick && (rate != 1000.0 || hand.damping > 0.0 || tool[0] == 'c'))
        {
          continue;
        }
        LoopSetting setting;
        setting.rate = rate;
        setting.hand = hand;
        const double modulus = largestModulus(setting, tool);
        const ResponseModel model = table1(tool, modulus);
        std::printf("%s,%g,%g,%g,%g,%g,%.5g,%.5g\n", tool, Push, rate, setting.plant.damping,
          hand.stiffness, hand.damping, modulus, 1e3 * model.law(model.depthOf(Push)).stiffness);
        std::fflush(stdout);
      }
    }
  }
}
} // namespace palpate::testing
