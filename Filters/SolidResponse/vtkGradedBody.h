// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGradedBody
 * @brief fills a closed surface with tetrahedra, fine at the surface and coarse inside, as a body
 * for vtkElasticContactResponse
 *
 * Input: a closed vtkPolyData of triangles that wind counter-clockwise as seen from outside, in mm.
 * Points at the same place count as one. Common defects of scans are repaired, with a warning.
 * Sheets that touch each other are separated, holes up to a fifth of the body are filled, and
 * triangles that cross each other are removed if they are fewer than a hundredth of all triangles.
 * These are errors: a wider hole, more crossings (the first are named), a surface that is inside
 * out, and a surface that loses a part because SurfaceSpacing is too coarse for it. The surface may
 * have several parts and cavities. If it was not closed, parts of less than a thousandth of the
 * triangles are left out.
 *
 * Output: a vtkUnstructuredGrid of VTK_QUADRATIC_TETRA cells. Their edges are about SurfaceSpacing
 * long at the surface, shorter where the distance of a facet from the surface would exceed
 * Deviation: √(8 Deviation R) at a curvature of 1/R. Inside, their length increases by Growth per
 * mm of distance from the surface, up to InteriorSpacing. In FineBalls they are shorter. Edges at
 * which the surface turns by more than 45° are kept, unless most of them are shorter than three
 * SurfaceSpacings, as on the noisy surface of a scan. Outer mid-edge nodes are on the true surface,
 * or on its sharp edges, except where the Jacobian of a tetrahedron would become too small: all
 * Jacobians are positive. Point array `Fixed` (uint8): 7 on each of the FixedFaces (the outer faces
 * that face that side, within half a SurfaceSpacing of the output's outermost point), 0 elsewhere.
 * A face with a given depth is cut off at that depth instead: the part that does not move is left
 * out of the output, and the points on the cut are held. Cells follow the rim of the cut, so that
 * the held region does not depend on the length of the cells. On a scan, whose edges are not kept,
 * cells do not follow the rim where it comes within a SurfaceSpacing of itself. If the surface
 * cannot be cut, because nothing would be left or the surface touches itself there, a warning is
 * given and all points within the depth are held.
 *
 * The mesher is CGAL's Mesh_3, under the GPL: in a build without CGAL (PALPATE_USE_CGAL) running
 * the filter is an error. The result is bit-identical on every run. Cost: on one thread 60 µs and 2
 * kB per cell; there are about 8.7 cells per SurfaceSpacing³ near the surface. If the cells need
 * more than the available memory, the filter reports an error before it starts. Progress is an
 * estimate. An abort takes effect within milliseconds during the refinement of the cells (nine
 * tenths of the work). During the removal of slivers it takes effect only at the end.
 *
 * @code{.py}
 * solid = palpate.vtkGradedBody()
 * solid.SetInputConnection(surface.GetOutputPort())    # closed
 * solid.SetSurfaceSpacing(3.0)                         # mm
 * solid.AddFineBall(0, 0, 50, 8, 1.0)                  # x, y, z, radius, spacing: mm
 * solid.SetFixedFaces("z-:2")                          # the lowest 2 mm are held
 * solid.Update()
 * @endcode
 *
 * @sa vtkElasticContactResponse vtkVoxelBody
 */
#ifndef vtkGradedBody_h
#define vtkGradedBody_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <array>  // For std::array
#include <string> // For std::string
#include <vector> // For std::vector

class vtkPolyData;
class vtkUnstructuredGrid;

class PALPATESOLIDRESPONSE_EXPORT vtkGradedBody : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGradedBody* New();
  vtkTypeMacro(vtkGradedBody, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Whether the module Mesher (libpalpateMesher.so, with CGAL) can be loaded. Without it the
   * filter cannot run. */
  static bool IsAvailable();

  ///@{
  /**
   * Length of the cells' edges at the surface, mm. 0 (default): chosen from the body, so that it
   * gets about 20,000 cells: √(8.7 area / 20,000), at most a sixth of the cube root of the volume.
   * On a ball of 140 mm diameter this is 5.2 mm.
   */
  vtkSetMacro(SurfaceSpacing, double);
  vtkGetMacro(SurfaceSpacing, double);
  ///@}

  ///@{
  /**
   * Length of the longest edges inside, mm, at least the spacing at the surface. 0 (default): four
   * times SurfaceSpacing.
   */
  vtkSetMacro(InteriorSpacing, double);
  vtkGetMacro(InteriorSpacing, double);
  ///@}

  ///@{
  /**
   * Increase of the edge length per mm of distance from the surface inwards: > 0, at most 2.
   * Default 0.5.
   */
  vtkSetMacro(Growth, double);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * Adds a ball in which edges are about `spacing` long, on the surface and inside. Outside the
   * ball they grow by Growth. Use a ball around a nodule, or where a tool is pressed. Centre,
   * radius >= 0 and spacing > 0 in mm; checked when the filter runs.
   */
  void AddFineBall(double x, double y, double z, double radius, double spacing);
  void ClearFineBalls();
  int GetNumberOfFineBalls() { return static_cast<int>(this->FineBalls.size()); }
  ///@}

  ///@{
  /** Largest distance of facets from the surface, mm. 0 (default): a twentieth of SurfaceSpacing,
   * which shortens edges where the surface's radius is below 2.5 SurfaceSpacings. If the surface is
   * so rough that several times as many cells would be needed, the deviation is increased up to
   * nine times. On such a surface, and where sheets of the surface nearly touch, the outside may
   * touch itself at a corner or an edge. */
  vtkSetMacro(Deviation, double);
  vtkGetMacro(Deviation, double);
  ///@}

  ///@{
  /** Sides of the bounding box that hold the body, as in vtkVoxelBody; a side with a depth, as
   * in "z-:5", is cut off. Default "z-". */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  /** The spacing at the surface of the last run, given or chosen, mm; 0 if the surface was refused.
   */
  vtkGetMacro(UsedSpacing, double);

  /** Number of cells expected for the last run; also set if the run was refused. */
  vtkGetMacro(CellEstimate, double);

protected:
  vtkGradedBody() = default;
  ~vtkGradedBody() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGradedBody(const vtkGradedBody&) = delete;
  void operator=(const vtkGradedBody&) = delete;

  std::string CheckProperties() const;
  std::string Fill(vtkPolyData* body, vtkUnstructuredGrid* output);

  double SurfaceSpacing = 0.0;
  double InteriorSpacing = 0.0;
  double Growth = 0.5;
  std::vector<std::array<double, 5>> FineBalls; ///< middle, radius, spacing
  double Deviation = 0.0;
  std::string FixedFaces = "z-";
  double CellEstimate = 0.0;
  double UsedSpacing = 0.0;
};

#endif
