// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSegmentedBody
 * @brief a labelled image as a body of tissues for vtkElasticContactResponse
 *
 * Input: a vtkImageData in mm whose point scalars (or array to process 0, one component) are labels
 * of tissues. Its direction matrix is used. A table (AddTissue) assigns E and ν to labels. Voxels
 * with other labels are empty and outside the body; 0 therefore needs no row. Empty input gives
 * empty output.
 *
 * The body consists of the voxels with a label of the table that are connected, through faces, with
 * the largest region of such voxels. A warning names the fraction that is left out. The body is
 * closed where the image ends. Empty regions inside it remain, unless they are smaller than a cube
 * of two SurfaceSpacings. Its outside is the smoothed surface of these voxels.
 *
 * Output: a vtkUnstructuredGrid of VTK_QUADRATIC_TETRA cells with the point array `Fixed`, as in
 * vtkGradedBody, and the cell arrays `YoungsModulus` (MPa) and `PoissonRatio` of
 * vtkScannedMaterial. Cells that hold several tissues are mixed by volume. Voxels outside the body
 * have no effect. The field array `SourceSpacing` (one double, mm) is that of
 * vtkElasticContactResponse: the length of the shortest cells at the surface, or a larger value so
 * that there are no more than about 2,500 sources.
 *
 * **Size of the cells.** The length is SurfaceSpacing at the surface. Inside, half the distance
 * from the surface is added to it, up to four times SurfaceSpacing. In the ball around a region of
 * at least eight voxels that other tissues enclose, such as a lump, and up to the surface above it,
 * the length is half of the region's depth or radius, whichever is smaller. It is increased if all
 * such balls together would add more than 10,000 cells. The stated error of a response includes the
 * effect of the length of the cells.
 *
 * These are errors without output: no row in the table; a wrong row (E must be positive and finite,
 * ν 0 to 0.499); a label that is given twice; a label that is not in the image (the message lists
 * those that are); an image without such scalars or without three dimensions; the errors of
 * vtkGradedBody, including a build without a mesher (IsAvailable). Abort is checked between steps
 * and while cells are made. Cost: 0.2 µs and 20 bytes per voxel of the box around the tissues, and
 * that of vtkGradedBody.
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

  /** Whether the module Mesher (libpalpateMesher.so, with CGAL) can be loaded. Without it the
   * filter cannot run. */
  static bool IsAvailable();

  ///@{
  /** Adds a row of the table: a label of the image, its E, MPa, and its ν. The values are checked
   * when the filter runs. */
  void AddTissue(double label, double youngsModulus, double poissonRatio);
  void ClearTissues();
  int GetNumberOfTissues() { return static_cast<int>(this->Tissues.size()); }
  ///@}

  ///@{
  /** Length of the cells' edges at the surface, mm. 0 (default): chosen so that the surface alone
   * needs about 10,000 cells, but at most a sixth of the cube root of the volume. */
  vtkSetMacro(SurfaceSpacing, double);
  vtkGetMacro(SurfaceSpacing, double);
  ///@}

  ///@{
  /** Sides of the bounding box that hold the body, as in vtkGradedBody. Default "z-". */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  /** SurfaceSpacing of the last run, mm, given or chosen; 0 before the first run. */
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

  /// A row of the table as given by the user.
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
