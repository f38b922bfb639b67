// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeasuredCurves.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr std::array<const char*, 5> Columns = { "Deflection (mm)", "Force (N)", "ModelForce (N)",
  "Site", "Tool" };
constexpr const char* TimeColumn = "Time (s)"; // present if at least one site relaxes

/// The rows of one site and one tool.
struct Curve
{
  std::string site;
  std::string tool;
  std::vector<vtkIdType> rows;
};

std::vector<Curve> collect(vtkTable* readings)
{
  std::vector<Curve> curves;
  for (vtkIdType row = 0; row < readings->GetNumberOfRows(); ++row)
  {
    const std::string site = readings->GetValueByName(row, "Site").ToString();
    const std::string tool = readings->GetValueByName(row, "Tool").ToString();
    const auto same = [&](const Curve& curve) { return curve.site == site && curve.tool == tool; };
    auto found = curves.end();
    if (!curves.empty() && same(curves.back())) // true for nearly all rows
    {
      found = curves.end() - 1;
    }
    else
    {
      found = std::find_if(curves.begin(), curves.end(), same);
    }
    if (found == curves.end())
    {
      curves.push_back({ site, tool, {} });
      found = curves.end() - 1;
    }
    found->rows.push_back(row);
  }
  return curves;
}
} // namespace

vtkStandardNewMacro(vtkMeasuredCurves);

int vtkMeasuredCurves::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

int vtkMeasuredCurves::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* readings = vtkTable::GetData(inputVector[0]);
  vtkTable* output = vtkTable::GetData(outputVector);
  if (!readings || readings->GetNumberOfRows() == 0)
  {
    return 1;
  }
  for (const char* name : Columns)
  {
    if (!readings->GetColumnByName(name))
    {
      vtkErrorMacro(<< "Wrong readings: the column '" << name
                    << "' is missing; they are the output Readings of Measured Contact Response.");
      return 0;
    }
  }
  const auto number = [readings](vtkIdType row, const char* name)
  { return readings->GetValueByName(row, name).ToDouble(); };
  const bool isTimed = readings->GetColumnByName(TimeColumn) != nullptr;
  std::vector<Curve> curves = collect(readings);
  std::set<std::string> tools;
  vtkNew<vtkDoubleArray> deflection;
  deflection->SetName(Columns[0]);
  for (Curve& curve : curves)
  {
    tools.insert(curve.tool);
    const bool isHistory = isTimed && !std::isnan(number(curve.rows.front(), TimeColumn));
    const char* by = isHistory ? TimeColumn : Columns[0];
    std::stable_sort(curve.rows.begin(), curve.rows.end(),
      [&](vtkIdType a, vtkIdType b) { return number(a, by) < number(b, by); });
    for (const vtkIdType row : curve.rows)
    {
      deflection->InsertNextValue(number(row, Columns[0]));
    }
  }
  output->AddColumn(deflection);

  vtkIdType first = 0;
  for (const Curve& curve : curves)
  {
    const std::string with = tools.size() > 1 ? " with " + curve.tool : "";
    for (const auto& [what, name] :
      { std::pair{ " measured", Columns[1] }, std::pair{ " model", Columns[2] } })
    {
      vtkNew<vtkDoubleArray> force;
      force->SetName((curve.site + what + with + " (N)").c_str());
      force->SetNumberOfValues(deflection->GetNumberOfValues());
      force->FillValue(std::numeric_limits<double>::quiet_NaN());
      for (std::size_t i = 0; i < curve.rows.size(); ++i)
      {
        force->SetValue(first + static_cast<vtkIdType>(i), number(curve.rows[i], name));
      }
      output->AddColumn(force);
    }
    first += static_cast<vtkIdType>(curve.rows.size());
  }
  return 1;
}
