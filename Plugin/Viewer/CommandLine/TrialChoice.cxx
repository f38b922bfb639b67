// SPDX-License-Identifier: BSD-3-Clause
#include "TrialChoice.h"

#include "ContactNames.h"
#include "ToolSpecification.h"

#include <charconv>
#include <cmath>
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

/// The alternatives as written: a comma within the numbers of a tool ends none.
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

bool readNumber(const std::string& text, double& value)
{
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

bool readName(const ContactNames& names, const std::string& text, int& value)
{
  const auto name = names.find(text);
  value = name == names.end() ? value : name->second;
  return name != names.end();
}

bool readLayer(const std::string& text, TrialChoice& choice)
{
  double thickness = 0.0;
  if (text != "none" && !(readNumber(text, thickness) && thickness > 0.0))
  {
    return false;
  }
  choice.layer = LayerChoice{ false, thickness };
  return true;
}

bool readInto(std::optional<double>& number, const std::string& text)
{
  double value = 0.0;
  const bool good = readNumber(text, value);
  number = good ? std::optional<double>(value) : number;
  return good;
}

bool readSetting(const std::string& name, const std::string& value, TrialChoice& choice)
{
  GivenSettings& contact = choice.contact;
  const std::map<std::string, std::function<bool()>> readers = {
    { "young",
      [&] { return readInto(choice.youngsModulus, value) && *choice.youngsModulus > 0.0; } },
    { "poisson",
      [&]
      {
        return readInto(choice.poissonsRatio, value) && *choice.poissonsRatio >= 0.0 &&
          *choice.poissonsRatio <= 0.5;
      } },
    { "layer", [&] { return readLayer(value, choice); } },
    { "friction",
      [&] { return readNumber(value, contact.frictionCoefficient) && !contact.fault(); } },
    { "friction-model",
      [&] { return readName(FrictionModelNames, value, contact.frictionModel); } },
    { "force-form", [&] { return readName(ForceFormNames, value, contact.forceForm); } },
    { "contact-surface",
      [&] { return readName(ContactSurfaceNames, value, contact.contactSurface); } },
  };
  const auto reader = readers.find(name);
  return reader != readers.end() && reader->second();
}

std::string readChoice(const std::string& text, TrialChoice& choice)
{
  for (const std::string& part : split(text, '+'))
  {
    const std::size_t equals = part.find('=');
    if (equals != std::string::npos)
    {
      if (!readSetting(part.substr(0, equals), part.substr(equals + 1), choice))
      {
        return "'" + part + "' is no setting of an alternative";
      }
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
  return {};
}
} // namespace

std::string readTrialChoices(
  const std::string& text, const GivenSettings& usual, std::vector<TrialChoice>& choices)
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
