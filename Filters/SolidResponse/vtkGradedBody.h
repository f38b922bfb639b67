// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGradedBody
 * @brief fills a closed surface with tetrahedra, fine at the surface and coarse inside, as a body
 * for vtkElasticContactResponse
 *
 * Input: a closed vtkPolyData of triangles that wind counter-clockwise seen from outside, in mm;
 * points at the same place count as one. Common defects of scans are repaired, with a warning:
 * sheets that touch each other are separated, holes up to a fifth of the body are filled, and
 * triangles that cross each other are removed if they are fewer than a hundredth. A wider hole,
 * more crossings (the first are named), a surface that is inside out, and one that loses a part
 * because SurfaceSpacing is too coarse for it, are errors. There may be several parts and cavities;
 * if the surface was not closed, parts of less than a thousandth of the triangles are left out.
 *
 * Output: a vtkUnstructuredGrid of VTK_QUADRATIC_TETRA cells. Their edges are about SurfaceSpacing
 * long at the surface, shorter where a facet would lie more than Deviation off it: √(8 Deviation R)
 * where it is curved by 1/R. Inside they grow by Growth per distance from the surface, to
 * InteriorSpacing. In FineBalls they are shorter. Edges by which the surface turns more than 45°
 * are kept, unless most of them are shorter than three SurfaceSpacings, as the noise of a scan is.
 * Mid-edge nodes of the outside lie on the true surface, or its sharp edges, except where that
 * would spoil a tetrahedron: all Jacobians are positive. Point array `Fixed` (uint8): 7 on each of
 * the FixedFaces - the outer faces that look to that side, within half a SurfaceSpacing of the
 * output's outermost point - 0 elsewhere. One of a given depth is cut off there instead: what does
 * not move is no part of the output, and points are held on the cut. Cells follow its rim, so that
 * what is held does not depend on their size; on a scan, whose edges are not kept, except where the
 * rim comes within a SurfaceSpacing to itself. A surface that cannot be cut - nothing would be
 * left, or it touches itself there - gets a warning, and is held within the depth.
 *
 * The mesher is CGAL's Mesh_3, under the GPL: in a build without CGAL (PALPATE_USE_CGAL) running
 * the filter is an error. The same bits on every run. Cost: on one thread 60 µs and 2 kB per cell,
 * of which there are about 8.7 per SurfaceSpacing³ beside the surface; if that is more than the
 * available memory, it is an error beforehand. Progress is an estimate; an abort is seen within
 * milliseconds while cells are refined, nine tenths of the work, and only at the end while slivers
 * are moved apart.
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

  /** Whether the module Mesher (libpalpateMesher.so, with CGAL) can be loaded. Without it nothing
   * is filled. */
  static bool IsAvailable();

  ///@{
  /** Length of the cells' edges at the surface, mm, > 0. Default 2. */
  vtkSetMacro(SurfaceSpacing, double);
  vtkGetMacro(SurfaceSpacing, double);
  ///@}

  ///@{
  /** The longest edges inside, mm: at least SurfaceSpacing, or 0 (default): four times that. */
  vtkSetMacro(InteriorSpacing, double);
  vtkGetMacro(InteriorSpacing, double);
  ///@}

  ///@{
  /** How much longer edges get per length from the surface inwards: > 0, at most 2. Default 0.5. */
  vtkSetMacro(Growth, double);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * Adds a ball within which edges are about `spacing` long, on the surface and inside, and from
   * which they grow by Growth: around a nodule, or where a tool is pressed. Centre, radius >= 0 and
   * spacing > 0 in mm; checked when the filter runs.
   */
  void AddFineBall(double x, double y, double z, double radius, double spacing);
  void ClearFineBalls();
  int GetNumberOfFineBalls() { return static_cast<int>(this->FineBalls.size()); }
  ///@}

  ///@{
  /** How far facets may lie off the surface, mm, or 0 (default): a twentieth of SurfaceSpacing,
   * which shortens edges where the surface's radius is below two and a half SurfaceSpacings; up to
   * nine times that on a surface whose roughness would take several times the cells. There, and
   * where sheets of the surface nearly touch, the outside may meet itself at a corner or an edge.
   */
  vtkSetMacro(Deviation, double);
  vtkGetMacro(Deviation, double);
  ///@}

  ///@{
  /** Which sides of the bounding box hold the body, as in vtkVoxelBody; one with a depth, as in
   * "z-:5", is cut off. Default "z-". */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  /** How many cells the last run expected, known also after it was refused. */
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

  double SurfaceSpacing = 2.0;
  double InteriorSpacing = 0.0;
  double Growth = 0.5;
  std::vector<std::array<double, 5>> FineBalls; ///< middle, radius, spacing
  double Deviation = 0.0;
  std::string FixedFaces = "z-";
  double CellEstimate = 0.0;
};

#endif
