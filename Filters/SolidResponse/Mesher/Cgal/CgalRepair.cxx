// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/Cgal/CgalMesher.h"

#include "Mechanics/JoinedText.h"
#include "SolidResponse/Mesher/Cgal/CgalSurface.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
namespace meshes = CGAL::Polygon_mesh_processing;

/// Largest width of a filled hole, relative to the diagonal of the body's bounding box.
constexpr double WidestHole = 0.2;
/// Largest size of a removed fragment, as a fraction of the number of all triangles.
constexpr double LeastFragment = 0.001;
/// Largest fraction of crossing triangles. A larger fraction is not a defect of scanning.
constexpr double MostCrossing = 0.01;

double diagonalOf(const CGAL::Bbox_3& box)
{
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

using Crossings = std::vector<std::pair<CgalSurface::Face_index, CgalSurface::Face_index>>;

Crossings crossingsOf(const CgalSurface& surface)
{
  Crossings crossing;
  meshes::self_intersections(surface, std::back_inserter(crossing));
  return crossing;
}

/// Displacement of a point where sheets touch, as a fraction of the distance to the mean position
/// of its neighbours. Each sheet moves towards its own neighbours.
constexpr double SeparationFraction = 0.05;

/// Separates points at the same position. Returns the number of separated points.
std::size_t separateTouching(CgalSurface& mesh)
{
  std::map<CgalPoint, std::size_t> used;
  for (const CgalSurface::Vertex_index v : mesh.vertices())
  {
    ++used[mesh.point(v)];
  }
  std::vector<std::pair<CgalSurface::Vertex_index, CgalPoint>> moved;
  for (const CgalSurface::Vertex_index v : mesh.vertices())
  {
    if (used[mesh.point(v)] > 1)
    {
      CGAL::Vector_3<CgalKernel> sum(0.0, 0.0, 0.0);
      for (const CgalSurface::Vertex_index beside :
        CGAL::vertices_around_target(mesh.halfedge(v), mesh))
      {
        sum = sum + (mesh.point(beside) - mesh.point(v));
      }
      moved.emplace_back(
        v, mesh.point(v) + sum * (SeparationFraction / static_cast<double>(mesh.degree(v))));
    }
  }
  for (const auto& [v, place] : moved)
  {
    mesh.point(v) = place;
  }
  return moved.size();
}
} // namespace

std::string closeByCgal(MeshedSurface& surface, ClosedUp& done)
{
  std::vector<CgalPoint> points;
  std::vector<std::vector<std::size_t>> corners;
  for (Eigen::Index i = 0; i < surface.points.cols(); ++i)
  {
    points.emplace_back(surface.points(0, i), surface.points(1, i), surface.points(2, i));
  }
  for (const std::array<std::int32_t, 3>& triangle : surface.triangles)
  {
    corners.emplace_back(triangle.begin(), triangle.end());
  }
  ClosedUp made;
  CgalSurface mesh;
  try
  {
    meshes::repair_polygon_soup(points, corners);
    // The next calls separate sheets at edges of more than two triangles.
    meshes::orient_polygon_soup(points, corners);
    meshes::polygon_soup_to_polygon_mesh(points, corners, mesh);
    meshes::stitch_borders(mesh);
    meshes::keep_large_connected_components(mesh,
      static_cast<std::size_t>(LeastFragment * static_cast<double>(surface.triangles.size())) + 1);
    const double widest = WidestHole * diagonalOf(meshes::bbox(mesh));
    std::vector<CgalSurface::Halfedge_index> borders;
    meshes::extract_boundary_cycles(mesh, std::back_inserter(borders));
    for (const CgalSurface::Halfedge_index border : borders)
    {
      CGAL::Bbox_3 box;
      for (const CgalSurface::Halfedge_index side : CGAL::halfedges_around_face(border, mesh))
      {
        box += mesh.point(mesh.target(side)).bbox();
      }
      if (diagonalOf(box) > widest)
      {
        return joined("it has a hole ", diagonalOf(box), " mm wide");
      }
      std::vector<CgalSurface::Face_index> patch;
      meshes::triangulate_hole(mesh, border, std::back_inserter(patch));
      made.holes += patch.empty() ? 0 : 1;
      made.widest = std::max(made.widest, diagonalOf(box));
    }
  }
  catch (const std::exception& failed)
  {
    return joined("it cannot be closed (", failed.what(), ")");
  }
  mesh.collect_garbage();
  if (!CGAL::is_closed(mesh))
  {
    return "it cannot be closed";
  }
  made.points = separateTouching(mesh);
  meshes::orient_to_bound_a_volume(mesh);
  fromCgal(mesh, surface);
  done = made;
  return {};
}

std::string mendByCgal(MeshedSurface& surface, std::size_t& mended)
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
    joined("the surface intersects itself: triangles ", crossing.front().first.idx(), " and ",
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
    return joined(where, ", and it cannot be repaired (", failed.what(), ")");
  }
  mesh.collect_garbage();
  if (!CGAL::is_closed(mesh) || !crossingsOf(mesh).empty())
  {
    return where + ", and it cannot be repaired";
  }
  mended = crossing.size();
  fromCgal(mesh, surface);
  return {};
}
} // namespace palpate
