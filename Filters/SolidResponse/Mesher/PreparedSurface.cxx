// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/PreparedSurface.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "SolidResponse/Mesher/MeshConversion.h"
#include "SolidResponse/Mesher/OutsideReach.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"
#include "SolidResponse/Mesher/SurfaceRepair.h"

#include "vtkPolyData.h"

#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// Largest relative loss of volume. Facets cut off about a hundredth of the volume. A loss above
/// this limit means that a part of the body is lost.
constexpr double LostVolume = 0.1;
/// Parts that remain after a cut are removed if their volume is below that of a cube with this side
/// length, in spacings.
constexpr double LeastLeft = 0.5;
// Depth of a held face after the part beyond it was cut off, in spacings.
constexpr double NearCut = 1e-6;
constexpr double RoughStep = 3.0; // factor on the deviation if a surface is too rough

double volumeOf(const TetrahedralMesh& mesh)
{
  double volume = 0.0;
  for (const auto& cell : mesh.cells)
  {
    Eigen::Matrix3d sides;
    for (int i = 0; i < 3; ++i)
    {
      sides.col(i) =
        mesh.nodes.col(cell[static_cast<std::size_t>(i) + 1]) - mesh.nodes.col(cell[0]);
    }
    volume += sides.determinant() / 6.0;
  }
  return volume;
}
/// Returns the planes at the depths of the held faces. If `givenAlone` is set, only held faces are
/// used for which the user specified the depth.
std::vector<CutPlane> planesOf(
  const MeshedSurface& surface, const HeldFaces& faces, bool givenAlone)
{
  std::vector<CutPlane> planes;
  for (std::size_t side = 0; side < faces.size(); ++side)
  {
    const HeldFace& face = faces[side];
    const auto axis = static_cast<Eigen::Index>(side / 2);
    const bool isUpper = side % 2 == 1;
    const auto row = surface.points.row(axis);
    if (givenAlone ? face.isGiven : face.depth > 0.0)
    {
      planes.push_back(
        { axis, isUpper, isUpper ? row.maxCoeff() - face.depth : row.minCoeff() + face.depth });
    }
  }
  return planes;
}
} // namespace

std::string takeSurface(vtkPolyData* body, PreparedSurface& prepared)
{
  const std::string fault = takeClosedSurface(body, prepared.closed);
  if (fault.empty() || !prepared.closed.isOpen)
  {
    return fault;
  }
  MeshedSurface surface = convertSurfaceToMesh(prepared.closed.surface);
  ClosedUp done;
  const std::string open = closeSurface(surface, done);
  if (!open.empty())
  {
    return fault + " (" + open + ")";
  }
  prepared.warnings.push_back(joined("The surface was not closed: it was separated at ",
    done.points, " points where it touched itself, and ", done.holes,
    " holes were filled, the widest ", done.widest, " mm."));
  prepared.closed = {};
  return takeClosedSurface(convertMeshToSurface(surface), prepared.closed);
}

std::string mendAndCut(double spacing, HeldFaces& faces, PreparedSurface& prepared)
{
  prepared.wanted = convertSurfaceToMesh(prepared.closed.surface);
  MeshedSurface& wanted = prepared.wanted;
  std::size_t mended = 0;
  std::string fault = mendSurface(wanted, mended);
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  if (mended > 0)
  {
    prepared.warnings.push_back(joined("The surface intersected itself at ", mended,
      " pairs of triangles; it was repaired there before it was filled."));
  }
  std::vector<CutPlane> planes = planesOf(wanted, faces, true);
  MeshedSurface left = wanted;
  ClosedSurface closedLeft;
  if (!planes.empty())
  {
    fault = firstFault([&] { return cutOff(left, planes, std::pow(LeastLeft * spacing, 3)); },
      [&] { return takeClosedSurface(convertMeshToSurface(left), closedLeft); });
    if (!fault.empty())
    {
      prepared.warnings.push_back("The held part ends at whole cells, since " + fault + ".");
    }
    else
    {
      wanted = std::move(left);
      prepared.closed = closedLeft;
      prepared.cuts = std::move(planes);
      for (HeldFace& face : faces)
      {
        face.depth = face.isGiven ? NearCut * spacing : face.depth;
      }
    }
  }
  prepared.held = planesOf(wanted, faces, false);
  return {};
}

std::string fillPrepared(PreparedSurface& prepared, double spacing, double cells,
  const WorkObserver& observer, CurvedTetrahedra& curved)
{
  MeshedSurface& wanted = prepared.wanted;
  TetrahedralMesh mesh;
  std::string fault;
  do
  {
    fault = fillSurface(wanted, cells, observer, mesh);
    wanted.deviation *= mesh.isTooRough && !wanted.isManifold ? RoughStep : 1.0;
    wanted.isManifold = wanted.isManifold && !mesh.isTooRough;
  } while (mesh.isTooRough && wanted.deviation < spacing);
  if (mesh.isTooRough)
  {
    return joined("The surface is rougher than Surface Spacing ", spacing,
      " mm can follow: smooth it, or give a larger one");
  }
  if (!fault.empty() || mesh.cells.empty())
  {
    return prefixed("Wrong input: ", fault);
  }
  const double volume = volumeOf(mesh);
  const double expected = prepared.closed.volume;
  if (!(std::abs(volume / expected - 1.0) < LostVolume))
  {
    return joined("The tetrahedra fill ", volume, " of the ", expected,
      " mm³ inside the surface: Surface Spacing ", spacing,
      " mm is too coarse for some part of it");
  }
  curved = curveTetrahedra(mesh, outsideReach(prepared.closed.surface, wanted, prepared.cuts));
  return {};
}
} // namespace palpate
