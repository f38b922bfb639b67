// SPDX-License-Identifier: BSD-3-Clause
// Include this header only in sources that use CGAL.
#ifndef palpate_CgalSurface_h
#define palpate_CgalSurface_h

#include "Mechanics/JoinedText.h"
#include "SolidResponse/Mesher/SpacingGrid.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <string>

namespace palpate
{
using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = CgalKernel::Point_3;
using CgalSurface = CGAL::Surface_mesh<CgalPoint>;

/// Converts a surface to CGAL. Returns "", or an error message that names the invalid triangles.
inline std::string toCgal(const MeshedSurface& from, CgalSurface& surface)
{
  surface.reserve(static_cast<CgalSurface::size_type>(from.points.cols()),
    static_cast<CgalSurface::size_type>(3 * from.triangles.size() / 2),
    static_cast<CgalSurface::size_type>(from.triangles.size()));
  for (Eigen::Index i = 0; i < from.points.cols(); ++i)
  {
    surface.add_vertex(CgalPoint(from.points(0, i), from.points(1, i), from.points(2, i)));
  }
  for (std::size_t t = 0; t < from.triangles.size(); ++t)
  {
    std::array<CgalSurface::Vertex_index, 3> ids;
    std::transform(from.triangles[t].begin(), from.triangles[t].end(), ids.begin(),
      [](std::int32_t i)
      { return CgalSurface::Vertex_index(static_cast<CgalSurface::size_type>(i)); });
    if (surface.add_face(ids[0], ids[1], ids[2]) == CgalSurface::null_face())
    {
      return joined("triangle ", t,
        " meets others at an edge or a point where the surface touches "
        "itself, or is turned against them");
    }
  }
  return {};
}

/// Copies points and triangles of a surface to `to`. The surface must have no removed elements. All
/// other members of `to` are unchanged.
inline void fromCgal(const CgalSurface& surface, MeshedSurface& to)
{
  to.points.resize(3, static_cast<Eigen::Index>(surface.number_of_vertices()));
  for (const CgalSurface::Vertex_index v : surface.vertices())
  {
    const CgalPoint& at = surface.point(v);
    to.points.col(static_cast<Eigen::Index>(v.idx())) << at.x(), at.y(), at.z();
  }
  to.triangles.clear();
  for (const CgalSurface::Face_index face : surface.faces())
  {
    std::array<std::int32_t, 3> corners{};
    std::size_t i = 0;
    for (const CgalSurface::Vertex_index v : surface.vertices_around_face(surface.halfedge(face)))
    {
      corners[i++ % 3] = static_cast<std::int32_t>(v.idx());
    }
    to.triangles.push_back(corners);
  }
}
} // namespace palpate

#endif
