// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/LargeTriangles.h"

#include "Mechanics/SharedWork.h"
#include "SolidResponse/Bodies/SurfaceYield.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

constexpr double LargeSide = 2.0; // smallest side length of a large triangle, in contact radii

/// The sampled positions inside a triangle, as area coordinates.
const std::array<Vector3d, 4> Places = { Vector3d::Constant(1.0 / 3.0),
  Vector3d(4.0, 1.0, 1.0) / 6.0, Vector3d(1.0, 4.0, 1.0) / 6.0, Vector3d(1.0, 1.0, 4.0) / 6.0 };

struct LargeTriangle
{
  std::array<std::size_t, 3> corners{};
  std::array<SpotYield, Places.size()> inside;
};

std::vector<LargeTriangle> sampleTriangles(
  vtkPolyData* surface, const YieldField& field, const std::vector<double>& radii)
{
  std::vector<LargeTriangle> found;
  std::vector<Eigen::Matrix3d> places; // corners of each triangle, one corner per column
  vtkNew<vtkIdList> points;
  for (vtkIdType t = 0; t < surface->GetNumberOfCells(); ++t)
  {
    surface->GetCellPoints(t, points);
    LargeTriangle triangle;
    Eigen::Matrix3d corners;
    for (int c = 0; c < 3; ++c)
    {
      triangle.corners[static_cast<std::size_t>(c)] = static_cast<std::size_t>(points->GetId(c));
      surface->GetPoint(points->GetId(c), corners.col(c).data());
    }
    const double longest = std::max({ (corners.col(1) - corners.col(0)).norm(),
      (corners.col(2) - corners.col(1)).norm(), (corners.col(0) - corners.col(2)).norm() });
    if (longest > LargeSide * radii.front())
    {
      found.push_back(std::move(triangle));
      places.push_back(corners);
    }
  }
  shareWork(found.size(),
    [&](std::size_t i)
    {
      const Eigen::Matrix3d& corners = places[i];
      const Vector3d normal =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).normalized();
      for (std::size_t k = 0; k < Places.size(); ++k)
      {
        found[i].inside[k] = field.at(corners * Places[k], normal, radii);
      }
    });
  return found;
}

/// The compliances for one contact radius.
class RadiusYield
{
public:
  RadiusYield(const std::vector<LargeTriangle>& triangles, std::size_t radius, std::size_t points,
    SurfaceYield& made)
    : Triangles(triangles)
    , Radius(radius)
    , Compliance(made.compliance.data() + radius * points)
    , Error(made.error.data() + radius * points)
    , Points(points)
  {
  }

  void removeWrong()
  {
    std::vector<std::size_t> wrong;
    for (const LargeTriangle& triangle : this->Triangles)
    {
      if (this->difference(triangle, 0.0) < this->difference(triangle, 1.0))
      {
        wrong.insert(wrong.end(), triangle.corners.begin(), triangle.corners.end());
      }
    }
    for (const std::size_t point : wrong)
    {
      this->Compliance[point] = 0.0;
      this->Error[point] = 0.0;
    }
  }

  void includeDifference()
  {
    std::vector<double> most(this->Points, 0.0);
    for (const LargeTriangle& triangle : this->Triangles)
    {
      const double difference = this->difference(triangle, 1.0);
      for (const std::size_t point : triangle.corners)
      {
        most[point] = std::max(most[point], difference);
      }
    }
    for (std::size_t i = 0; i < most.size(); ++i)
    {
      this->Error[i] += most[i];
    }
  }

private:
  /// Returns the largest difference between the compliances at the sampled positions and `share`
  /// times the value interpolated from the corners.
  double difference(const LargeTriangle& triangle, double share) const
  {
    double most = 0.0;
    for (std::size_t k = 0; k < Places.size(); ++k)
    {
      double blend = 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        blend += Places[k][static_cast<Eigen::Index>(c)] * this->Compliance[triangle.corners[c]];
      }
      most = std::max(most, std::abs(share * blend - triangle.inside[k].compliance[this->Radius]));
    }
    return most;
  }

  const std::vector<LargeTriangle>& Triangles;
  std::size_t Radius;
  double* Compliance;
  double* Error;
  std::size_t Points;
};
} // namespace

void includeLargeTriangles(vtkPolyData* surface, const YieldField& field,
  const std::vector<double>& radii, SurfaceYield& made)
{
  const std::vector<LargeTriangle> triangles = sampleTriangles(surface, field, radii);
  for (std::size_t k = 0; k < radii.size(); ++k)
  {
    RadiusYield yield(triangles, k, made.status.size(), made);
    yield.removeWrong();
    yield.includeDifference();
  }
}
} // namespace palpate
