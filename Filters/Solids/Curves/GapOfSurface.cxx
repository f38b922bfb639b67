// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Curves/GapOfSurface.h"

#include "Contact/SmoothTriangle.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace palpate
{
namespace
{
constexpr double LeastFacingCosine = 0.5; ///< cosine of 60°, for the largest angle to the normal
/// Lower limit of area coordinates. It is slightly negative, so that no position is missed between
/// two triangles.
constexpr double LeastAreaCoordinate = -1e-9;
constexpr double RadiusTolerance = 1e-6; ///< tolerance as a fraction of the largest radius

/// Visits the surface from one point, triangle by triangle, and stores the heights.
class GapWalk
{
public:
  GapWalk(const BodyMesh& mesh, const float* normals, std::int32_t point, double radius)
    : Mesh(mesh)
    , Normals(normals)
    , Point(point)
    , Radius(radius)
    , Frame(SurfaceGap::frame(this->normal(point)))
    , Origin(mesh.point(point))
  {
    this->Found.surface.setConstant(NotANumber);
    this->Found.facets.setConstant(NotANumber);
    for (int j = 0; j < SurfaceGap::Angles; ++j)
    {
      const double angle = 2.0 * Pi * j / SurfaceGap::Angles;
      this->Directions.col(j) << std::cos(angle), std::sin(angle);
    }
    for (int k = 0; k < SurfaceGap::Rings; ++k)
    {
      this->Rings[k] = radius * SurfaceGap::ring(k);
    }
  }

  SurfaceGap run()
  {
    std::vector<std::int32_t> front = { this->Point };
    std::unordered_set<std::int32_t> seen = { this->Point };
    std::unordered_set<std::int32_t> taken;
    while (!front.empty())
    {
      const std::int32_t from = front.back();
      front.pop_back();
      const auto [begin, end] = this->Mesh.trianglesAround(from);
      for (const std::int32_t* t = begin; t != end; ++t)
      {
        if (!taken.insert(*t).second || !this->take(*t))
        {
          continue;
        }
        for (const std::int32_t next : this->Mesh.corners(*t))
        {
          if (seen.insert(next).second)
          {
            front.push_back(next);
          }
        }
      }
    }
    int known = 0;
    while (known < SurfaceGap::Rings && this->Found.surface.row(known).allFinite())
    {
      ++known;
    }
    this->Found.known = known;
    return SurfaceGap(this->Radius, this->Found);
  }

private:
  Vector3 normal(std::int32_t point) const
  {
    return Eigen::Map<const Eigen::Vector3f>(this->Normals + 3 * static_cast<std::size_t>(point))
      .cast<double>();
  }

  /// Returns a position in the frame: coordinates along the tangents, and depth below the tangent
  /// plane.
  Vector3 inFrame(const Vector3& place) const
  {
    return this->Frame.transpose() * (place - this->Origin);
  }

  /// Sets the heights at the ring positions on a triangle. Returns false if the triangle is beyond
  /// the radius, or if its normal differs too much.
  bool take(std::int32_t triangle)
  {
    const TriangleCorners& corners = this->Mesh.corners(triangle);
    std::array<Vector3, 3> at;
    for (std::size_t i = 0; i < 3; ++i)
    {
      at[i] = this->inFrame(this->Mesh.point(corners[i]));
    }
    const Vector3 across = (at[1] - at[0]).cross(at[2] - at[0]);
    if (!(-across[2] > LeastFacingCosine * across.norm()))
    {
      return false; // the normal differs too much; the z axis of the frame points inwards
    }
    Eigen::Vector2d low = at[0].head<2>();
    Eigen::Vector2d high = low;
    for (const Vector3& corner : at)
    {
      low = low.cwiseMin(corner.head<2>());
      high = high.cwiseMax(corner.head<2>());
    }
    // The distances of the nearest and farthest point of the bounding box of the corners limit the
    // rings that the triangle can cover.
    const Eigen::Vector2d nearest = low.cwiseMax(Eigen::Vector2d::Zero().cwiseMin(high));
    const double from = nearest.norm() - RadiusTolerance * this->Radius;
    const double to = low.cwiseAbs().cwiseMax(high.cwiseAbs()).norm();
    if (from > this->Radius)
    {
      return false;
    }
    SmoothTriangle patch;
    double uneven = 0.0;
    bool isBuilt = false;
    bool isSmooth = false;
    for (int k = 0; k < SurfaceGap::Rings; ++k)
    {
      if (this->Rings[k] < from || this->Rings[k] > to)
      {
        continue;
      }
      for (int j = 0; j < SurfaceGap::Angles; ++j)
      {
        const Eigen::Vector2d place = this->Rings[k] * this->Directions.col(j);
        const Vector3 area = areaCoordinates(at, across[2], place);
        if (area.minCoeff() < LeastAreaCoordinate)
        {
          continue;
        }
        if (!isBuilt)
        {
          isBuilt = true;
          const std::array<Vector3, 3> normals = { this->turned(corners[0]),
            this->turned(corners[1]), this->turned(corners[2]) };
          isSmooth = patch.build(at, normals);
          uneven = isSmooth ? unevenness(at, normals) : 0.0;
        }
        this->put(k, j, at, area, isSmooth ? heightOn(patch, area, place) : NotANumber, uneven);
      }
    }
    return true;
  }

  Vector3 turned(std::int32_t point) const { return this->Frame.transpose() * this->normal(point); }

  static Vector3 areaCoordinates(
    const std::array<Vector3, 3>& at, double twice, const Eigen::Vector2d& place)
  {
    const auto part = [&](std::size_t i, std::size_t j)
    {
      const Eigen::Vector2d u = at[i].head<2>() - place;
      const Eigen::Vector2d v = at[j].head<2>() - place;
      return (u[0] * v[1] - u[1] * v[0]) / twice;
    };
    return { part(1, 2), part(2, 0), part(0, 1) };
  }

  /// Returns the root mean square unevenness of a triangle's edges (GapTerms::uneven).
  static double unevenness(const std::array<Vector3, 3>& at, const std::array<Vector3, 3>& normals)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t next = (i + 1) % 3;
      const double off = (normals[i] + normals[next]).dot(at[next] - at[i]);
      sum += off * off;
    }
    return std::sqrt(sum / 3.0);
  }

  /// Returns the depth of the patch below the tangent plane at a position. It is extrapolated along
  /// the tangent plane of the patch from the patch point with the area coordinates `area`.
  static double heightOn(
    const SmoothTriangle& patch, const Vector3& area, const Eigen::Vector2d& place)
  {
    const SurfaceJet jet = patch.evaluate(area);
    const Vector3 across = jet.across();
    const Eigen::Vector2d away = place - jet.point.head<2>();
    return jet.point[2] - away.dot(across.head<2>()) / across[2];
  }

  void put(int k, int j, const std::array<Vector3, 3>& at, const Vector3& area, double smooth,
    double uneven)
  {
    const double flat = area[0] * at[0][2] + area[1] * at[1][2] + area[2] * at[2][2];
    const double height = std::isfinite(smooth) ? smooth : flat;
    double& known = this->Found.surface(k, j);
    if (!(known <= height)) // if the surface is folded, the outermost layer is used
    {
      known = height;
      this->Found.facets(k, j) = flat;
      this->Found.uneven(k, j) = uneven;
    }
  }

  const BodyMesh& Mesh;
  const float* Normals;
  std::int32_t Point;
  double Radius;
  Eigen::Matrix3d Frame;
  Vector3 Origin;
  Eigen::Matrix<double, 2, SurfaceGap::Angles> Directions;
  Eigen::Matrix<double, SurfaceGap::Rings, 1> Rings;
  SurfaceGap::Heights Found;
};
} // namespace

SurfaceGap gapOfSurface(
  const BodyMesh& mesh, const float* normals, std::int32_t point, double radius)
{
  return GapWalk(mesh, normals, point, radius).run();
}
} // namespace palpate
