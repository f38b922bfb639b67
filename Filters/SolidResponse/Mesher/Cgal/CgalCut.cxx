// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/Cgal/CgalMesher.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "SolidResponse/Mesher/Cgal/CgalSurface.h"

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <numeric>

namespace palpate
{
namespace
{
namespace meshes = CGAL::Polygon_mesh_processing;

/// Tolerance for rounding errors of constructed points, as a fraction of the body's size.
constexpr double OnPlane = 1e-9;
constexpr const char* NothingLeft = "nothing of the body would be left";

std::string nameOf(const CutPlane& plane)
{
  return joined("xyz"[plane.axis], " = ", plane.at, " mm");
}

CgalKernel::Plane_3 convertPlane(const CutPlane& plane)
{
  const double sign = plane.isUpper ? 1.0 : -1.0; // CGAL keeps the negative side of the plane
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  normal[plane.axis] = sign;
  return { normal.x(), normal.y(), normal.z(), -sign * plane.at };
}

/// Moves points to the plane if their distance from it is only a rounding error.
void roundTo(const CutPlane& plane, MeshedSurface& surface)
{
  const double size =
    (surface.points.rowwise().maxCoeff() - surface.points.rowwise().minCoeff()).maxCoeff();
  for (double& at : surface.points.row(plane.axis))
  {
    at = std::abs(at - plane.at) <= OnPlane * size ? plane.at : at;
  }
}

/// Adds the edges for which exactly one triangle is in the plane to the rims.
void addRims(const CutPlane& plane, MeshedSurface& surface)
{
  const auto isOn = [&](std::int32_t i) { return surface.points(plane.axis, i) == plane.at; };
  std::vector<std::array<std::int32_t, 2>> edges;
  for (const std::array<std::int32_t, 3>& corners : surface.triangles)
  {
    if (std::all_of(corners.begin(), corners.end(), isOn))
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
        edges.push_back({ low, high });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (i + 1 < edges.size() && edges[i] == edges[i + 1])
    {
      ++i; // both triangles of the edge are in the plane
      continue;
    }
    surface.rims.push_back(edges[i]);
  }
}

/// Sorts points and triangles by position. This is necessary because CGAL orders the results of a
/// cut by memory addresses, and the next cut and the cells depend on the order.
void sortElements(MeshedSurface& surface)
{
  const auto count = static_cast<std::size_t>(surface.points.cols());
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](std::int32_t i)
  {
    const auto at = surface.points.col(i);
    return std::array<double, 3>{ at.x(), at.y(), at.z() };
  };
  std::sort(order.begin(), order.end(),
    [&](std::int32_t a, std::int32_t b) { return place(a) < place(b); });
  std::vector<std::int32_t> number(count);
  Eigen::Matrix3Xd points(3, surface.points.cols());
  for (std::size_t i = 0; i < count; ++i)
  {
    number[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
    points.col(static_cast<Eigen::Index>(i)) = surface.points.col(order[i]);
  }
  surface.points = points;
  for (std::array<std::int32_t, 3>& corners : surface.triangles)
  {
    std::transform(corners.begin(), corners.end(), corners.begin(),
      [&](std::int32_t i) { return number[static_cast<std::size_t>(i)]; });
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  std::sort(surface.triangles.begin(), surface.triangles.end());
}

/// Cuts a surface at a plane and sorts its elements. Returns "" or an error message.
std::string cutAt(const CutPlane& plane, MeshedSurface& surface)
{
  CgalSurface mesh;
  std::string fault = toCgal(surface, mesh);
  if (!fault.empty())
  {
    return fault;
  }
  try
  {
    if (!meshes::clip(mesh, convertPlane(plane), CGAL::parameters::clip_volume(true)))
    {
      return joined("the surface touches itself where it is cut at ", nameOf(plane));
    }
  }
  catch (const std::exception& failed)
  {
    return joined("the surface cannot be cut at ", nameOf(plane), " (", failed.what(), ")");
  }
  mesh.collect_garbage();
  if (mesh.number_of_faces() == 0)
  {
    return NothingLeft;
  }
  fromCgal(mesh, surface);
  roundTo(plane, surface);
  sortElements(surface);
  return {};
}

/// Removes parts whose volume is below `least`, mm³. Returns "" or an error message.
std::string removeSmallParts(double least, MeshedSurface& surface)
{
  CgalSurface mesh;
  const std::string fault = toCgal(surface, mesh);
  if (!fault.empty())
  {
    return fault;
  }
  meshes::remove_connected_components_of_negligible_size(
    mesh, CGAL::parameters::area_threshold(0.0).volume_threshold(least));
  mesh.collect_garbage();
  fromCgal(mesh, surface);
  return surface.triangles.empty() ? NothingLeft : "";
}
} // namespace

std::string cutByCgal(MeshedSurface& surface, const std::vector<CutPlane>& planes, double least,
  const std::vector<CutPlane>& before)
{
  MeshedSurface made = surface;
  made.rims.clear();
  std::string fault;
  for (std::size_t i = 0; i < planes.size() && fault.empty(); ++i)
  {
    fault = cutAt(planes[i], made);
  }
  if (fault.empty())
  {
    fault = removeSmallParts(least, made);
  }
  if (!fault.empty())
  {
    return fault;
  }
  std::vector<CutPlane> all = planes;
  all.insert(all.end(), before.begin(), before.end());
  for (const CutPlane& plane : all)
  {
    roundTo(plane, made);
  }
  sortElements(made);
  for (const CutPlane& plane : all)
  {
    addRims(plane, made);
  }
  std::sort(made.rims.begin(), made.rims.end());
  made.rims.erase(std::unique(made.rims.begin(), made.rims.end()), made.rims.end());
  surface = std::move(made);
  return {};
}
} // namespace palpate
