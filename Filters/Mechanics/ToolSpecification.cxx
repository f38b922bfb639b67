// SPDX-License-Identifier: BSD-3-Clause
#include "ToolSpecification.h"

#include "ConeTool.h"
#include "FlatTool.h"
#include "ParaboloidTool.h"
#include "SphereTool.h"

#include <array>
#include <charconv>
#include <cmath>

namespace palpate
{
namespace
{
const std::array<const char*, 4> ShapeNames = { "flat", "paraboloid", "sphere", "cone" };

std::string shortest(double value)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return std::string(buffer.data(), end);
}
} // namespace

std::string checkTool(const ToolSpecification& specification)
{
  const double value = specification.Parameter;
  if (specification.Shape == ToolShape::Cone)
  {
    if (!(value > 0.0 && value < 90.0))
    {
      return "the half angle of a cone must lie between 0 and 90 degrees, but is " +
        shortest(value);
    }
  }
  else if (!(std::isfinite(value) && value > 0.0))
  {
    return "the radius of a " + std::string(ShapeNames[static_cast<size_t>(specification.Shape)]) +
      " must be positive and finite (mm), but is " + shortest(value);
  }
  return {};
}

std::unique_ptr<AxisymmetricTool> makeTool(const ToolSpecification& specification)
{
  if (!checkTool(specification).empty())
  {
    return nullptr;
  }
  switch (specification.Shape)
  {
    case ToolShape::Flat:
      return std::make_unique<FlatTool>(specification.Parameter);
    case ToolShape::Paraboloid:
      return std::make_unique<ParaboloidTool>(specification.Parameter);
    case ToolShape::Sphere:
      return std::make_unique<SphereTool>(specification.Parameter);
    case ToolShape::Cone:
      return std::make_unique<ConeTool>(specification.Parameter);
  }
  return nullptr;
}

bool parseTool(const std::string& text, ToolSpecification& specification, std::string& error)
{
  const size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  for (size_t shape = 0; shape < ShapeNames.size(); ++shape)
  {
    if (colon == std::string::npos || name != ShapeNames[shape])
    {
      continue;
    }
    ToolSpecification read;
    read.Shape = static_cast<ToolShape>(shape);
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data() + colon + 1, end, read.Parameter);
    if (result.ec != std::errc() || result.ptr != end)
    {
      error = "tool '" + text + "': '" + text.substr(colon + 1) + "' is not one number";
      return false;
    }
    error = checkTool(read);
    if (!error.empty())
    {
      error.insert(0, "tool '" + text + "': ");
      return false;
    }
    specification = read;
    return true;
  }
  error = "tool '" + text +
    "' is not known; give flat:R, sphere:R, paraboloid:R (mm) or cone:DEGREES (from the axis)";
  return false;
}

std::string formatTool(const std::string& name, std::initializer_list<double> values)
{
  std::string text = name;
  char separator = ':';
  for (const double value : values)
  {
    text += separator + shortest(value);
    separator = ',';
  }
  return text;
}
} // namespace palpate
