// SPDX-License-Identifier: BSD-3-Clause
// A source of its own for CGAL, as SurfaceMesher.
#include "Response/Mesher/SurfaceRepair.h"

#ifndef PALPATE_WITH_CGAL
namespace palpate
{
std::string mendSurface(MeshedSurface&, std::size_t& mended)
{
  mended = 0;
  return {}; // the mesher says that it is missing
}
} // namespace palpate
#else

#include "Mechanics/JoinedText.h"
#include "Response/Mesher/CgalSurface.h"

#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
namespace meshes = CGAL::Polygon_mesh_processing;

constexpr double MostCrossing = 0.01; ///< of the triangles: beyond, it is no slip of a scanner

void fromCgal(const CgalSurface& surface, MeshedSurface& to)
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

using Crossings = std::vector<std::pair<CgalSurface::Face_index, CgalSurface::Face_index>>;

Crossings crossingsOf(const CgalSurface& surface)
{
  Crossings crossing;
  meshes::self_intersections(surface, std::back_inserter(crossing));
  return crossing;
}
} // namespace

std::string mendSurface(MeshedSurface& surface, std::size_t& mended)
{
  mended = 0;
  CgalSurface mesh;
  std::string fault = toCgal(surface, mesh);
  if (!fault.empty())
  {
    return fault;
  }
  const Crossings crossing = crossingsOf(mesh);
  if (crossing.empty())
  {
    return {};
  }
  const std::string where =
    joined("the surface cuts itself: triangles ", crossing.front().first.idx(), " and ",
      crossing.front().second.idx(), " cross, the first of ", crossing.size(), " pairs");
  if (static_cast<double>(crossing.size()) >
    MostCrossing * static_cast<double>(surface.triangles.size()))
  {
    return where;
  }
  try
  {
    meshes::experimental::remove_self_intersections(mesh);
  }
  catch (const std::exception& failed)
  {
    return joined(where, ", and it cannot be mended (", failed.what(), ")");
  }
  mesh.collect_garbage();
  if (!CGAL::is_closed(mesh) || !crossingsOf(mesh).empty())
  {
    return where + ", and it cannot be mended";
  }
  mended = crossing.size();
  fromCgal(mesh, surface);
  return {};
}
} // namespace palpate
#endif
