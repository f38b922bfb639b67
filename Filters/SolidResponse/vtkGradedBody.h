// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGradedBody
 * @brief fills a closed surface with tetrahedra, fine at the surface and coarse inside, as a body
 * for vtkElasticContactResponse
 *
 * Input: a closed vtkPolyData of triangles that wind counter-clockwise as seen from outside, in mm.
 * Points at the same position count as one. Common defects of scans are repaired, with a warning.
 * Sheets that touch each other are separated, holes up to a fifth of the body are filled, and
 * triangles that cross each other are removed if they are fewer than a hundredth of all triangles.
 * These are errors: a wider hole; more crossing triangles (the error names the first of them); a
 * surface that is inside out; and a surface that would lose a part because SurfaceSpacing is too
 * coarse. The surface may have several parts and cavities. If it was not closed, parts with less
 * than a thousandth of the triangles are left out.
 *
 * Output: a vtkUnstructuredGrid of VTK_QUADRATIC_TETRA cells. At the surface, their edges are about
 * SurfaceSpacing long. The edges are shorter where the distance of a facet from the surface would
 * otherwise exceed Deviation; at a curvature of 1/R their length is then √(8 Deviation R). Inside,
 * the length increases by Growth per mm of distance from the surface, up to InteriorSpacing. In
 * FineBalls the edges are shorter. Edges of the surface with a dihedral angle of more than 45° are
 * kept, unless most of them are shorter than three SurfaceSpacings, as on the noisy surface of a
 * scan. Outer mid-edge nodes are on the true surface, or on its sharp edges, except where the
 * Jacobian of a tetrahedron would become too small. All Jacobians are positive. The point array
 * `Fixed` (uint8) is 7 on each of the FixedFaces and 0 elsewhere. The points on a side of
 * FixedFaces are those of the outer faces that face this side, within half a SurfaceSpacing of the
 * output's outermost point. If a side has a depth, the body is instead cut off at this depth. The
 * output does not contain the part that is cut off, which does not move, and the points on the cut
 * are held. Cells follow the rim of the cut, so that the held region does not depend on the length
 * of the cells. On a scan, whose edges are not kept, cells do not follow the rim at places where
 * two parts of the rim are less than one SurfaceSpacing apart. If the surface cannot be cut,
 * because nothing would be left or the surface touches itself there, a warning is given and all
 * points within the depth are held.
 *
 * The mesher is CGAL's Mesh_3, which is under the GPL. In a build without CGAL (PALPATE_USE_CGAL),
 * running the filter is an error. The result is bit-identical on every run. Cost: 60 µs on one
 * thread and 2 kB per cell. There are about 8.7 cells per SurfaceSpacing³ near the surface. If the
 * cells need more than the available memory, the filter reports an error before it starts. Progress
 * is an estimate. An abort takes effect within milliseconds during the refinement of the cells
 * (nine tenths of the work). During the removal of slivers it takes effect only at the end.
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

  /**
   * Returns whether the module Mesher (libpalpateMesher.so, with CGAL) can be loaded. Without the
   * module, the filter cannot run.
   */
  static bool IsAvailable();

  ///@{
  /**
   * Length of the cells' edges at the surface, mm. With the default 0, the length is chosen from
   * the size of the body, so that the body gets about 20,000 cells. It is √(8.7 area / 20,000), but
   * at most a sixth of the cube root of the volume. For a ball of 140 mm diameter this is 5.2 mm.
   */
  vtkSetMacro(SurfaceSpacing, double);
  vtkGetMacro(SurfaceSpacing, double);
  ///@}

  ///@{
  /**
   * Length of the longest edges inside the body, mm, at least the spacing at the surface. The
   * default 0 selects four times SurfaceSpacing.
   */
  vtkSetMacro(InteriorSpacing, double);
  vtkGetMacro(InteriorSpacing, double);
  ///@}

  ///@{
  /**
   * Increase of the edge length per mm of distance from the surface inwards, > 0 and at most 2.
   * Default 0.5.
   */
  vtkSetMacro(Growth, double);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * Adds a ball in which edges are about `spacing` long, on the surface and inside. Outside the
   * ball, the length increases by Growth. Use a ball around a nodule, or where a tool is pressed.
   * Centre, radius (>= 0) and spacing (> 0) are in mm. They are checked when the filter runs.
   */
  void AddFineBall(double x, double y, double z, double radius, double spacing);
  void ClearFineBalls();
  int GetNumberOfFineBalls() { return static_cast<int>(this->FineBalls.size()); }
  ///@}

  ///@{
  /**
   * Largest distance of facets from the surface, mm. The default 0 selects a twentieth of
   * SurfaceSpacing. This shortens edges where the radius of curvature of the surface is below 2.5
   * SurfaceSpacings. If the surface is so rough that several times as many cells would be needed,
   * the deviation is increased up to nine times. On such a surface, and where sheets of the surface
   * nearly touch, the outside may touch itself at a corner or an edge.
   */
  vtkSetMacro(Deviation, double);
  vtkGetMacro(Deviation, double);
  ///@}

  ///@{
  /**
   * Sides of the bounding box that hold the body, as in vtkVoxelBody. A side with a depth, as in
   * "z-:5", is cut off at this depth. Default "z-".
   */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  /** Given or chosen spacing at the surface in the last run, mm; 0 if the surface was refused. */
  vtkGetMacro(UsedSpacing, double);

  /** Number of cells expected for the last run. It is also set if the run was refused. */
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
  /// Centre (x, y, z), radius and spacing of each ball, mm.
  std::vector<std::array<double, 5>> FineBalls;
  double Deviation = 0.0;
  std::string FixedFaces = "z-";
  double CellEstimate = 0.0;
  double UsedSpacing = 0.0;
};

#endif
