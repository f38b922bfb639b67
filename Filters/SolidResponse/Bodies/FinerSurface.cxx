// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/FinerSurface.h"

#include "Solids/Curves/GapOfSurface.h"
#include "Mechanics/SharedWork.h"
#include "Response/BodyConversion.h"
#include "SolidResponse/Bodies/NearLandmarks.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
FinerSurface::FinerSurface(vtkPolyData* surface, const float* normals, vtkPolyData* solid,
  const LandmarkKernels& landmarks, double a)
  : Landmarks(landmarks)
  , Normals(normals)
  , Mesh(makeBodyMesh(surface))
  , Reach(SurfaceGap::reachFor(a))
  , OnSurface(surface, [](vtkIdType) { return true; })
  , NearbyLandmarks(this->Mesh.pointCount())
  , Turns(this->NearbyLandmarks.size(), 0.0F)
{
  const NearLandmarks near(solid, landmarks);
  shareWork(this->NearbyLandmarks.size(),
    [this, &near](std::size_t i)
    { this->NearbyLandmarks[i] = near.around(this->Mesh.coordinates() + 3 * i, this->normal(i)); });
  this->findTurns();
}

Vector3 FinerSurface::normal(std::size_t i) const
{
  return Eigen::Map<const Eigen::Vector3f>(this->Normals + 3 * i).cast<double>();
}

void FinerSurface::findTurns()
{
  const BodyMesh& mesh = this->Mesh;
  std::vector<double> sag(this->Turns.size(), 0.0);
  std::vector<double> least(this->Turns.size(), 1.0);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    const TriangleCorners& corners = mesh.corners(t);
    const Vector3 across = (mesh.point(corners[1]) - mesh.point(corners[0]))
                             .cross(mesh.point(corners[2]) - mesh.point(corners[0]));
    for (const std::int32_t corner : corners)
    {
      const auto i = static_cast<std::size_t>(corner);
      const Vector3 up = this->normal(i);
      const Vector3 middle =
        (mesh.point(corners[0]) + mesh.point(corners[1]) + mesh.point(corners[2])) / 3.0;
      sag[i] += up.dot(middle - mesh.point(corner));
      least[i] = across.norm() > 0.0 ? std::min(least[i], up.dot(across.normalized())) : least[i];
    }
  }
  for (std::size_t i = 0; i < this->Turns.size(); ++i)
  {
    const double half = std::acos(std::clamp(least[i], 0.0, 1.0));
    this->Turns[i] = sag[i] < 0.0 ? static_cast<float>(2.0 * half) : 0.0F;
  }
}

LandmarkSpot FinerSurface::spot(std::size_t i) const
{
  LandmarkSpot made;
  made.surface.place = this->Mesh.point(static_cast<std::int32_t>(i));
  made.surface.normal = this->normal(i);
  made.surface.gap =
    gapOfSurface(this->Mesh, this->Normals, static_cast<std::int32_t>(i), this->Reach);
  made.around = this->NearbyLandmarks[i];
  return made;
}

EdgeSurroundings FinerSurface::surroundings(
  std::int32_t i, const std::function<bool(std::int32_t)>& isValid) const
{
  const auto at = static_cast<std::size_t>(i);
  const Vector3 place = this->Mesh.point(i);
  EdgeSurroundings made;
  made.turn = static_cast<double>(this->Turns[at]);
  for (const auto& part : this->OnSurface.nearBy(place.data(), this->normal(at),
         [&isValid](vtkIdType id) { return isValid(static_cast<std::int32_t>(id)); }))
  {
    const auto other = static_cast<std::int32_t>(part.first);
    made.found.push_back({ other, (this->Mesh.point(other) - place).norm() });
  }
  return made;
}

LandmarkSurface FinerSurface::view() const
{
  LandmarkSurface made;
  made.spotAt = [this](std::size_t i) { return this->spot(i); };
  made.edges.points = this->Mesh.pointCount();
  made.edges.materialAt = [this](std::int32_t i)
  {
    const std::vector<std::size_t>& around = this->NearbyLandmarks[static_cast<std::size_t>(i)];
    return around.empty() ? ElasticMaterial{} : this->Landmarks.material(around.front());
  };
  made.edges.around = [this](std::int32_t i, const std::function<bool(std::int32_t)>& isValid)
  { return this->surroundings(i, isValid); };
  return made;
}
} // namespace palpate
