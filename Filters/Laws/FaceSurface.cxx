// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/FaceSurface.h"

#include "Contact/Edges/BodyEdges.h"
#include "Contact/Edges/CreaseCut.h"

#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace palpate
{
using Eigen::Vector3d;

FaceSurface::FaceSurface(const TriangleSpans& surface, const float* normals)
  : Points(surface.points, surface.points + 3 * surface.pointCount)
  , Triangles(surface.triangles, surface.triangles + 3 * surface.triangleCount)
  , Normals(normals, normals + 3 * surface.pointCount)
  , PointOf(surface.pointCount)
  , IsCut(surface.pointCount, false)
{
  std::iota(this->PointOf.begin(), this->PointOf.end(), 0);
  const LinkedSurface linked(surface);
  this->cut(linked);
  this->findNormals(linked);
}

void FaceSurface::cut(const LinkedSurface& surface)
{
  std::vector<TriangleCorners> corners; // corners of the triangles that have an area
  std::vector<std::size_t> triangleOf;
  for (std::size_t t = 0; t < surface.corners.size(); ++t)
  {
    if (surface.corners[t][0] >= 0)
    {
      corners.push_back(surface.corners[t]);
      triangleOf.push_back(t);
    }
  }
  if (corners.empty())
  {
    return;
  }
  const Vector3d origin = surface.place(corners.front()[0]);
  std::vector<float> local(this->Points.size());
  for (std::size_t i = 0; i < local.size(); ++i)
  {
    local[i] = static_cast<float>(this->Points[i] - origin[static_cast<Eigen::Index>(i % 3)]);
  }
  const TriangleLinks links(corners, this->PointOf.size());
  const CreaseCut creases(corners, corners.size(), local, links, BodyEdges::LeastTurn);
  // The copy of a point for each pair of point and face.
  std::map<std::pair<std::int32_t, int>, std::int32_t> copies;
  for (std::size_t t = 0; t < corners.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t point = corners[t][k];
      const int part = creases.part(t, k);
      if (part == 0)
      {
        continue;
      }
      const auto next = static_cast<std::int32_t>(this->PointOf.size());
      const auto [copy, isNew] = copies.try_emplace({ point, part }, next);
      if (isNew)
      {
        const Vector3d place = surface.place(point);
        this->Points.insert(this->Points.end(), place.data(), place.data() + 3);
        this->PointOf.push_back(point);
        this->IsCut[static_cast<std::size_t>(point)] = true;
      }
      this->Triangles[3 * triangleOf[t] + k] = copy->second;
    }
  }
  this->IsCut.resize(this->PointOf.size(), true);
  this->Normals.resize(this->Points.size(), 0.0F);
}

void FaceSurface::findNormals(const LinkedSurface& surface)
{
  std::vector<Vector3d> sums(this->PointOf.size(), Vector3d::Zero());
  for (std::size_t t = 0; t < surface.corners.size(); ++t)
  {
    for (std::size_t k = 0; surface.corners[t][0] >= 0 && k < 3; ++k)
    {
      sums[static_cast<std::size_t>(this->Triangles[3 * t + k])] += surface.areas[t];
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    if (this->IsCut[i])
    {
      Eigen::Map<Eigen::Vector3f>(this->Normals.data() + 3 * i) =
        sums[i].normalized().cast<float>();
    }
  }
}

FaceForms::FaceForms(const TriangleSpans& surface, const float* normals)
  : Points(surface.pointCount)
  , Faces(surface, normals)
  , Forms(this->Faces.spans(), this->Faces.normals().data())
{
}

SurfaceCurvature FaceForms::curvature(double contactRadius) const
{
  const std::vector<PointCurvature> found = this->Forms.curvatures(contactRadius);
  std::vector<PointCurvature> sums(this->Points, PointCurvature{});
  std::vector<float> count(this->Points, 0.0F);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const auto point = static_cast<std::size_t>(this->Faces.pointOf(i));
    count[point] += 1.0F;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sums[point][k] += found[i][k];
    }
  }
  for (std::size_t point = 0; point < sums.size(); ++point)
  {
    for (float& value : sums[point])
    {
      value /= count[point];
    }
  }
  return SurfaceCurvature(std::move(sums));
}
} // namespace palpate
