// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/ToolSpecification.h"

#include "Mechanics/Tools/BluntedConeTool.h"
#include "Mechanics/Tools/ConeTool.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/FlatTool.h"
#include "Mechanics/Tools/ParaboloidTool.h"
#include "Mechanics/Tools/PowerLawTool.h"
#include "Mechanics/Tools/ProfileFile.h"
#include "Mechanics/Tools/RoundedFlatTool.h"
#include "Mechanics/Tools/SphereTool.h"
#include "Mechanics/Tools/TruncatedConeTool.h"

#include <array>
#include <charconv>
#include <cmath>

namespace palpate
{
namespace
{
using Parameter = double ToolSpecification::*;

/// A shape's name on the command line, its name in sentences, and its parameters in order.
struct ShapeEntry
{
  const char* name;
  const char* noun;
  std::vector<Parameter> parameters;
};

const ShapeEntry& entryOf(ToolShape shape)
{
  using S = ToolSpecification;
  static const std::array<ShapeEntry, 9> entries = { {
    { "flat", "flat", { &S::Radius } },
    { "paraboloid", "paraboloid", { &S::Radius } },
    { "sphere", "sphere", { &S::Radius } },
    { "cone", "cone", { &S::HalfAngle } },
    { "truncated", "truncated cone", { &S::Radius, &S::HalfAngle } },
    { "blunted", "blunted cone", { &S::Radius, &S::HalfAngle } },
    { "rounded", "rounded flat", { &S::Radius, &S::EdgeRadius } },
    { "power", "power law", { &S::Exponent, &S::Coefficient } },
    { "profile", "profile", {} },
  } };
  return entries[static_cast<std::size_t>(shape)];
}

bool isLength(double value)
{
  return std::isfinite(value) && value > 0.0;
}

/// Returns the fault of one parameter of a shape, or "".
std::string checkParameter(const ToolSpecification& tool, Parameter parameter)
{
  const double value = tool.*parameter;
  const std::string of = std::string(" of a ") + entryOf(tool.Shape).noun;
  const std::string but = ", but is " + shortestDecimals(value);
  if (parameter == &ToolSpecification::HalfAngle)
  {
    return value > 0.0 && value < 90.0
      ? std::string()
      : "the half angle" + of + " must lie between 0 and 90 degrees" + but;
  }
  if (parameter == &ToolSpecification::Exponent)
  {
    return value >= 1.0 && value <= PowerLawTool::LargestExponent ? std::string()
                                                                  : "the exponent" + of +
        " must lie between 1 and " + shortestDecimals(PowerLawTool::LargestExponent) + but;
  }
  if (isLength(value))
  {
    return {};
  }
  if (parameter == &ToolSpecification::Coefficient)
  {
    return "the coefficient" + of + " must be positive and finite (mm^(1-exponent))" + but;
  }
  return (parameter == &ToolSpecification::EdgeRadius ? "the edge radius" : "the radius") + of +
    " must be positive and finite (mm)" + but;
}

/// Reads the whole text as numbers separated by commas, one number for each target.
bool readNumbers(const char* begin, const char* end, const std::vector<double*>& targets)
{
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    if (i > 0 && (begin == end || *begin++ != ','))
    {
      return false;
    }
    const auto result = std::from_chars(begin, end, *targets[i]);
    if (result.ec != std::errc())
    {
      return false;
    }
    begin = result.ptr;
  }
  return begin == end;
}

/// Reads "r1,f1;r2,f2;…". Returns a fault, or "".
std::string readInlineProfile(const std::string& text, std::vector<ProfilePoint>& points)
{
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    ProfilePoint point{};
    if (!readNumbers(text.data() + begin, text.data() + end, { &point.r, &point.f }))
    {
      return "'" + text.substr(begin, end - begin) + "' is not a profile point r,f";
    }
    points.push_back(point);
    begin = end + 1;
  }
  return {};
}

/// Reads the text after the colon. Returns a fault, or "".
std::string readParameters(const std::string& text, ToolSpecification& tool)
{
  if (tool.Shape == ToolShape::Profile)
  {
    return text.find(';') == std::string::npos ? readProfile(text, tool.Profile)
                                               : readInlineProfile(text, tool.Profile);
  }
  std::vector<double*> targets;
  for (const Parameter parameter : entryOf(tool.Shape).parameters)
  {
    targets.push_back(&(tool.*parameter));
  }
  if (!readNumbers(text.data(), text.data() + text.size(), targets))
  {
    return "'" + text + "' is not " +
      (targets.size() == 1 ? "one number" : "two numbers with a comma between");
  }
  return {};
}
} // namespace

const char* toolSyntax()
{
  return "flat:R, sphere:R, paraboloid:R, cone:DEGREES, truncated:R,DEGREES, blunted:R,DEGREES, "
         "rounded:R,EDGE, power:EXPONENT,COEFFICIENT or profile:FILE.csv (radii in mm, half angles "
         "from the axis)";
}

std::string checkTool(const ToolSpecification& specification)
{
  if (specification.Shape == ToolShape::Profile)
  {
    return ProfileTool::check(specification.Profile);
  }
  for (const Parameter parameter : entryOf(specification.Shape).parameters)
  {
    std::string fault = checkParameter(specification, parameter);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return {};
}

std::unique_ptr<AxisymmetricTool> makeTool(const ToolSpecification& specification)
{
  const ToolSpecification& s = specification;
  if (!checkTool(s).empty())
  {
    return nullptr;
  }
  switch (s.Shape)
  {
    case ToolShape::Flat:
      return std::make_unique<FlatTool>(s.Radius);
    case ToolShape::Paraboloid:
      return std::make_unique<ParaboloidTool>(s.Radius);
    case ToolShape::Sphere:
      return std::make_unique<SphereTool>(s.Radius);
    case ToolShape::Cone:
      return std::make_unique<ConeTool>(s.HalfAngle);
    case ToolShape::TruncatedCone:
      return std::make_unique<TruncatedConeTool>(s.Radius, s.HalfAngle);
    case ToolShape::BluntedCone:
      return std::make_unique<BluntedConeTool>(s.Radius, s.HalfAngle);
    case ToolShape::RoundedFlat:
      return std::make_unique<RoundedFlatTool>(s.Radius, s.EdgeRadius);
    case ToolShape::PowerLaw:
      return std::make_unique<PowerLawTool>(s.Exponent, s.Coefficient);
    case ToolShape::Profile:
      return std::make_unique<ProfileTool>(s.Profile);
  }
  return nullptr;
}

bool parseTool(const std::string& text, ToolSpecification& specification, std::string& error)
{
  const std::size_t colon = text.find(':');
  error = "tool '" + text + "' is not known; give " + toolSyntax();
  for (int shape = 0; shape <= static_cast<int>(ToolShape::Profile); ++shape)
  {
    ToolSpecification read;
    read.Shape = static_cast<ToolShape>(shape);
    if (text.compare(0, colon, entryOf(read.Shape).name) != 0)
    {
      continue;
    }
    if (colon == std::string::npos)
    {
      error = "tool '" + text + "' needs a colon and its size; give " + toolSyntax();
      return false;
    }
    error = readParameters(text.substr(colon + 1), read);
    if (error.empty())
    {
      error = checkTool(read);
    }
    if (!error.empty())
    {
      // Number of characters; a profile may have thousands of points.
      constexpr std::size_t Shown = 60;
      error.insert(0, "tool '" + text.substr(0, Shown) + (text.size() > Shown ? "…" : "") + "': ");
      return false;
    }
    specification = read;
    return true;
  }
  return false;
}

std::optional<ToolSpecification> knownSpecification(const AxisymmetricTool& tool)
{
  ToolSpecification read;
  std::string error;
  return parseTool(tool.specification(), read, error) ? std::optional<ToolSpecification>(read)
                                                      : std::nullopt;
}

std::unique_ptr<AxisymmetricTool> scaledTool(const AxisymmetricTool& tool, double factor)
{
  const std::optional<ToolSpecification> own = knownSpecification(tool);
  if (!isLength(factor) || !own)
  {
    return nullptr;
  }
  ToolSpecification s = *own;
  s.Radius *= factor;
  s.EdgeRadius *= factor;
  s.Coefficient *= s.Exponent == 1.0 ? 1.0 / factor : std::pow(factor, 1.0 - s.Exponent);
  for (ProfilePoint& point : s.Profile)
  {
    point = { point.r * factor, point.f * factor };
  }
  if (s.Shape == ToolShape::Cone)
  {
    s.HalfAngle = std::atan(factor * std::tan(s.HalfAngle * Pi / 180.0)) * 180.0 / Pi;
  }
  return makeTool(s);
}

std::string formatTool(const std::string& name, std::initializer_list<double> values)
{
  std::string text = name;
  char separator = ':';
  for (const double value : values)
  {
    text += separator + shortestDecimals(value);
    separator = ',';
  }
  return text;
}

std::string formatProfile(const std::vector<ProfilePoint>& points)
{
  std::string text = "profile";
  char separator = ':';
  for (const ProfilePoint& point : points)
  {
    text += separator + shortestDecimals(point.r) + ',' + shortestDecimals(point.f);
    separator = ';';
  }
  return text;
}
} // namespace palpate
