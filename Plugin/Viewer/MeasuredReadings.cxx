// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredReadings.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkResponseChart.h"

#include <set>

namespace palpate
{
double numberAt(vtkTable* table, vtkIdType row, const std::string& column)
{
  return table->GetValueByName(row, column.c_str()).ToDouble();
}

std::string textAt(vtkTable* table, vtkIdType row, const std::string& column)
{
  return table->GetValueByName(row, column.c_str()).ToString();
}

std::string measuredLabel(const ViewerScene& scene)
{
  if (!scene.readings)
  {
    return {};
  }
  return scene.modelReason.find("synthetic") != std::string::npos ? ", from synthetic curves"
                                                                  : ", from measured curves";
}

void addReadings(const ViewerScene& scene, vtkResponseChart* chart)
{
  if (!scene.readings)
  {
    return;
  }
  const bool synthetic = scene.modelReason.find("synthetic") != std::string::npos;
  std::set<std::string> tools;
  for (vtkIdType row = 0; row < scene.readings->GetNumberOfRows(); ++row)
  {
    if (textAt(scene.readings, row, "Site") == scene.readSite)
    {
      tools.insert(textAt(scene.readings, row, "Tool"));
    }
  }
  for (const std::string& tool : tools)
  {
    vtkNew<vtkTable> curve;
    vtkNew<vtkDoubleArray> depth;
    vtkNew<vtkDoubleArray> force;
    depth->SetName("Deflection (mm)");
    force->SetName("Force (N)");
    for (vtkIdType row = 0; row < scene.readings->GetNumberOfRows(); ++row)
    {
      if (textAt(scene.readings, row, "Site") == scene.readSite &&
        textAt(scene.readings, row, "Tool") == tool &&
        numberAt(scene.readings, row, "Deflection (mm)") >= 0.0)
      {
        depth->InsertNextValue(numberAt(scene.readings, row, "Deflection (mm)"));
        force->InsertNextValue(numberAt(scene.readings, row, "MonotoneForce (N)"));
      }
    }
    curve->AddColumn(depth);
    curve->AddColumn(force);
    chart->AddCurve(curve,
      "readings of " + tool + " at site " + scene.readSite + (synthetic ? " (synthetic)" : ""));
  }
}
} // namespace palpate
