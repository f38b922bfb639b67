// SPDX-License-Identifier: BSD-3-Clause
#include "OptionChecks.h"

#include "ContactNames.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <map>
#include <vector>

namespace palpate
{
CLI::Validator within(const NumberRange& range, const char* kind)
{
  return CLI::Validator(
    [range](const std::string& text)
    {
      double ignored = 0.0;
      return range.read(text, ignored);
    },
    kind);
}

CLI::Validator any(const char* what)
{
  return within(NumberRange::any(what), "");
}

CLI::Validator positive(const char* what, double most)
{
  return within(NumberRange::positive(what, most), "POSITIVE");
}

CLI::Validator notNegative(const char* what)
{
  return within(NumberRange::notNegative(what), "NONNEGATIVE");
}

std::string readLayer(const std::string& text, LayerChoice& layer)
{
  layer = { text == "scan", 0.0 };
  return layer.scanned || text == "none" ? std::string() : LayerRange.read(text, layer.thickness);
}

std::string readStrain(const std::string& text, StrainLaw& law)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::map<std::string, StrainModel> models = { { "small", StrainModel::Linear },
    { "neo-hooke", StrainModel::NeoHooke }, { "ogden", StrainModel::Ogden },
    { "demiray", StrainModel::Demiray } };
  const auto found = models.find(name);
  if (found == models.end())
  {
    return "'" + text.substr(0, 40) + "' is not small, neo-hooke, ogden:ALPHA or demiray:B";
  }
  law = { found->second, 0.0 };
  const bool needsExponent = law.model == StrainModel::Ogden || law.model == StrainModel::Demiray;
  if (needsExponent != (colon != std::string::npos))
  {
    return needsExponent ? "'" + name + "' needs its exponent, e.g. " + name + ":2"
                         : "'" + name + "' has no exponent";
  }
  const std::string fault = needsExponent
    ? NumberRange::any("an exponent, e.g. 2").read(text.substr(colon + 1), law.parameter)
    : std::string();
  return fault.empty() ? checkStrainEnergy(law.model, law.parameter) : fault;
}

std::string readLengthUnit(std::string& text)
{
  const std::map<std::string, std::string> units = { { "mm", "1" }, { "cm", "10" },
    { "m", "1000" } };
  const auto unit = units.find(text);
  if (unit == units.end())
  {
    return "'" + text.substr(0, 40) + "' is not mm, cm or m";
  }
  text = unit->second;
  return {};
}

std::string checkFaces(const std::string& text)
{
  const std::vector<std::string> known = { "x-", "x+", "y-", "y+", "z-", "z+" };
  for (const std::string& face : CLI::detail::split(text, ','))
  {
    if (std::find(known.begin(), known.end(), face) == known.end())
    {
      return "'" + face + "' is not one of x-, x+, y-, y+, z-, z+";
    }
  }
  return {};
}

std::string checkToolText(const std::string& text)
{
  ToolSpecification tool;
  std::string error;
  return parseTool(text, tool, error) ? std::string() : error;
}
} // namespace palpate
