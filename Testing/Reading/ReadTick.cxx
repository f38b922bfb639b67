// SPDX-License-Identifier: BSD-3-Clause
// A whole tick: every surface, force form and friction model, the safety chain of a device, the
// clutch, a change of scene, lost readings, a border to slide off.
#include "Counted.h"
#include "SampleResponses.h"

#include "Haptics/Servo/ServoStep.h"

#include <cmath>
#include <cstdio>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr double Period = 1e-3; // s
constexpr double Radius = 20.0; // mm, of the ball

std::vector<ContactSettings> allSettings()
{
  std::vector<ContactSettings> all;
  for (const auto surface : { ContactSurface::Facets, ContactSurface::Smooth })
  {
    for (const auto form :
      { ForceForm::Paper, ForceForm::NormalizedDirection, ForceForm::EnergyConsistent })
    {
      for (const auto model :
        { FrictionModel::ElastoPlastic, FrictionModel::Dahl, FrictionModel::ShapeDerived })
      {
        ContactSettings settings{ form, surface, {} };
        settings.friction.model = model;
        settings.friction.coefficient = 0.4;
        all.push_back(settings);
      }
    }
  }
  return all;
}

DeviceSample sampleAt(const Vector3& tip)
{
  DeviceSample sample;
  sample.position = tip / 1000.0;
  sample.valid = true;
  return sample;
}

struct PressedStep
{
  ServoStep step;
  std::unique_ptr<ServoScene> next;
  double height; ///< of the surface, mm
  double size;   ///< of the region over which the tip slides, mm
};

/// Moves the tip from outside to 1 mm below the surface, along it, and off its border if it has
/// one.
void press(PressedStep& pressed)
{
  const double height = pressed.height;
  double time = 0.0;
  const auto tick = [&](const Vector3& tip, std::uint32_t buttons = 0, bool valid = true)
  {
    DeviceSample sample = sampleAt(tip);
    sample.buttons = buttons;
    sample.valid = valid;
    time += Period;
    return pressed.step.step(sample, time);
  };
  double largest = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    const double depth = std::min(0.01 * (i - 50), 1.0);
    const double along = std::max(0, i - 150) * 0.005 * pressed.size;
    // A reversal on the path, for friction; a change of scene within the first contact.
    const double back = i > 250 && i < 280 ? -0.5 : 0.0;
    if (i == 200)
    {
      pressed.step.change(std::move(pressed.next));
    }
    const Tick felt = tick({ along + back, 0.3, height - depth }, i > 300 && i < 320 ? 1U : 0U);
    largest = std::max(largest, felt.deviceForce.norm());
  }
  tick({ 0.0, 0.3, height - 0.5 }, 0, false);
  tick({ std::nan(""), 0.3, height });
  std::printf("%g ", largest);
}
} // namespace

int main()
{
  const Surface ball = icosphere(Radius, 3);
  ResponseStore store(ball.points.size());
  store.normalsFromPoints(ball);
  store.randomizeCurves(1);
  const std::shared_ptr<const ContactBody> round = contactBody(ball, store);
  const std::shared_ptr<const ContactBody> plate = uniformBody(openPlate(10.0, 10));
  std::vector<PressedStep> all;
  DeviceSpecification device;
  device.maximumForceRate = 2000.0;
  const WorkspaceMapping mapping;
  for (const ContactSettings& settings : allSettings())
  {
    for (const auto& body : { round, plate })
    {
      const bool isRound = body == round;
      all.push_back({ ServoStep(std::make_unique<ServoScene>(body, settings), mapping,
                        SafetySettings::of(device), 1U),
        std::make_unique<ServoScene>(body), isRound ? Radius : 0.0,
        isRound ? 0.5 * Radius : 10.0 });
    }
  }
  reading::counted(
    [&]
    {
      for (PressedStep& pressed : all)
      {
        press(pressed);
      }
    });
  std::printf("N\n");
  return 0;
}
