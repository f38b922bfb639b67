// SPDX-License-Identifier: BSD-3-Clause
#include "SessionOptions.h"

#include "ContactNames.h"
#include "OptionChecks.h"

#include <CLI/CLI.hpp>

namespace palpate
{
namespace
{
constexpr int MostFurtherHands = 3;
} // namespace

void addContactOptions(CLI::App& app, ContactSettings& contact)
{
  for (const SettingRow& setting : SettingTable)
  {
    if (!setting.text.option)
    {
      continue;
    }
    const std::string option = std::string("--") + setting.text.option;
    const std::string help = setting.text.help;
    if (setting.isEnumeration())
    {
      const ContactNames names = namesOf(setting);
      const auto usual = static_cast<std::size_t>(setting.usual());
      app
        .add_option_function<std::string>(
          option,
          [&contact, &setting, names](const std::string& name)
          { setting.set(contact, names.at(name)); },
          help)
        ->transform(CLI::Validator(
          [&setting](std::string& name)
          {
            name = presentName(setting, name);
            return std::string();
          },
          ""))
        ->check(CLI::IsMember(names))
        ->default_str(setting.words[usual].option);
    }
    else
    {
      app
        .add_option_function<double>(
          option, [&contact, &setting](const double& value) { setting.set(contact, value); }, help)
        ->check(within(rangeOf(setting), setting.range.includesLeast ? "NONNEGATIVE" : "POSITIVE"))
        ->default_str(CLI::detail::to_string(setting.usual()));
    }
  }
}

void addDeviceOptions(CLI::App& app, ViewerOptions& options)
{
  app
    .add_option("--device", options.device,
      "the device: simulated (it follows a path, or with --window the mouse), "
      "plant:mass=0.1,damping=1,stiffness=300 (a simulated device that the force moves: kg, N s/m, "
      "N/m of the hand), replay:FILE (a trajectory), hid:PATH, bridge:ADDRESS (unix:/PATH or "
      "udp:PORT)")
    ->capture_default_str();
  app
    .add_option("--hand", options.hands,
      "with --window: a further device on the same body, up to three, as in --device; the devices "
      "interact through the body. simulated: moved by the mouse; key n selects the next hand")
    ->expected(1, MostFurtherHands)
    ->needs("--window");
  app
    .add_option("--scale", options.scale,
      "mm of the body per mm of the hand; the hand feels the stiffness times this factor")
    ->check(positive("a factor, e.g. 1"))
    ->capture_default_str();
  app.add_flag("--list-devices", options.listDevices, "list the connected devices, and exit");
  app.add_option(
    "--record", options.record, "also write every tick to a trajectory .csv, for replay:FILE");
}
} // namespace palpate
