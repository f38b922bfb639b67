// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/EdgeSurface.h"

#include "Contact/PackedMesh.h"
#include "Contact/ParallelRanges.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

constexpr double SmallestBorder = 4.0; // radius of the largest ignored hole, in contact radii

/// Removes border loops that are shorter than `least` (mm), because they are holes in a scan.
void dropHoles(const LinkedSurface& surface, double least, std::vector<SurfaceSide>& border)
{
  std::map<std::int32_t, std::int32_t> above;
  const auto rootOf = [&above](std::int32_t i)
  {
    above.emplace(i, i);
    while (above[i] != i)
    {
      i = above[i] = above[above[i]];
    }
    return i;
  };
  for (const SurfaceSide& side : border)
  {
    above[rootOf(side.from)] = rootOf(side.to);
  }
  std::map<std::int32_t, double> lengths;
  for (const SurfaceSide& side : border)
  {
    lengths[rootOf(side.from)] += (surface.place(side.to) - surface.place(side.from)).norm();
  }
  border.erase(std::remove_if(border.begin(), border.end(),
                 [&](const SurfaceSide& side) { return lengths[rootOf(side.from)] < least; }),
    border.end());
}

double widthOf(const LinkedSurface& surface)
{
  double area = 0.0;
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (std::size_t t = 0; t < surface.corners.size(); ++t)
  {
    const double weight = surface.areas[t].norm() / 3.0;
    for (std::size_t k = 0; surface.corners[t][0] >= 0 && k < 3; ++k)
    {
      const Vector3d at = surface.place(surface.corners[t][k]) - surface.place(0);
      area += weight;
      sum += weight * at;
      squares += weight * at * at.transpose();
    }
  }
  if (!(area > 0.0))
  {
    return 0.0;
  }
  const Vector3d mean = sum / area;
  const Eigen::Matrix3d spread = squares / area - mean * mean.transpose();
  // Ratio of the squared side of a cube to the variance of its surface along an axis.
  constexpr double cube = 36.0 / 5.0;
  return std::sqrt(cube *
    std::max(0.0,
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly)
        .eigenvalues()[1]));
}

std::vector<SurfaceSide> borderOf(const LinkedSurface& surface)
{
  // Counts the sides that belong to one facet, by position. A side between duplicate points occurs
  // twice.
  using Place = std::array<double, 3>;
  std::map<std::pair<Place, Place>, int> at;
  std::vector<SurfaceSide> border;
  const auto keyOf = [&surface](const SurfaceSide& side)
  {
    Place one;
    Place other;
    std::copy_n(surface.place(side.from).data(), 3, one.begin());
    std::copy_n(surface.place(side.to).data(), 3, other.begin());
    return one < other ? std::make_pair(one, other) : std::make_pair(other, one);
  };
  for (std::size_t t = 0; t < surface.corners.size(); ++t)
  {
    const TriangleCorners& c = surface.corners[t];
    for (std::size_t i = 0; c[0] >= 0 && i < 3; ++i)
    {
      const SurfaceSide side{ c[i], c[(i + 1) % 3], 0.0F };
      if (surface.links.neighbours(t)[i] == TriangleLinks::Border)
      {
        border.push_back(side);
        ++at[keyOf(side)];
      }
    }
  }
  border.erase(std::remove_if(border.begin(), border.end(),
                 [&](const SurfaceSide& side) { return at[keyOf(side)] > 1; }),
    border.end());
  return border;
}
} // namespace

Vector3d facetCentre(const LinkedSurface& surface, std::size_t facet)
{
  const TriangleCorners& c = surface.corners[facet];
  return (surface.place(c[0]) + surface.place(c[1]) + surface.place(c[2])) / 3.0;
}

double angleBetween(const Vector3d& one, const Vector3d& other)
{
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

double facetTurn(const LinkedSurface& surface, std::size_t facet, std::size_t i)
{
  const std::int32_t other = surface.links.neighbours(facet)[i];
  if (other < 0 || surface.corners[facet][0] < 0)
  {
    return 0.0;
  }
  const auto o = static_cast<std::size_t>(other);
  const Vector3d across = facetCentre(surface, o) - surface.place(surface.corners[facet][i]);
  const bool isConvex = across.dot(surface.areas[facet]) < 0.0;
  return isConvex ? angleBetween(surface.areas[facet], surface.areas[o]) : 0.0;
}

EdgeSurface::EdgeSurface(const TriangleSpans& surface)
  : LinkedSurface(surface)
{
  this->width = widthOf(*this);
  this->border = borderOf(*this);
  this->findNormals();
  this->findSteepSides();
}

/// Computes the normal of each point as the sum of the area vectors of its facets.
void EdgeSurface::findNormals()
{
  double area = 0.0;
  this->normals.assign(this->spans.pointCount, Vector3d::Zero());
  for (std::size_t t = 0; t < this->corners.size(); ++t)
  {
    area += this->areas[t].norm();
    for (std::size_t i = 0; this->corners[t][0] >= 0 && i < 3; ++i)
    {
      this->normals[static_cast<std::size_t>(this->corners[t][i])] += this->areas[t];
    }
  }
  for (Vector3d& normal : this->normals)
  {
    normal.normalize();
  }
  const auto points = static_cast<double>(this->usedPoints());
  this->spacing = std::sqrt(area / std::max(1.0, points));
}

void EdgeSurface::findSteepSides()
{
  this->SteepSides.assign(this->corners.size(), 0);
  forRanges(this->corners.size(),
    [this](std::size_t first, std::size_t last)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        unsigned steep = 0;
        for (std::size_t i = 0; i < 3; ++i)
        {
          steep |= (facetTurn(*this, t, i) >= PackedMesh::BluntTurn ? 1U : 0U) << i;
        }
        this->SteepSides[t] = static_cast<std::uint8_t>(steep);
      }
    });
}

std::vector<SurfaceSide> findBorder(const EdgeSurface& surface, double contactRadius)
{
  std::vector<SurfaceSide> border = surface.border;
  dropHoles(surface, Pi * SmallestBorder * contactRadius, border);
  return border;
}
} // namespace palpate
