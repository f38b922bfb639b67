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
/// The cells that fill a closed surface, as the properties of vtkGradedBody describe them.
struct GradedCells
{
  /// Spacing at the surface, mm; 0: the spacing is chosen by chosenSpacing().
  double spacing = 0.0;
  double interiorSpacing = 0.0; ///< mm; 0: four times `spacing`
  double growth = 0.5;
  double deviation = 0.0; ///< mm; 0: a twentieth of `spacing`
  std::vector<FineBall> balls;
  std::string fixedFaces = "z-";
};

/// Spacing and expected number of cells, also set if there would be too many cells, and warnings
/// about repairs of the surface.
struct GradedReport
{
  double spacing = 0.0; ///< the spacing at the surface, given or chosen, mm
  double cells = 0.0;
  std::vector<std::string> warnings;
};

/// Returns the number of cells that a ball with finer cells is expected to add. `spacing`: that of
/// the cells at the surface, mm. `growth`: increase of the spacing per mm of distance from the
/// surface.
double expectedBallCells(const FineBall& ball, double spacing, double growth);

/// Fills the surface with quadratic tetrahedra and the point array `Fixed`. Returns "", or a
/// message about the fault. `grid` is empty if the observer stopped the work.
std::string fillGraded(vtkPolyData* body, const GradedCells& cells, const WorkObserver& observer,
  vtkUnstructuredGrid* grid, GradedReport& report);
} // namespace palpate

#endif
