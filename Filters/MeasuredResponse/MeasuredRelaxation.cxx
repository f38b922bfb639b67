// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredResponse/MeasuredRelaxation.h"

#include "Contact/ResponseContract.h"
#include "Mechanics/Files/NumberText.h"
#include "Identification/CommonRelaxation.h"
#include "Response/BodyConversion.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace palpate
{
void attachMeasuredRelaxation(
  const SiteMeasurement& measurement, const std::string& name, vtkPolyData* output)
{
  const CommonRelaxation common = commonRelaxation(measurement.Used);
  if (common.mean.count == 0)
  {
    return;
  }
  describeRelaxation(output, name, common.mean);
  if (measurement.Used.size() == 1)
  {
    return;
  }
  // The strength of each branch at each site.
  std::vector<std::vector<double>> strengths(common.mean.count);
  for (std::size_t k = 0; k < strengths.size(); ++k)
  {
    for (const auto& site : common.strength)
    {
      strengths[k].push_back(site[k]);
    }
  }
  vtkNew<vtkFloatArray> local;
  local->SetName(arrayName(name, ResponseArray::LocalRelaxation).c_str());
  local->SetNumberOfComponents(static_cast<int>(strengths.size()));
  local->SetNumberOfTuples(output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    const bool isReached = measurement.Spread->reaches(point);
    for (std::size_t k = 0; k < strengths.size(); ++k)
    {
      local->SetTypedComponent(i, static_cast<int>(k),
        isReached ? static_cast<float>(measurement.Spread->at(point, strengths[k])) : 0.0F);
    }
  }
  output->GetPointData()->AddArray(local);
}

std::string siteRelaxationInWords(const SiteMeasurement& measurement)
{
  const CommonRelaxation common = commonRelaxation(measurement.Used);
  if (common.mean.count == 0)
  {
    return {};
  }
  std::string text = ", relaxing";
  for (std::size_t k = 0; k < common.mean.count; ++k)
  {
    text += (k > 0 ? ", " : " ") + shortly(common.mean.strength[k]) + " in " +
      shortly(common.mean.time[k]) + " s";
  }
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;
  for (const IdentifiedBody* site : measurement.Used)
  {
    if (site->relaxation.relaxes() && site->shortestTime <= site->longestTime)
    {
      shortest = std::min(shortest, site->shortestTime);
      longest = std::max(longest, site->longestTime);
    }
  }
  if (longest > 0.0)
  {
    text += " (determined from " + shortly(shortest) + " to " + shortly(longest) + " s)";
  }
  if (common.worst > 0.01)
  {
    text += " (sites differ in their times: within " + shortly(100.0 * common.worst) + " %)";
  }
  return text;
}
} // namespace palpate
