// SPDX-License-Identifier: BSD-3-Clause
#include "TrialChoice.h"

#include "ContactNames.h"
#include "OptionChecks.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <functional>
#include <map>
#include <sstream>

namespace palpate
{
namespace
{
std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

/// Splits the text into alternatives. A comma between the numbers of a tool is not a separator.
std::vector<std::string> splitChoices(const std::string& text)
{
  std::vector<std::string> choices;
  for (const std::string& part : split(text, ','))
  {
    const bool isNumber = !part.empty() && part.find_first_of("0123456789.+-") == 0;
    if (isNumber && !choices.empty())
    {
      choices.back() += "," + part;
    }
    else
    {
      choices.push_back(part);
    }
  }
  return choices;
}

std::string readContact(
  const SettingRow& setting, const std::string& text, ContactSettings& contact)
{
  if (!setting.isEnumeration())
  {
    double value = setting.get(contact);
    const std::string fault = rangeOf(setting).read(text, value);
    setting.set(contact, value);
    return fault;
  }
  std::string known;
  const std::string wanted = presentName(setting, text);
  for (const auto& [name, value] : namesOf(setting))
  {
    if (name == wanted)
    {
      setting.set(contact, value);
      return {};
    }
    known += (known.empty() ? "" : ", ") + name;
  }
  return "'" + text + "' is none of " + known;
}

std::string readLayer(const std::string& text, TrialChoice& choice)
{
  double thickness = 0.0;
  const std::string fault = text == "none" ? "" : LayerRange.read(text, thickness);
  choice.layer.emplace();
  choice.layer->thickness = thickness;
  return fault;
}

std::string readInto(
  std::optional<double>& number, const NumberRange& range, const std::string& text)
{
  double value = 0.0;
  const std::string fault = range.read(text, value);
  number = value;
  return fault;
}

/// Reads one setting into `choice`. Returns "" or an error.
std::string readSetting(const std::string& name, const std::string& value, TrialChoice& choice)
{
  std::map<std::string, std::function<std::string()>> readers = {
    { "young", [&] { return readInto(choice.youngsModulus, YoungsModulusRange, value); } },
    { "poisson", [&] { return readInto(choice.poissonRatio, PoissonsRatioRange, value); } },
    { "layer", [&] { return readLayer(value, choice); } },
    { "layers",
      [&]
      {
        const std::string fault = readLayers(value, choice.layer.emplace());
        return choice.layer->scanned ? "scan can only be given by --layers, for all alternatives"
                                     : fault;
      } },
  };
  for (const SettingRow& setting : SettingTable)
  {
    if (setting.text.option)
    {
      readers[setting.text.option] = [&] { return readContact(setting, value, choice.contact); };
    }
  }
  const auto reader = readers.find(name);
  if (reader != readers.end())
  {
    return reader->second();
  }
  std::string known;
  for (const auto& entry : readers)
  {
    known += (known.empty() ? "" : ", ") + entry.first;
  }
  return "there is no such setting, but there are " + known;
}

std::string readChoice(const std::string& text, TrialChoice& choice)
{
  for (const std::string& part : split(text, '+'))
  {
    const std::size_t equals = part.find('=');
    if (equals != std::string::npos)
    {
      const std::string fault =
        readSetting(part.substr(0, equals), part.substr(equals + 1), choice);
      if (!fault.empty())
      {
        return part.substr(0, 40) + ": " + fault;
      }
      continue;
    }
    if (part == "lump" || part == "none")
    {
      if (choice.hasLump)
      {
        return "'" + text.substr(0, 40) + "' states twice whether there is a lump";
      }
      choice.hasLump = part == "lump";
      continue;
    }
    ToolSpecification tool;
    std::string error;
    if (!choice.tool.empty() || !parseTool(part, tool, error))
    {
      return choice.tool.empty() ? error : "'" + text + "' has two tools";
    }
    choice.tool = part;
  }
  return choice.layer && choice.layer->isStack() && (choice.youngsModulus || choice.poissonRatio)
    ? "'" + text.substr(0, 40) + "': each of the layers has its own young and poisson"
    : std::string();
}
} // namespace

std::string readTrialChoices(
  const std::string& text, const ContactSettings& usual, std::vector<TrialChoice>& choices)
{
  std::vector<TrialChoice> read;
  for (const std::string& part : splitChoices(text))
  {
    for (const TrialChoice& other : read)
    {
      if (other.name == part)
      {
        return "'" + part + "' is given twice";
      }
    }
    read.emplace_back();
    read.back().name = part;
    read.back().contact = usual;
    const std::string error = readChoice(part, read.back());
    if (!error.empty())
    {
      return error;
    }
  }
  if (read.size() < 2 || read.size() > 26)
  {
    return "a comparison needs 2 to 26 alternatives, as in sphere:6.35,flat:1.6";
  }
  choices = std::move(read);
  return {};
}
} // namespace palpate
