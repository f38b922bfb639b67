// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredBody.h"

#include "MeasuredReadings.h"
#include "Response/BodyConversion.h"
#include "ResponseSet.h"

#include "vtkContactTool.h"
#include "vtkMeasuredContactResponse.h"
#include "vtkNew.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
/// Returns an estimate as text, such as "E* = 0.05 MPa (0.049 to 0.051)", or "" if the table has no
/// such number.
std::string estimate(vtkTable* sites, vtkIdType row, const char* symbol, const std::string& column,
  const std::string& unit)
{
  const std::string inUnit = " (" + unit + ")";
  const double value = numberAt(sites, row, column + inUnit);
  if (std::isnan(value))
  {
    return {};
  }
  std::array<char, 160> buffer{};
  std::snprintf(buffer.data(), buffer.size(), ", %s = %.4g %s (%.4g to %.4g)", symbol, value,
    unit.c_str(), numberAt(sites, row, column + " from" + inUnit),
    numberAt(sites, row, column + " to" + inUnit));
  return buffer.data();
}

std::string share(vtkTable* sites, vtkIdType row, const char* what, const char* column)
{
  const double value = numberAt(sites, row, column);
  if (std::isnan(value))
  {
    return std::string(", ") + what + " not recorded";
  }
  std::array<char, 80> buffer{};
  std::snprintf(buffer.data(), buffer.size(), ", %s %.1f %%", what, 100.0 * value);
  return buffer.data();
}

std::string describeSite(vtkTable* sites, vtkIdType row)
{
  const std::string name = "Site '" + textAt(sites, row, "Site") + "': ";
  if (textAt(sites, row, "Verdict") != "identified")
  {
    return name + "refused: " + textAt(sites, row, "Verdict") + ".";
  }
  std::array<char, 120> left{};
  std::snprintf(left.data(), left.size(), "; leaves %.2g N where the noise is %.2g N",
    numberAt(sites, row, "Misfit (N)"), numberAt(sites, row, "Noise (N)"));
  const std::string remark = textAt(sites, row, "Remark");
  return name + textAt(sites, row, "Model") + estimate(sites, row, "E*", "ReducedModulus", "MPa") +
    estimate(sites, row, "C_g", "Compliance", "mm/N") +
    estimate(sites, row, "h", "Thickness", "mm") +
    estimate(sites, row, "first contact", "ContactOffset", "mm") +
    share(sites, row, "hysteresis", "Hysteresis") +
    share(sites, row, "effect of speed", "RateEffect") + left.data() +
    (remark.empty() ? "" : "; " + remark) + ".";
}

std::string describeRegistration(vtkMeasuredContactResponse* measured)
{
  std::array<char, 160> buffer{};
  const double pairs = measured->GetRegistrationResidual();
  const int length = std::isnan(pairs)
    ? std::snprintf(buffer.data(), buffer.size(), "Registration: ")
    : std::snprintf(
        buffer.data(), buffer.size(), "Registration: pairs miss each other by %.3g mm, ", pairs);
  std::snprintf(buffer.data() + length, buffer.size() - static_cast<std::size_t>(length),
    "sites lie %.3g mm off the surface (root mean square).", measured->GetSiteResidual());
  return buffer.data();
}

/// Returns the row of the first identified site. Such a row exists, because the filter fails if no
/// site is identified.
vtkIdType firstIdentified(vtkTable* sites)
{
  vtkIdType row = 0;
  while (row + 1 < sites->GetNumberOfRows() && textAt(sites, row, "Verdict") != "identified")
  {
    ++row;
  }
  return row;
}
} // namespace

std::string attachMeasured(const ViewerOptions& options, ViewerScene& scene)
{
  vtkNew<vtkMeasuredContactResponse> measured;
  for (const std::string& file : options.measured)
  {
    measured->AddFileName(file);
  }
  measured->SetRegistrationFile(options.registration);
  measured->SetReach(options.reach);
  measured->SetMaximumStrain(options.maximumStrain);
  measured->SetPoissonRatio(scene.poissonRatio);
  measured->SetMaximumDeflection(options.maximumDeflection);
  for (std::size_t i = 0; i < scene.tools.size(); ++i)
  {
    vtkNew<vtkContactTool> tool;
    tool->SetSpecification(scene.tools[i]);
    measured->SetInputData(scene.body);
    measured->SetTool(tool);
    measured->SetResponseName(responseName(i));
    const std::string error = updateQuietly(measured);
    if (!error.empty())
    {
      return error;
    }
    scene.body = vtkSmartPointer<vtkPolyData>::New();
    scene.body->ShallowCopy(measured->GetOutput());
  }
  auto* sites = vtkTable::SafeDownCast(measured->GetOutputDataObject(1));
  for (vtkIdType row = 0; row < sites->GetNumberOfRows(); ++row)
  {
    scene.notes.push_back(describeSite(sites, row));
  }
  scene.notes.push_back(describeRegistration(measured));
  scene.readings = vtkSmartPointer<vtkTable>::New();
  scene.readings->ShallowCopy(measured->GetOutputDataObject(2));
  scene.stored = true;
  scene.materialSource = "E is not used: the body was identified at its sites";
  scene.modelReason = responseText(scene.body, "Response", ResponseArray::Model);

  const vtkIdType first = firstIdentified(sites);
  scene.readSite = textAt(sites, first, "Site");
  if (!options.site)
  {
    const Direction site = { numberAt(sites, first, "X (mm)"), numberAt(sites, first, "Y (mm)"),
      numberAt(sites, first, "Z (mm)") };
    scene.directions.front() = { site[0] - scene.center[0], site[1] - scene.center[1],
      site[2] - scene.center[2] };
    scene.directions.resize(options.slideTo ? 2 : 1);
  }
  return {};
}
} // namespace palpate
