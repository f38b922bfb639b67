// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSegmentedBody
 * @brief converts a labelled image to a body of tissues for vtkElasticContactResponse
 *
 * Input: a vtkImageData in mm whose point scalars (or array to process 0, one component) are labels
 * of tissues. The filter uses the direction matrix of the image. A table (AddTissue) assigns E and
 * ν to labels. Voxels with other labels are empty and outside the body. Therefore the label 0 needs
 * no row. Empty input gives empty output.
 *
 * The body consists of the voxels with a label of the table that are connected, through faces, with
 * the largest region of such voxels. A warning gives the fraction of the voxels that are left out.
 * The body is closed where the image ends. Empty regions inside the body remain, unless they are
 * smaller than a cube with a side of two SurfaceSpacings. The outer surface of the body is the
 * smoothed surface of these voxels.
 *
 * Output: a vtkUnstructuredGrid of VTK_QUADRATIC_TETRA cells with the point array `Fixed`, as in
 * vtkGradedBody, and the cell arrays `YoungsModulus` (MPa) and `PoissonRatio` of
 * vtkScannedMaterial. In cells that contain several tissues, the materials are mixed by volume.
 * Voxels outside the body have no effect. The field array `SourceSpacing` (one double, mm) is the
 * SourceSpacing for vtkElasticContactResponse. It is the length of the shortest cells at the
 * surface, or a larger value that limits the number of sources to about 2,500.
 *
 * **Size of the cells.** The length of the cells is SurfaceSpacing at the surface. Inside, half the
 * distance from the surface is added to this length, up to four times SurfaceSpacing. Around a
 * region of at least eight voxels that other tissues enclose, such as a lump, the cells are finer,
 * up to the surface above the region. Their length is half of the region's depth or radius,
 * whichever is smaller. The length is increased if all such regions together would add more than
 * 10,000 cells. The stated error of a response includes the effect of the length of the cells.
 *
 * These are errors without output: an empty table; an invalid row of the table (E must be positive
 * and finite, ν 0 to 0.499); a label that is given twice; a label that is not in the image (the
 * message lists the labels of the image); an image that has no scalars with one component or is not
 * three-dimensional; and the errors of vtkGradedBody, including a build without a mesher
 * (IsAvailable). Abort is checked between steps and while cells are created. Cost: 0.2 µs and 20
 * bytes per voxel of the box around the tissues, plus the cost of vtkGradedBody.
 *
 * @code{.py}
 * body = palpate.vtkSegmentedBody()
 * body.SetInputConnection(labels.GetOutputPort())      # vtkBodyFileReader of a .nii.gz
 * body.AddTissue(1, 0.006, 0.49)                       # label, E (MPa), ν
 * body.AddTissue(2, 0.06, 0.49)
 * felt = palpate.vtkElasticContactResponse()
 * felt.SetInputConnection(body.GetOutputPort())
 * felt.SetInputArrayToProcess(0, 0, 0, 1, "YoungsModulus")
 * felt.SetInputArrayToProcess(1, 0, 0, 1, "PoissonRatio")
 * @endcode
 *
 * @sa vtkElasticContactResponse vtkForceMap vtkScannedMaterial vtkGradedBody
 */
#ifndef vtkSegmentedBody_h
#define vtkSegmentedBody_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // For std::string
#include <vector> // For std::vector

class vtkDataArray;
class vtkImageData;

namespace palpate
{
struct GradedCells;
class SegmentedVoxels;
} // namespace palpate

class PALPATESOLIDRESPONSE_EXPORT vtkSegmentedBody : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSegmentedBody* New();
  vtkTypeMacro(vtkSegmentedBody, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns whether the module Mesher (libpalpateMesher.so, with CGAL) can be loaded. Without the
   * module, the filter cannot run.
   */
  static bool IsAvailable();

  ///@{
  /**
   * Adds a row of the table: a label of the image, and its E (MPa) and ν. The values are checked
   * when the filter runs.
   */
  void AddTissue(double label, double youngsModulus, double poissonRatio);
  void ClearTissues();
  int GetNumberOfTissues() { return static_cast<int>(this->Tissues.size()); }
  ///@}

  ///@{
  /**
   * Length of the cells' edges at the surface, mm. With the default 0, the length is chosen such
   * that the surface alone needs about 10,000 cells, but it is at most a sixth of the cube root of
   * the volume.
   */
  vtkSetMacro(SurfaceSpacing, double);
  vtkGetMacro(SurfaceSpacing, double);
  ///@}

  ///@{
  /** Sides of the bounding box that hold the body, as in vtkGradedBody. Default "z-". */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  /** Given or chosen SurfaceSpacing of the last run, mm; 0 before the first run. */
  vtkGetMacro(UsedSpacing, double);
  /** Number of enclosed regions with finer cells in the last run. */
  vtkGetMacro(NumberOfFineRegions, int);

protected:
  vtkSegmentedBody();
  ~vtkSegmentedBody() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkSegmentedBody(const vtkSegmentedBody&) = delete;
  void operator=(const vtkSegmentedBody&) = delete;

  /// A row of the table, with the values that the user gave.
  struct Row
  {
    double Label;
    double YoungsModulus;
    double PoissonRatio;
  };

  std::string CheckTissues() const;
  std::string Make(vtkImageData* image, vtkDataArray* values, vtkUnstructuredGrid* output);
  void ChooseCells(const palpate::SegmentedVoxels& voxels, palpate::GradedCells& cells);

  std::vector<Row> Tissues;
  double SurfaceSpacing = 0.0;
  std::string FixedFaces = "z-";
  double UsedSpacing = 0.0;
  int NumberOfFineRegions = 0;
};

#endif
