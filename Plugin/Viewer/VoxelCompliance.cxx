// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelCompliance.h"

#include "BodyConversion.h"
#include "ResponseSet.h"

#include "vtkDoubleArray.h"
#include "vtkElasticCompliance.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVoxelBody.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr int Sources = 6;          ///< points a value is carried from
constexpr int FirstSearch = 24;     ///< nearest points looked through for them, at first
constexpr double LargestTurn = 0.5; ///< cos 60°

/// The points of the solid with a compliance of their own, and their normals.
struct ValidPoints
{
  vtkSmartPointer<vtkPolyData> cloud = vtkSmartPointer<vtkPolyData>::New();
  std::vector<Vector3> normals;
  std::vector<double> compliance;
};

ValidPoints validPoints(vtkPolyData* solid)
{
  ValidPoints valid;
  const BodyMesh mesh = makeBodyMesh(solid);
  vtkDataArray* status = solid->GetPointData()->GetArray("ComplianceStatus");
  vtkDataArray* values = solid->GetPointData()->GetArray("GlobalCompliance");
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  for (vtkIdType i = 0; i < solid->GetNumberOfPoints(); ++i)
  {
    if (status->GetTuple1(i) == 0.0)
    {
      points->InsertNextPoint(solid->GetPoint(i));
      valid.normals.push_back(mesh.pointNormal(static_cast<std::int32_t>(i)));
      valid.compliance.push_back(values->GetTuple1(i));
    }
  }
  valid.cloud->SetPoints(points);
  return valid;
}

/// The mean of the nearest points that face the same way; false if there is none.
bool interpolate(const ValidPoints& valid, vtkStaticPointLocator* locator, const double place[3],
  const Vector3& normal, double& value)
{
  const auto all = static_cast<int>(valid.compliance.size());
  vtkNew<vtkIdList> nearest;
  for (int search = std::min(FirstSearch, all);; search = std::min(8 * search, all))
  {
    locator->FindClosestNPoints(search, place, nearest);
    double sum = 0.0;
    double weights = 0.0;
    int found = 0;
    for (vtkIdType k = 0; k < nearest->GetNumberOfIds() && found < Sources; ++k)
    {
      const vtkIdType id = nearest->GetId(k);
      if (valid.normals[static_cast<std::size_t>(id)].dot(normal) >= LargestTurn)
      {
        std::array<double, 3> at{};
        valid.cloud->GetPoint(id, at.data());
        const double weight =
          1.0 / std::max(vtkMath::Distance2BetweenPoints(at.data(), place), 1e-12);
        sum += weight * valid.compliance[static_cast<std::size_t>(id)];
        weights += weight;
        ++found;
      }
    }
    if (found == Sources || (search == all && found > 0))
    {
      value = sum / weights;
      return true;
    }
    if (search == all)
    {
      return false;
    }
  }
}
} // namespace

std::string carryCompliance(vtkPolyData* solid, vtkPolyData* body)
{
  const ValidPoints valid = validPoints(solid);
  if (valid.compliance.empty())
  {
    return "the solid made of the body has no point with a compliance: is --voxel too coarse?";
  }
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(valid.cloud);
  locator->BuildLocator();
  const BodyMesh mesh = makeBodyMesh(body);
  vtkNew<vtkDoubleArray> carried;
  carried->SetName("GlobalCompliance");
  carried->SetNumberOfTuples(body->GetNumberOfPoints());
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> place{};
    body->GetPoint(i, place.data());
    double value = 0.0;
    if (!interpolate(
          valid, locator, place.data(), mesh.pointNormal(static_cast<std::int32_t>(i)), value))
    {
      return "no compliance can be carried to point " + std::to_string(i) +
        " of the body: no point of its solid faces the same way; is --voxel too coarse?";
    }
    carried->SetValue(i, value);
  }
  body->GetPointData()->AddArray(carried);
  return {};
}

std::string attachVoxelCompliance(
  vtkPolyData* body, const VoxelComplianceOptions& options, std::vector<std::string>& notes)
{
  vtkNew<vtkVoxelBody> voxels;
  voxels->SetInputData(body);
  voxels->SetSpacing(options.spacing);
  voxels->SetFixedFaces(options.fixedFaces);
  vtkNew<vtkElasticCompliance> compliance;
  compliance->SetInputConnection(voxels->GetOutputPort());
  compliance->SetYoungsModulus(options.youngsModulus);
  compliance->SetPoissonRatio(options.poissonsRatio);
  std::string error = updateQuietly(voxels);
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
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
    "filled with %lld hexahedra of %g mm, held at %s: it gives way by %.3g to %.3g mm/N.",
    static_cast<long long>(voxels->GetOutput()->GetNumberOfCells()), options.spacing,
    options.fixedFaces.c_str(), range[0], range[1]);
  notes.emplace_back(text.data());
  return {};
}
} // namespace palpate
