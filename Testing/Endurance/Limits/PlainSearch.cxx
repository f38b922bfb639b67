// SPDX-License-Identifier: BSD-3-Clause
#include "PlainSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::endurance
{
PlainSearch::PlainSearch(const PackedMesh& mesh)
  : Mesh(mesh)
{
  this->Triangles.reserve(mesh.triangleCount());
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
  {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangle.corner[k] =
        mesh.corner(static_cast<std::int32_t>(t), static_cast<int>(k)).cast<float>();
    }
    const float longest = std::max((triangle.corner[1] - triangle.corner[0]).norm(),
      (triangle.corner[2] - triangle.corner[0]).norm());
    triangle.reach = 1.001F * longest;
    this->Triangles.push_back(triangle);
  }
}

testing::Nearest PlainSearch::nearest(const Vector3& tip) const
{
  const Vector3 local = this->Mesh.toLocal(tip);
  testing::Nearest best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const Triangle& triangle = this->Triangles[t];
    const double far = (triangle.corner[0].cast<double>() - local).norm();
    if (far - static_cast<double>(triangle.reach) > least)
    {
      continue;
    }
    const testing::Nearest here =
      testing::nearestOfTriangle(local, triangle.corner[0].cast<double>(),
        triangle.corner[1].cast<double>(), triangle.corner[2].cast<double>());
    if (here.distance < best.distance)
    {
      best = here;
      best.triangle = this->Mesh.inputTriangle(static_cast<std::int32_t>(t));
      least = static_cast<double>(best.distance);
    }
  }
  return best;
}

double PlainSearch::roundedBy(const std::vector<double>& points) const
{
  double largest = 0.0;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const TriangleCorners& corners = this->Mesh.corners(static_cast<std::int32_t>(t));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto point = static_cast<std::size_t>(this->Mesh.inputPoint(corners[k]));
      const Vector3 given(points[3 * point], points[3 * point + 1], points[3 * point + 2]);
      const Vector3 kept = this->Mesh.centre() + this->Triangles[t].corner[k].cast<double>();
      largest = std::max(largest, (kept - given).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}
} // namespace palpate::endurance
