// SPDX-License-Identifier: BSD-3-Clause
// CGAL's tree of axis-aligned boxes, with the point and triangle of the last tick as a hint.
#include "TimedMethod.h"

#ifdef PALPATE_WITH_CGAL
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

namespace palpate::benchmarks
{
namespace
{
class CgalPoint
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  using PointAndTriangle = Tree::Point_and_primitive_id;

public:
  explicit CgalPoint(const testing::Surface& surface)
  {
    this->Given.reserve(surface.triangles.size());
    const auto point = [&](std::int32_t id)
    {
      const Vector3& p = surface.points[static_cast<std::size_t>(id)];
      return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    for (const auto& corners : surface.triangles)
    {
      this->Given.emplace_back(point(corners[0]), point(corners[1]), point(corners[2]));
    }
    this->Boxes.insert(this->Given.cbegin(), this->Given.cend());
    // The second tree would only be used by queries without a hint.
    this->Boxes.do_not_accelerate_distance_queries();
    this->Boxes.build();
    this->reset();
  }

  Kernel::Point_3 prepare(const Vector3* tips) { return { tips->x(), tips->y(), tips->z() }; }
  double operator()(const Kernel::Point_3& tip)
  {
    this->Last = this->Boxes.closest_point_and_primitive(tip, this->Last);
    return CGAL::squared_distance(tip, this->Last.first);
  }
  double distance(const Vector3* /*tips*/, double squaredDistance) const
  {
    return std::sqrt(squaredDistance);
  }
  void reset() { this->Last = { this->Given.front()[0], this->Given.cbegin() }; }

private:
  Triangles Given;
  Tree Boxes;
  PointAndTriangle Last;
};
} // namespace

std::unique_ptr<TimedMethod> makeCgalPoint(const testing::Surface& surface)
{
  return timed<CgalPoint>(surface);
}
} // namespace palpate::benchmarks

#else
namespace palpate::benchmarks
{
std::unique_ptr<TimedMethod> makeCgalPoint(const testing::Surface& /*surface*/)
{
  return nullptr;
}
} // namespace palpate::benchmarks
#endif
