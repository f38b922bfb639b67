// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Simulation/SimulatedPlant.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace palpate
{
namespace
{
constexpr double Most = 1e9; // larger than for any device; the square does not overflow
constexpr double Endless = std::numeric_limits<double>::infinity();

struct Setting
{
  const char* name;
  const char* unit;
  double least;
  double most;
  double* value;
};

std::array<Setting, 13> settingsOf(HeldPlant& held)
{
  SimulatedPlant& plant = held.plant;
  HandModel& hand = held.hand;
  return { { { "mass", "kg", 1e-6, Most, &plant.mass },
    { "damping", "N s/m", 0.0, Most, &plant.damping },
    { "friction", "N", 0.0, Most, &plant.friction },
    { "encoder-step", "m", 0.0, Most, &plant.encoderStep },
    { "force-delay", "s", 0.0, 1.0, &plant.forceDelay },
    { "sample-delay", "s", 0.0, 1.0, &plant.sampleDelay },
    { "stiffness", "N/m", 0.0, Most, &hand.stiffness },
    { "hand-damping", "N s/m", 0.0, Most, &hand.damping },
    { "hand-force", "N", 0.0, Endless, &hand.maximumForce },
    { "inertia", "kg m²", 0.0, Most, &plant.inertia },
    { "turn-damping", "N m s/rad", 0.0, Most, &plant.turnDamping },
    { "turn-stiffness", "N m/rad", 0.0, Most, &hand.turnStiffness },
    { "turn-hand-damping", "N m s/rad", 0.0, Most, &hand.turnHandDamping } } };
}
} // namespace

std::string fault(HeldPlant held)
{
  for (const Setting& setting : settingsOf(held))
  {
    // NaN is also out of range.
    if (!(*setting.value >= setting.least && *setting.value <= setting.most))
    {
      std::ostringstream text;
      text << setting.name << " must be from " << setting.least << " to " << setting.most << " "
           << setting.unit << ", not " << *setting.value;
      return text.str();
    }
  }
  return {};
}

std::string readPlant(std::string_view text, HeldPlant& held)
{
  HeldPlant read;
  auto settings = settingsOf(read);
  std::string given = ",";
  for (bool isEnd = text.empty(); !isEnd;)
  {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view part = text.substr(0, comma);
    const std::size_t sign = std::min(part.find('='), part.size());
    const std::string name(part.substr(0, sign));
    const auto setting = std::find_if(
      settings.begin(), settings.end(), [&name](const Setting& one) { return name == one.name; });
    if (setting == settings.end())
    {
      std::string known;
      for (const Setting& one : settings)
      {
        known += joined(known.empty() ? "" : ", ", one.name, " (", one.unit, ")");
      }
      return joined("'", name, "' is no setting of a plant; it has ", known);
    }
    if (given.find("," + name + ",") != std::string::npos)
    {
      return name + " is given twice";
    }
    given += name + ",";
    const std::string_view number = part.substr(std::min(sign + 1, part.size()));
    if (!readNumber(number, *setting->value))
    {
      return name + ": '" + std::string(number) + "' is not a finite number";
    }
    isEnd = comma == text.size();
    text.remove_prefix(isEnd ? comma : comma + 1);
  }
  std::string wrong = fault(read);
  if (wrong.empty())
  {
    held = read;
  }
  return wrong;
}

DeviceSpecification specificationOf(const SimulatedPlant& plant, double rate)
{
  DeviceSpecification device;
  device.rate = rate;
  const double lag = 1.0 / rate + 2.0 * (plant.forceDelay + plant.sampleDelay);
  device.maximumStiffness = plant.damping / lag;
  if (plant.inertia > 0.0)
  {
    device.outputsTorque = true;
    device.maximumTorque = 0.5;
    device.maximumTorsionalStiffness = plant.turnDamping / lag;
  }
  device.maximumDamping = plant.damping;
  device.delay = plant.forceDelay + plant.sampleDelay;
  return device;
}
} // namespace palpate
