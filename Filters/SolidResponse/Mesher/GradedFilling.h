// SPDX-License-Identifier: BSD-3-Clause
#ifndef GradedFilling_h
#define GradedFilling_h

#include "Mechanics/SharedWork.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace palpate
{
/// The cells that fill a closed surface. The members correspond to the properties of vtkGradedBody.
struct GradedCells
{
  /// Spacing at the surface, mm. If it is 0, chosenSpacing() chooses the spacing.
  double spacing = 0.0;
  double interiorSpacing = 0.0; ///< mm; 0 means four times `spacing`
  double growth = 0.5;
  double deviation = 0.0; ///< mm; 0 means a twentieth of `spacing`
  std::vector<FineBall> balls;
  std::string fixedFaces = "z-";
};

/// Spacing, expected number of cells, and warnings about repairs of the surface. Spacing and number
/// are also set if there would be too many cells.
struct GradedReport
{
  double spacing = 0.0; ///< given or chosen spacing at the surface, mm
  double cells = 0.0;
  std::vector<std::string> warnings;
};

/// Returns the number of cells that a ball with finer cells is expected to add. `spacing` is the
/// spacing of the cells at the surface, mm. `growth` is the increase of the spacing per mm of
/// distance from the surface.
double expectedBallCells(const FineBall& ball, double spacing, double growth);

/// Fills the surface with quadratic tetrahedra and adds the point array `Fixed`. Returns "" or an
/// error message. `grid` is empty if the observer stopped the work.
std::string fillGraded(vtkPolyData* body, const GradedCells& cells, const WorkObserver& observer,
  vtkUnstructuredGrid* grid, GradedReport& report);
} // namespace palpate

#endif
