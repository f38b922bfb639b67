// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/GradedFilling.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "SolidResponse/Bodies/ChosenSpacing.h"
#include "SolidResponse/Mesher/MeshConversion.h"
#include "SolidResponse/Mesher/PreparedSurface.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace palpate
{
namespace
{
constexpr double InteriorRatio = 4.0;
constexpr double DeviationRatio = 0.05;

/// Number of cells per cube of the spacing, and peak memory per cell in bytes. Both were measured
/// on balls.
constexpr double CellsPerCube = 8.7;
constexpr double BytesPerCell = 2000.0;
/// Largest number of cells. Each cell has ten nodes, which are numbered by 32 bits.
constexpr double MostCells = std::numeric_limits<std::int32_t>::max() / 10.0;

constexpr double MeshedShare = 0.9; // fraction of the progress at the end of the meshing

/// Returns the expected number of cells of a body with given volume and area whose spacing grows
/// from s at the surface to l inside.
double expectedCells(const ClosedSurface& closed, double s, double l, double growth)
{
  const double graded =
    closed.area * (1.0 / (s * s) - 1.0 / (l * l)) / (2.0 * growth) + closed.volume / std::pow(l, 3);
  return CellsPerCube * std::min(graded, closed.volume / std::pow(s, 3));
}
} // namespace

double expectedBallCells(const FineBall& ball, double spacing, double growth)
{
  // The formula sums the ball and the shell in which the spacing u grows from s to l. The shell has
  // cells of volume u³ at r = R + (u - s)/growth.
  const double l = spacing;
  const double s = std::min(ball.spacing, l);
  const double b = growth * ball.radius - s;
  const auto primitive = [b](double u)
  { return std::log(u) - 2.0 * b / u - 0.5 * b * b / (u * u); };
  const double inside = std::pow(ball.radius / s, 3) / 3.0;
  const double around = (primitive(l) - primitive(s)) / std::pow(growth, 3);
  return CellsPerCube * 4.0 * vtkMath::Pi() * (inside + around);
}

std::string fillGraded(vtkPolyData* body, const GradedCells& cells, const WorkObserver& observer,
  vtkUnstructuredGrid* grid, GradedReport& report)
{
  HeldFaces faces{};
  PreparedSurface prepared;
  std::string fault = takeSurface(body, prepared);
  if (!fault.empty())
  {
    return fault;
  }
  const double spacing = cells.spacing > 0.0
    ? cells.spacing
    : chosenSpacing(prepared.closed.area, prepared.closed.volume);
  report.spacing = spacing;
  const double inside =
    cells.interiorSpacing > 0.0 ? cells.interiorSpacing : InteriorRatio * spacing;
  fault = readHeldFaces(cells.fixedFaces, 0.5 * spacing, faces);
  if (fault.empty() && inside < spacing)
  {
    fault = joined(
      "Interior Spacing must be 0 or at least Surface Spacing, ", spacing, " mm, but is ", inside);
  }
  if (!fault.empty())
  {
    return fault;
  }
  report.cells = expectedCells(prepared.closed, spacing, inside, cells.growth);
  for (const FineBall& ball : cells.balls)
  {
    report.cells += expectedBallCells(ball, spacing, cells.growth);
  }
  const double needed = BytesPerCell * report.cells;
  const double available = availableMemory();
  if (!(report.cells < MostCells) || needed > available)
  {
    return joined("Surface Spacing ", spacing, " mm",
      cells.balls.empty() ? "" : " with its Fine Balls", " makes about ", report.cells,
      " tetrahedra, which need about ", needed / Mebibyte, " MiB, but ", available / Mebibyte,
      " MiB are available, and more than ", MostCells, " are too many");
  }
  fault = mendAndCut(spacing, faces, prepared);
  report.warnings = prepared.warnings;
  if (!fault.empty())
  {
    return fault;
  }
  MeshedSurface& wanted = prepared.wanted;
  wanted.spacing.assign(static_cast<std::size_t>(wanted.points.cols()), spacing);
  wanted.balls = cells.balls;
  wanted.interiorSpacing = inside;
  wanted.growth = cells.growth;
  wanted.deviation = cells.deviation > 0.0 ? cells.deviation : DeviationRatio * spacing;
  CurvedTetrahedra curved;
  bool isStopped = false;
  const auto meshed = [&](double done)
  {
    isStopped = observer && !observer(MeshedShare * done);
    return !isStopped;
  };
  fault = fillPrepared(prepared, spacing, report.cells, meshed, curved);
  if (!fault.empty() || isStopped)
  {
    return fault;
  }
  convertTetrahedra(curved, grid);
  grid->GetPointData()->AddArray(holdFaces(grid, faces));
  return {};
}
} // namespace palpate
