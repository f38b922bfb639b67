// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVoxelBody
 * @brief fills a closed surface with hexahedra, as a body for vtkElasticCompliance
 *
 * Input: a closed vtkPolyData of triangles that wind counter-clockwise as seen from outside, in mm.
 * Points at the same position count as one. These are errors: an open surface, an inverted surface,
 * and a surface that is too small for any voxel.
 *
 * Output: a vtkUnstructuredGrid of VTK_HEXAHEDRON cells. The core consists of voxels of a grid of
 * about Spacing (fitted to the bounding box) whose corners are all at least 0.4 Spacing below the
 * surface. If the core has several parts, only the largest part is kept, and a warning gives the
 * number of lost voxels. With Conform on (default), a layer of hexahedra, one on each outer face of
 * the core, extends from the core to the closest points of the surface, or to a sharp edge of the
 * surface (45°). Where this would distort a hexahedron too much, the layer ends slightly below the
 * surface. The outside is then as smooth as the surface, whereas voxels alone would have an edge at
 * every step. Sharp edges that are oblique to the grid are chamfered by up to one Spacing. With
 * Conform off, the output consists of the voxels whose corners are inside. The point array `Fixed`
 * (uint8) is 7 for points on each of the FixedFaces, 7 for all points within a given depth of a
 * side, and 0 elsewhere. The points on a side of FixedFaces are those of the outer faces that face
 * this side, within half a Spacing of the output's outermost point.
 *
 * Walls thinner than three Spacings are lost. Cost: about 20 µs per voxel of the bounding box, 40
 * bytes per grid point of the bounding box, and 310 bytes per voxel inside the body. A Spacing that
 * needs more than the available memory is an error. The result is the same on every run, with any
 * number of threads.
 *
 * @code{.py}
 * solid = palpate.vtkVoxelBody()
 * solid.SetInputConnection(surface.GetOutputPort())    # closed
 * solid.SetSpacing(5.0)                                # mm
 * solid.SetFixedFaces("z-:5")                          # the lowest 5 mm are held
 * solid.Update()
 * @endcode
 *
 * @sa vtkElasticCompliance
 */
#ifndef vtkVoxelBody_h
#define vtkVoxelBody_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // For std::string

class PALPATESOLIDRESPONSE_EXPORT vtkVoxelBody : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkVoxelBody* New();
  vtkTypeMacro(vtkVoxelBody, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Side length of the voxels, mm. With the default 0, it is chosen from the body: the cube root of
   * its volume divided by 10,000. For a ball of 140 mm diameter this is 5.2 mm.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Sides of the bounding box that hold the body: any of "x-", "x+", "y-", "y+", "z-", "z+",
   * separated by commas or blanks. Each side may have a depth in mm, as in "z-:5,x+". Without a
   * depth, the outer faces that face the side are held if they are within half a Spacing of the
   * outermost point. On a round bottom this is only a small part. Default "z-". With an empty text,
   * no side is held.
   */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  ///@{
  /** Whether a layer of hexahedra joins the voxels to the surface. Default on. */
  vtkSetMacro(Conform, bool);
  vtkGetMacro(Conform, bool);
  vtkBooleanMacro(Conform, bool);
  ///@}

  /**
   * Given or chosen side length of the voxels in the last run, mm; 0 if the surface was refused.
   */
  vtkGetMacro(UsedSpacing, double);

protected:
  vtkVoxelBody() = default;
  ~vtkVoxelBody() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkVoxelBody(const vtkVoxelBody&) = delete;
  void operator=(const vtkVoxelBody&) = delete;

  double Spacing = 0.0;
  double UsedSpacing = 0.0;
  std::string FixedFaces = "z-";
  bool Conform = true;
};

#endif
