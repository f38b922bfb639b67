// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkScannedMaterial
 * @brief finds E and ν of a volume mesh from a labelled image or a scan
 *
 * Input 0: a vtkUnstructuredGrid of VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and VTK_QUADRATIC_TETRA
 * cells in mm. Input 1: a vtkImageData in the same coordinates. Its values are the array to process
 * 0 of connection 1 (point data, one component), else the active point scalars. Empty input gives
 * empty output.
 *
 * Output: the grid with the cell arrays `YoungsModulus` (MPa) and `PoissonRatio` (doubles), which
 * vtkElasticContactResponse and vtkElasticCompliance read.
 *
 * A map (AddMaterial) assigns E and ν to values of the image. With Labels on (default), each value
 * is the number of a tissue and is read from the nearest voxel. A value that is not in the map is
 * an error. With Labels off, for elastography or CT numbers, the image is interpolated trilinearly.
 * log E and ν are interpolated linearly between the values of the map, and are constant beyond its
 * smallest and largest value. Outside the image, the constants YoungsModulus and PoissonRatio are
 * used.
 *
 * Each cell is sampled at Subdivisions³ points, which represent equal volumes in boxes and straight
 * tetrahedra. With Labels on, the most frequent material is mixed with the others. E is mixed
 * harmonically with harder materials and geometrically with softer materials
 * (palpate::mixedModulus). ν is the mean weighted by volume. With Labels off, log E and ν are
 * averaged. The relative error of the force equals the relative error of E, which for any map is at
 * least about ten per cent.
 *
 * These are errors without output: a missing map; an invalid row of the map (E must be positive and
 * finite, ν 0 to 0.499); a value that is given twice; a missing image or array; a value that is not
 * finite, or a label that is not in the map (the error gives the cell); and a cell of another type.
 * Abort is checked every 4,096 cells. Cost: 0.1 µs per sample point.
 *
 * @code{.py}
 * tissues = palpate.vtkScannedMaterial()
 * tissues.SetInputConnection(solid.GetOutputPort())
 * tissues.SetImageConnection(labels.GetOutputPort())   # an image of tissue numbers
 * tissues.AddMaterial(1, 0.035, 0.49)                  # number, E (MPa), ν: skin
 * tissues.AddMaterial(2, 50.0, 0.3)                    # skull
 * tissues.Update()
 * @endcode
 *
 * @sa vtkSegmentedBody vtkNoduleMaterial vtkGradedBody vtkElasticContactResponse
 */
#ifndef vtkScannedMaterial_h
#define vtkScannedMaterial_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // For std::string
#include <vector> // For std::vector

class vtkAlgorithmOutput;
class vtkImageData;

class PALPATESOLIDRESPONSE_EXPORT vtkScannedMaterial : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkScannedMaterial* New();
  vtkTypeMacro(vtkScannedMaterial, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Sets the image, input 1. */
  void SetImageConnection(vtkAlgorithmOutput* output);
  void SetImageData(vtkImageData* image);
  ///@}

  ///@{
  /**
   * Adds a row of the map: a value of the image, and its E (MPa) and ν. The values are checked when
   * the filter runs.
   */
  void AddMaterial(double value, double youngsModulus, double poissonRatio);
  void ClearMaterials();
  int GetNumberOfMaterials() { return static_cast<int>(this->Rows.size()); }
  ///@}

  ///@{
  /**
   * Whether the values of the image are labels of tissues (default) or quantities on a continuous
   * scale.
   */
  vtkSetMacro(Labels, bool);
  vtkGetMacro(Labels, bool);
  vtkBooleanMacro(Labels, bool);
  ///@}

  ///@{
  /** E (MPa) and ν (0 to 0.499) of cells outside the image. Defaults 0.1 and 0.45. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** Number of sample points along each side of a cell, 1 to 64. Default 4. */
  vtkSetMacro(Subdivisions, int);
  vtkGetMacro(Subdivisions, int);
  ///@}

protected:
  vtkScannedMaterial();
  ~vtkScannedMaterial() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkScannedMaterial(const vtkScannedMaterial&) = delete;
  void operator=(const vtkScannedMaterial&) = delete;

  /// A row of the map, with the values that the user gave.
  struct Row
  {
    double Value;
    double YoungsModulus;
    double PoissonRatio;
  };

  std::string CheckMap();
  std::string Map(vtkUnstructuredGrid* grid, vtkImageData* image, vtkUnstructuredGrid* output);

  std::vector<Row> Rows;
  bool Labels = true;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  int Subdivisions = 4;
};

#endif
