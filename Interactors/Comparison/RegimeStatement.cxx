// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/RegimeStatement.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/BodyConversion.h"
#include "Laws/BodyMaterial.h"
#include "Comparison/PointCopy.h"
#include "Laws/RegimeLaw.h"
#include "Contact/ResponseField.h"
#include "vtkContactTool.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace palpate
{
namespace
{
constexpr int Depths = 160; // number of depths between 0 and the range, denser near 0
constexpr auto PointForceSuffices = static_cast<int>(RegimeVerdict::PointForceSuffices);

/// The depths at which a point is evaluated, and for each depth the most cautious verdict of the
/// tools evaluated so far.
struct DepthVerdicts
{
  std::vector<double> depths; ///< depths in ascending order, mm
  std::vector<int> verdicts;
  std::size_t asked = 0; ///< index of the requested depth
};

DepthVerdicts makeDepths(double range, double asked)
{
  DepthVerdicts all;
  all.depths = { asked };
  for (int i = 1; i <= Depths; ++i)
  {
    const double share = static_cast<double>(i) / Depths;
    all.depths.push_back(range * share * share);
  }
  std::sort(all.depths.begin(), all.depths.end());
  const auto place = std::find(all.depths.begin(), all.depths.end(), asked);
  all.asked = static_cast<std::size_t>(place - all.depths.begin());
  all.verdicts.assign(all.depths.size(), PointForceSuffices);
  return all;
}

/// Reads the material at the body's only point. Returns the fault, or "" if there is none.
std::string readPoint(vtkPolyData* one, BodyMaterial& material)
{
  BodyMaterial::Values values;
  values.thickness.name = "LayerThickness";
  values.compliance.name = "GlobalCompliance";
  for (PointValues* given : { &values.thickness, &values.compliance })
  {
    if (!one->GetPointData()->HasArray(given->name.c_str()))
    {
      continue;
    }
    vtkDataArray* array = one->GetPointData()->GetArray(given->name.c_str());
    if (!array || array->GetNumberOfComponents() != 1)
    {
      return "Array '" + given->name + "' must have 1 number per point";
    }
    given->values = { array->GetComponent(0, 0) };
  }
  const std::string wrong = material.checkConstants();
  return wrong.empty() ? material.take(std::move(values), 1) : wrong;
}

std::string judgeTool(
  vtkContactTool* tool, const BodyMaterial& material, DepthVerdicts& all, ToolRegime& judged)
{
  const AxisymmetricTool* kernel = tool ? tool->GetKernel() : nullptr;
  if (!kernel)
  {
    return "The Tool is invalid";
  }
  const double deepest = all.depths.back();
  const std::string tooDeep = kernel->checkDepth(deepest);
  if (!tooDeep.empty())
  {
    return tooDeep;
  }
  const RegimeLaw law(*kernel, material.range(), deepest);
  if (!law.complete())
  {
    return "Tool '" + kernel->specification() + "' cannot be scaled";
  }
  const ContactSpot spot = material.spots().at(0);
  for (std::size_t i = 0; i < all.depths.size(); ++i)
  {
    const double depth = all.depths[i];
    const SpotRegime found = law.regime(spot, depth, law.force(spot, depth));
    all.verdicts[i] = std::min(all.verdicts[i], static_cast<int>(found.verdict));
    if (i == all.asked)
    {
      judged.index = found.index;
      judged.sensitivity = found.sensitivity;
      judged.verdict = static_cast<int>(found.verdict);
    }
  }
  return {};
}

double spreadOf(const std::vector<ToolRegime>& tools)
{
  double least = tools.front().force;
  double largest = least;
  double sum = 0.0;
  for (const ToolRegime& tool : tools)
  {
    least = std::min(least, tool.force);
    largest = std::max(largest, tool.force);
    sum += tool.force;
  }
  return (largest - least) * static_cast<double>(tools.size()) / sum;
}

/// Computes the results that are common to all tools.
void summarize(const DepthVerdicts& all, RegimeStatement& statement)
{
  const auto sameAs = [&](std::size_t i) { return all.verdicts[i] == all.verdicts[all.asked]; };
  std::size_t first = all.asked;
  std::size_t last = all.asked;
  while (first > 0 && sameAs(first - 1))
  {
    --first;
  }
  while (last + 1 < all.depths.size() && sameAs(last + 1))
  {
    ++last;
  }
  statement.verdict = all.verdicts[all.asked];
  statement.from = first > 0 ? all.depths[first] : 0.0;
  statement.to = all.depths[last];
  statement.spread = spreadOf(statement.tools);
  statement.validity = statement.tools.front().validity;
  for (const ToolRegime& tool : statement.tools)
  {
    statement.validity = std::min(statement.validity, tool.validity);
  }
}

/// Returns the range of a value over all tools as text, such as "0.97" or "0.97 to 1.00".
template <class Value>
std::string rangeInWords(const std::vector<ToolRegime>& tools, const Value& value)
{
  double least = value(tools.front());
  double largest = least;
  for (const ToolRegime& tool : tools)
  {
    least = std::min(least, value(tool));
    largest = std::max(largest, value(tool));
  }
  std::array<char, 32> low{};
  std::array<char, 32> high{};
  std::snprintf(low.data(), low.size(), "%.2f", least);
  std::snprintf(high.data(), high.size(), "%.2f", largest);
  const std::string from = low.data();
  const std::string to = high.data();
  return from == to ? from : from + " to " + to;
}
} // namespace

std::string judgePoint(vtkPolyData* body, vtkIdType point, const std::vector<ComparedTool>& tools,
  const ComparedMaterial& material, double deflection, RegimeStatement& statement)
{
  statement = {};
  if (!(deflection > 0.0 && std::isfinite(deflection)))
  {
    return "The deflection must be positive and finite (mm), but is " + std::to_string(deflection);
  }
  BodyMaterial made(
    { material.youngsModulus, material.poissonRatio, 0.0, LayerBase::Bonded, false });
  const vtkSmartPointer<vtkPolyData> one = copyPoint(body, point);
  const std::string wrong = readPoint(one, made);
  if (!wrong.empty())
  {
    return wrong;
  }
  DepthVerdicts all;
  for (const ComparedTool& compared : tools)
  {
    ResponseArrays arrays;
    const float* validity = nullptr;
    const unsigned char* limit = nullptr;
    std::string error;
    if (!viewResponse(one, compared.responseName, arrays, error) ||
      !viewValidity(one, compared.responseName, validity, limit, error))
    {
      return error;
    }
    const ResponseField response(arrays);
    if (!response.isValid(0))
    {
      return "point " + std::to_string(point) + " has no response '" + compared.responseName + "'";
    }
    if (all.depths.empty())
    {
      statement.deflection = std::min(deflection, response.range(0));
      all = makeDepths(response.range(0), statement.deflection);
    }
    ToolRegime judged;
    judged.force = response.evaluate(0, statement.deflection).force;
    judged.validity = validity[0];
    error = judgeTool(compared.tool, made, all, judged);
    if (!error.empty())
    {
      return error;
    }
    statement.tools.push_back(judged);
  }
  if (!statement.tools.empty())
  {
    summarize(all, statement);
  }
  return {};
}

std::string verdictInWords(const RegimeStatement& statement)
{
  switch (statement.verdict)
  {
    case 2:
      return "A point force suffices: the shape of the tool hardly matters.";
    case 1:
      return "Mixed: the shape of the tool matters a little.";
    default:
      return "The shape of the tool matters.";
  }
}

std::string numbersInWords(const RegimeStatement& statement)
{
  if (statement.tools.empty())
  {
    return {};
  }
  const std::string index =
    rangeInWords(statement.tools, [](const ToolRegime& tool) { return tool.index; });
  const std::string sensitivity =
    rangeInWords(statement.tools, [](const ToolRegime& tool) { return tool.sensitivity; });
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
    "At %.2f mm: lambda %s, size sensitivity %s, forces %.0f %% apart.\n"
    "The same from %.2f to %.2f mm; the laws of all tools are valid to %.2f mm.",
    statement.deflection, index.c_str(), sensitivity.c_str(), 100.0 * statement.spread,
    statement.from, statement.to, statement.validity);
  return text.data();
}
} // namespace palpate
