// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelCompliance.h"

#include "Response/BodyField.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "Response/BodyConversion.h"
#include "SolidResponse/Bodies/FacingPoints.h"
#include "Solids/FiniteElements/MemoryForecast.h"
#include "ResponseSet.h"

#include "vtkDoubleArray.h"
#include "vtkElasticCompliance.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVoxelBody.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr int BodyModes = 6; ///< number of modes of the body's global motion

/// Returns an error if the finite elements of the body would certainly need more than the available
/// memory. Must be called before the body is filled.
std::string checkMemory(vtkPolyData* body, double spacing)
{
  const BodyMesh mesh = makeBodyMesh(body);
  double area = 0.0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    const TriangleCorners& corners = mesh.corners(t);
    if (mesh.isUsable(t))
    {
      const Vector3 from = mesh.point(corners[0]);
      const Vector3 side = mesh.point(corners[1]) - from;
      area += 0.5 * side.cross(mesh.point(corners[2]) - from).norm();
    }
  }
  const double side = std::max(spacing, 1e-9); // the lower bound keeps all numbers finite
  const double voxels = mesh.enclosedVolume() / std::pow(side, 3);
  const MemoryForecast forecast = forecastMemory(voxels, area / std::pow(side, 2));
  const double available = availableMemory();
  if (!forecast.exceeds(available))
  {
    return {};
  }
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
    "--voxel %g makes about %.3g hexahedra, which need about %.3g MiB to be solved, but %.3g MiB "
    "of "
    "memory are available.",
    spacing, voxels, (forecast.matrix + forecast.factor) / Mebibyte, available / Mebibyte);
  return text.data();
}

/// Interpolates the modes from all points of the solid, because modes are valid even at points
/// without a valid compliance.
void carryModes(vtkPolyData* solid, vtkPolyData* body)
{
  vtkDataArray* signs = solid->GetFieldData()->GetArray(GlobalModeSignArray);
  if (!signs)
  {
    return;
  }
  const FacingPoints sources(solid, [](vtkIdType) { return true; });
  const BodyMesh mesh = makeBodyMesh(body);
  std::vector<vtkDataArray*> from;
  std::vector<vtkSmartPointer<vtkFloatArray>> to;
  for (vtkIdType k = 0; k < signs->GetNumberOfTuples(); ++k)
  {
    from.push_back(
      solid->GetPointData()->GetArray(globalModeName(static_cast<std::size_t>(k)).c_str()));
    to.push_back(vtkSmartPointer<vtkFloatArray>::New());
    to.back()->SetName(from.back()->GetName());
    to.back()->SetNumberOfComponents(3);
    to.back()->SetNumberOfTuples(body->GetNumberOfPoints());
    body->GetPointData()->AddArray(to.back());
  }
  body->GetFieldData()->AddArray(signs);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> place{};
    body->GetPoint(i, place.data());
    const auto sum = sources.around(place.data(), mesh.pointNormal(static_cast<std::int32_t>(i)));
    for (std::size_t k = 0; k < from.size(); ++k)
    {
      Vector3 mode = Vector3::Zero();
      for (const auto& [id, weight] : sum)
      {
        Vector3 part;
        from[k]->GetTuple(id, part.data());
        mode += weight * part;
      }
      to[k]->SetTuple(i, mode.data());
    }
  }
}
} // namespace

std::string carryCompliance(vtkPolyData* solid, vtkPolyData* body)
{
  vtkDataArray* status = solid->GetPointData()->GetArray("ComplianceStatus");
  vtkDataArray* values = solid->GetPointData()->GetArray("GlobalCompliance");
  const FacingPoints valid(solid, [&](vtkIdType id) { return status->GetTuple1(id) == 0.0; });
  if (valid.isEmpty())
  {
    return "the solid made of the body has no point with a compliance: is --voxel too coarse?";
  }
  // Points on a fixed side of the solid have no valid compliance. For this side, the values that
  // were interpolated along the surface are used.
  const FacingPoints others(solid,
    [&](vtkIdType id)
    { return status->GetTuple1(id) != 0.0 && !std::isnan(values->GetTuple1(id)); });
  const BodyMesh mesh = makeBodyMesh(body);
  vtkDataArray* errors = solid->GetPointData()->GetArray("GlobalComplianceError");
  vtkNew<vtkDoubleArray> carried;
  carried->SetName("GlobalCompliance");
  carried->SetNumberOfTuples(body->GetNumberOfPoints());
  vtkNew<vtkDoubleArray> carriedErrors;
  carriedErrors->SetName("GlobalComplianceError");
  carriedErrors->SetNumberOfTuples(body->GetNumberOfPoints());
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> place{};
    body->GetPoint(i, place.data());
    const Vector3 normal = mesh.pointNormal(static_cast<std::int32_t>(i));
    auto sum = valid.around(place.data(), normal);
    if (sum.empty())
    {
      sum = others.around(place.data(), normal);
    }
    if (sum.empty())
    {
      return "no compliance can be carried to point " + std::to_string(i) +
        " of the body: no point of its solid faces the same way; is --voxel too coarse?";
    }
    double value = 0.0;
    double error = 0.0;
    for (const auto& [id, weight] : sum)
    {
      value += weight * values->GetTuple1(id);
      error += errors ? weight * errors->GetTuple1(id) : 0.0;
    }
    carried->SetValue(i, value);
    carriedErrors->SetValue(i, error);
  }
  body->GetPointData()->AddArray(carried);
  if (errors)
  {
    body->GetPointData()->AddArray(carriedErrors);
  }
  carryModes(solid, body);
  return {};
}

std::string attachVoxelCompliance(
  vtkPolyData* body, const VoxelComplianceOptions& options, std::vector<std::string>& notes)
{
  std::string error = checkMemory(body, options.spacing);
  if (!error.empty())
  {
    return error;
  }
  vtkNew<vtkVoxelBody> voxels;
  voxels->SetInputData(body);
  voxels->SetSpacing(options.spacing);
  voxels->SetFixedFaces(options.fixedFaces);
  vtkNew<vtkElasticCompliance> compliance;
  compliance->SetInputConnection(voxels->GetOutputPort());
  compliance->SetYoungsModulus(options.youngsModulus);
  compliance->SetPoissonRatio(options.poissonRatio);
  compliance->SetNumberOfModes(BodyModes);
  error = updateQuietly(voxels);
  if (error.empty())
  {
    error = updateQuietly(compliance);
  }
  if (error.empty())
  {
    error = carryCompliance(compliance->GetOutput(), body);
  }
  if (!error.empty())
  {
    return error;
  }
  std::array<double, 2> range{};
  body->GetPointData()->GetArray("GlobalCompliance")->GetRange(range.data());
  std::array<char, 300> text{};
  std::snprintf(text.data(), text.size(),
    "filled with %lld hexahedra of %g mm, held at %s: it gives way by %.3g to %.3g mm/N; the %d "
    "modes that are drawn leave out %.0f %%.",
    static_cast<long long>(voxels->GetOutput()->GetNumberOfCells()), options.spacing,
    options.fixedFaces.c_str(), range[0], range[1], BodyModes,
    100.0 * compliance->GetNeglectedByModes());
  notes.emplace_back(text.data());
  return {};
}
} // namespace palpate
