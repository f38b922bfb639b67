// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/TiltRequest.h"

#include "Laws/BodyMaterial.h"
#include "Laws/MaterialTilts.h"
#include "Laws/TiltValidity.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltNodes.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/TiltConversion.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
double radians(const TiltRequest& request)
{
  return request.degrees * Pi / 180.0;
}

MaterialTilts tiltsIn(const TiltRequest& request, const BodyMaterial* material, std::size_t points)
{
  if (material)
  {
    return tiltsOf(
      request.tool, request.range, radians(request), material->range(), material->spots(), points);
  }
  MadeTilt made = makeTiltTable(request.tool, request.range, radians(request), { TiltBody{} });
  MaterialTilts tilts;
  tilts.table = std::move(made.table);
  tilts.fault = std::move(made.fault);
  return tilts;
}

/// Includes the error of the tilts in validity and error. The arrays belong to the response that
/// was just made.
std::string limitValidity(const TiltRequest& request, const BodyMaterial& material,
  double tolerance, const std::string& name, vtkPolyData* output)
{
  ResponseArrays arrays;
  std::string fault;
  if (!viewResponse(output, name, arrays, fault))
  {
    return fault;
  }
  vtkPointData* data = output->GetPointData();
  const auto floats = [&](ResponseArray which) -> float*
  {
    auto* array = vtkFloatArray::SafeDownCast(data->GetArray(arrayName(name, which).c_str()));
    return array ? array->GetPointer(0) : nullptr;
  };
  auto* limits = vtkUnsignedCharArray::SafeDownCast(
    data->GetArray(arrayName(name, ResponseArray::Limit).c_str()));
  limitByTilts(request.tool, material.spots(), arrays, tolerance,
    { floats(ResponseArray::Validity), limits->GetPointer(0), floats(ResponseArray::Error) });
  return {};
}
} // namespace

std::string checkTilts(const TiltRequest& request)
{
  if (!(request.degrees >= 0.0 && std::isfinite(request.degrees)))
  {
    return joined(
      "Maximum Tilt must be finite and not negative (degrees), but is ", request.degrees);
  }
  const std::string fault =
    request.degrees > 0.0 ? checkTilt(request.tool, radians(request)) : std::string();
  return fault.empty() ? fault : "Maximum Tilt: " + fault;
}

std::string attachTilts(const TiltRequest& request, const BodyMaterial* material, double tolerance,
  const std::string& name, vtkPolyData* output)
{
  removeArrays(output, name, ContractArray::Use::Tilt);
  if (!(request.degrees > 0.0))
  {
    return {};
  }
  const MaterialTilts tilts =
    tiltsIn(request, material, static_cast<std::size_t>(output->GetNumberOfPoints()));
  if (!tilts.fault.empty())
  {
    return "Maximum Tilt: " + tilts.fault;
  }
  describeTilts(output, name, tilts.table, tilts.weights);
  return material && tolerance > 0.0 ? limitValidity(request, *material, tolerance, name, output)
                                     : std::string();
}
} // namespace palpate
