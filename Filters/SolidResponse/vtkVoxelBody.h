// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVoxelBody
 * @brief fills a closed surface with hexahedra, as a body for vtkElasticCompliance
 *
 * Input: a closed vtkPolyData of triangles that wind counter-clockwise seen from outside, in mm;
 * points at the same place count as one. An open surface, an inverted one, and one too small for
 * any voxel are errors.
 *
 * Output: a vtkUnstructuredGrid of VTK_HEXAHEDRON cells. The core consists of voxels of a grid of
 * about Spacing (fitted to the bounding box) whose corners all lie at least 0.4 Spacing inside; of
 * several parts only the largest is kept, and a warning tells how many voxels are left out. With
 * Conform on (default) a layer of hexahedra, one on each outer face of the core, reaches from there
 * to the closest points of the surface, or to a sharp edge of it (45°); where that would spoil a
 * hexahedron it stays a little below. The outside is then as smooth as the surface, while a
 * staircase of voxels has an edge at every step; sharp edges across the grid are chamfered by up to
 * a Spacing. With Conform off the output is the voxels whose corners lie inside. Point array
 * `Fixed` (uint8): 7 on each of the FixedFaces - the outer faces that look to that side, within
 * half a Spacing of the output's outermost point - and for all points within a given depth, 0
 * elsewhere.
 *
 * Walls thinner than three Spacings are lost. Cost: about 20 µs per voxel of the bounding box, 40
 * bytes per point of it and 310 per voxel inside; a Spacing that needs more than the available
 * memory is an error. The same on every run, with any number of threads.
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
  /** Side of the voxels, mm, > 0. Default 2. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Which sides of the bounding box hold the body: any of "x-", "x+", "y-", "y+", "z-", "z+",
   * separated by commas or blanks, each with a depth in mm where that is not half a Spacing, as in
   * "z-:5,x+" (a round bottom stands on little else). Default "z-"; empty: none.
   */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  ///@{
  /** Whether a layer joins the voxels to the surface. Default on. */
  vtkSetMacro(Conform, bool);
  vtkGetMacro(Conform, bool);
  vtkBooleanMacro(Conform, bool);
  ///@}

protected:
  vtkVoxelBody() = default;
  ~vtkVoxelBody() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkVoxelBody(const vtkVoxelBody&) = delete;
  void operator=(const vtkVoxelBody&) = delete;

  double Spacing = 2.0;
  std::string FixedFaces = "z-";
  bool Conform = true;
};

#endif
