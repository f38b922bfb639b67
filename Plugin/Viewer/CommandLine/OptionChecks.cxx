// SPDX-License-Identifier: BSD-3-Clause
#include "OptionChecks.h"

#include "ContactNames.h"
#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cstddef>
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

std::string readSolid(const std::string& text, double& spacing)
{
  spacing = 0.0;
  return text.empty() ? std::string()
                      : NumberRange::positive("the size of a tetrahedron in mm, e.g. 2", Kilometre)
                          .read(text, spacing);
}

std::string readLayer(const std::string& text, LayerChoice& layer)
{
  layer = {};
  layer.scanned = text == "scan";
  return layer.scanned || text == "none" ? std::string() : LayerRange.read(text, layer.thickness);
}

namespace
{
/// Skin over fat. The thickness of the fat is the scanned thickness minus that of the skin.
/// HeadScene.cxx documents the sources of the values.
LayerChoice skinOverFat()
{
  LayerChoice choice;
  choice.scanned = true;
  choice.scannedLayer = 1;
  choice.usual = true;
  choice.stack.layers = { { 1.5, 0.035, 0.48 }, { 1.0, 0.002, 0.49 } };
  return choice;
}

/// Reads a layer from "MM:MPA:NU" or "MM:MPA:NU:slip".
std::string readStackLayer(const std::string& text, StackLayer& layer, bool& scanned)
{
  std::vector<std::string> parts = CLI::detail::split(text, ':');
  layer.slips = parts.size() == 4 && parts.back() == "slip";
  if (parts.size() != 3 && !layer.slips)
  {
    return "'" + text.substr(0, 40) + "' is not MM:MPA:NU or MM:MPA:NU:slip, e.g. 1.5:0.2:0.48";
  }
  scanned = parts[0] == "scan";
  return firstFault([&]
    { return scanned ? std::string() : StackRange.read(parts[0], layer.thickness); },
    [&] { return YoungsModulusRange.read(parts[1], layer.youngsModulus); },
    [&] { return PoissonsRatioRange.read(parts[2], layer.poissonRatio); });
}

/// Checks whether the layers can be combined. Returns "" or an error.
std::string checkLayers(const LayerChoice& choice, std::size_t scanned)
{
  const LayerStack& stack = choice.stack;
  if (stack.layers.empty())
  {
    return "a half-space alone is not a stack: give --young and --poisson";
  }
  if (stack.layers.size() > LayerStack::MostLayers)
  {
    return joined(stack.layers.size(), " layers are too many: at most ", LayerStack::MostLayers,
      ", and a half-space below them");
  }
  if (stack.layers.front().slips)
  {
    return "layer 1: there is no layer above it on which it could slip";
  }
  if (scanned > 0 && (scanned > 1 || stack.layers.size() != 2 || stack.hasHalfSpace))
  {
    return "scan stands for the thickness of one of two layers on the rigid base";
  }
  return {};
}
} // namespace

std::string readLayers(const std::string& text, LayerChoice& layer)
{
  if (text == "scan")
  {
    layer = skinOverFat();
    return {};
  }
  LayerChoice read;
  std::vector<std::string> parts = CLI::detail::split(text, ',');
  const bool hasSlipBase = !parts.empty() && parts.back() == "slip";
  parts.resize(parts.size() - (hasSlipBase ? 1 : 0));
  std::size_t scanned = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    StackLayer one;
    bool isScanned = false;
    const std::string fault = readStackLayer(parts[i], one, isScanned);
    if (!fault.empty())
    {
      return joined("layer ", i + 1, ": ", fault);
    }
    if (isScanned)
    {
      ++scanned;
      read.scannedLayer = i;
    }
    if (one.thickness > 0.0)
    {
      read.stack.layers.push_back(one);
    }
    else if (i + 1 < parts.size())
    {
      return joined("layer ", i + 1, ": only the last can be 0 mm thick, a half-space");
    }
    else
    {
      read.stack.hasHalfSpace = true;
      read.stack.halfSpace = one;
    }
  }
  read.scanned = scanned > 0;
  read.stack.base = hasSlipBase ? LayerBase::Slip : LayerBase::Bonded;
  if (hasSlipBase && read.stack.hasHalfSpace)
  {
    return "slip at the end belongs to a rigid base; for a half-space write 0:MPA:NU:slip";
  }
  std::string fault = checkLayers(read, scanned);
  if (fault.empty())
  {
    layer = read;
  }
  return fault;
}

std::string readStrain(const std::string& text, LawTerms& terms)
{
  terms.automatic = text == "auto";
  terms.strain = {};
  if (terms.automatic)
  {
    return {};
  }
  StrainLaw& law = terms.strain;
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::map<std::string, StrainModel> models = { { "small", StrainModel::Linear },
    { "neo-hooke", StrainModel::NeoHooke }, { "neohooke", StrainModel::NeoHooke },
    { "ogden", StrainModel::Ogden }, { "demiray", StrainModel::Demiray } };
  const auto found = models.find(name);
  if (found == models.end())
  {
    return "'" + text.substr(0, 40) + "' is not small, auto, neo-hooke, ogden:ALPHA or demiray:B";
  }
  law = { found->second, 0.0 };
  const bool needsExponent = law.model == StrainModel::Ogden || law.model == StrainModel::Demiray;
  if (needsExponent != (colon != std::string::npos))
  {
    return needsExponent ? "'" + name + "' needs its exponent, e.g. " + name + ":2"
                         : "'" + name + "' has no exponent";
  }
  return firstFault(
    [&]
    {
      return needsExponent
        ? NumberRange::any("an exponent, e.g. 2").read(text.substr(colon + 1), law.parameter)
        : std::string();
    },
    [&] { return checkStrainEnergy(law.model, law.parameter); });
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
    const std::string side = face.substr(0, face.find(':'));
    double depth = 1.0;
    if (side.size() < face.size() &&
      (!CLI::detail::lexical_cast(face.substr(side.size() + 1), depth) || !(depth > 0.0)))
    {
      return "'" + face + "': the depth of a side must be a positive number of mm, as in z-:5";
    }
    if (std::find(known.begin(), known.end(), side) == known.end())
    {
      return "'" + side + "' is not one of x-, x+, y-, y+, z-, z+";
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
