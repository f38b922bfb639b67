// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/MotionArrays.h"

#include "Contact/BodyMesh.h"
#include "Mechanics/SharedWork.h"
#include "SolidResponse/Bodies/FacingPoints.h"
#include "SolidResponse/Bodies/HeldPlaces.h"
#include "Response/BodyConversion.h"
#include "Response/BodyField.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>

namespace palpate
{
namespace
{
/// Returns the points of the solid, with weights, from which the values at a point of the surface
/// are interpolated.
using PartsOf = std::function<std::vector<std::pair<vtkIdType, double>>(std::size_t)>;

/// Adds a point array of zeros. Replaces an array of the same name.
vtkSmartPointer<vtkFloatArray> addArray(vtkPolyData* surface, const std::string& name, int width)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(width);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  array->Fill(0.0);
  surface->GetPointData()->AddArray(array);
  return array;
}

void fillModes(const GlobalModes& modes, const PartsOf& partsOf, vtkPolyData* surface)
{
  for (std::size_t k = modes.fields.size();
       surface->GetPointData()->HasArray(globalModeName(k).c_str()) != 0; ++k)
  {
    // An existing array may belong to another body.
    surface->GetPointData()->RemoveArray(globalModeName(k).c_str());
  }
  std::vector<float*> to;
  vtkNew<vtkSignedCharArray> signs;
  signs->SetName(GlobalModeSignArray);
  for (std::size_t k = 0; k < modes.fields.size(); ++k)
  {
    to.push_back(addArray(surface, globalModeName(k), 3)->GetPointer(0));
    signs->InsertNextValue(static_cast<signed char>(modes.signs[k]));
  }
  surface->GetFieldData()->AddArray(signs);
  shareWork(static_cast<std::size_t>(surface->GetNumberOfPoints()),
    [&](std::size_t i)
    {
      const auto parts = partsOf(i);
      for (std::size_t k = 0; k < to.size(); ++k)
      {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& [id, weight] : parts)
        {
          sum += weight * modes.fields[k].col(id);
        }
        Eigen::Map<Eigen::Vector3f>(to[k] + 3 * i) = sum.cast<float>();
      }
    });
}

void fillNear(const SurfaceMotion& motion, const PartsOf& partsOf, vtkPolyData* surface)
{
  float* to =
    addArray(surface, NearFieldArray, static_cast<int>(NearField::Numbers))->GetPointer(0);
  shareWork(static_cast<std::size_t>(surface->GetNumberOfPoints()),
    [&](std::size_t i)
    {
      std::array<double, NearField::Numbers> sum{};
      for (const auto& [id, weight] : partsOf(i))
      {
        const auto at = std::lower_bound(
          motion.points.begin(), motion.points.end(), static_cast<std::int32_t>(id));
        const auto numbers =
          numbersOf(motion.near[static_cast<std::size_t>(at - motion.points.begin())]);
        for (std::size_t k = 0; k < sum.size(); ++k)
        {
          sum[k] += weight * numbers[k];
        }
      }
      std::transform(sum.begin(), sum.end(), to + sum.size() * i,
        [](double number) { return static_cast<float>(number); });
    });
}

/// Interpolates from nearby points whose normals are similar to those of the surface's points.
PartsOf nearbyParts(const FacingPoints& points, const BodyMesh& mesh, vtkFloatArray* normals)
{
  return [&points, &mesh, normals](std::size_t i)
  {
    const Vector3 normal =
      Eigen::Map<const Eigen::Vector3f>(normals->GetPointer(0) + 3 * i).cast<double>();
    return points.nearBy(mesh.point(static_cast<std::int32_t>(i)).data(), normal);
  };
}

FacingPoints sourcesOf(const SurfaceMotion& motion, vtkPolyData* solid)
{
  return FacingPoints(solid,
    [&motion](vtkIdType id)
    {
      return std::binary_search(
        motion.points.begin(), motion.points.end(), static_cast<std::int32_t>(id));
    });
}
} // namespace

void attachMotion(const SurfaceMotion& motion, vtkPolyData* solid)
{
  fillModes(
    motion.modes,
    [](std::size_t i) -> std::vector<std::pair<vtkIdType, double>> {
      return { { static_cast<vtkIdType>(i), 1.0 } };
    },
    solid);
  const FacingPoints sources = sourcesOf(motion, solid);
  const BodyMesh mesh = makeBodyMesh(solid);
  const auto nearestSources = [&](std::size_t i) -> std::vector<std::pair<vtkIdType, double>>
  {
    const auto id = static_cast<std::int32_t>(i);
    if (std::binary_search(motion.points.begin(), motion.points.end(), id))
    {
      return { { id, 1.0 } };
    }
    return sources.nearBy(mesh.point(id).data(), mesh.pointNormal(id));
  };
  fillNear(motion, nearestSources, solid);
}

void attachModes(
  const GlobalModes& modes, vtkPolyData* solid, vtkFloatArray* normals, vtkPolyData* surface)
{
  const BodyMesh mesh = makeBodyMesh(surface);
  const FacingPoints all(solid, [](vtkIdType) { return true; });
  const HeldPlaces held(solid,
    [&modes](vtkIdType id)
    {
      return std::all_of(modes.fields.begin(), modes.fields.end(),
        [id](const auto& field) { return field.col(id).isZero(0.0); });
    });
  fillModes(
    modes,
    [&, moving = nearbyParts(all, mesh, normals)](std::size_t i)
    {
      return held.contain(mesh.point(static_cast<std::int32_t>(i)).data())
        ? std::vector<std::pair<vtkIdType, double>>()
        : moving(i);
    },
    surface);
}

void attachMotion(
  const SurfaceMotion& motion, vtkPolyData* solid, vtkFloatArray* normals, vtkPolyData* surface)
{
  attachModes(motion.modes, solid, normals, surface);
  const BodyMesh mesh = makeBodyMesh(surface);
  const FacingPoints sources = sourcesOf(motion, solid);
  fillNear(motion, nearbyParts(sources, mesh, normals), surface);
}
} // namespace palpate
