// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNoduleMaterial
 * @brief adds spheres of another material to a volume mesh
 *
 * Input: a vtkUnstructuredGrid of VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and VTK_QUADRATIC_TETRA
 * cells in mm. E and ν of the tissue around the nodules are taken from the arrays to process 0 and
 * 1 (cell data, one component) or, without arrays, from the constants. Empty input gives empty
 * output.
 *
 * Output: the same grid with the cell arrays (doubles)
 * - `YoungsModulus` (MPa) and `PoissonRatio`: with the nodules;
 * - `YoungsModulusWithout` and `PoissonRatioWithout`: without the nodules;
 * - `NoduleFraction`: the fraction of the cell's volume that nodules fill, 0 to 1.
 *
 * In a cell that is cut by the surface of a sphere, the materials are mixed according to their
 * volume fractions, which are counted at Subdivisions³ points of the cell. palpate::mixedModulus
 * mixes E, harmonically for a harder nodule and geometrically for a softer nodule. ν is the mean
 * weighted by volume. Where spheres overlap, the sphere that was added last determines the
 * material.
 *
 * **Accuracy.** The error of the force on a nodule of 3 mm, which is ten times as hard as the
 * tissue, in cells of 1 mm, is 1.5 % if the nodule is 2 mm or more below the surface, and 4 % if it
 * is 1 mm below. Cells should be no larger than half the distance of a nodule's top from the
 * surface, and no larger than a third of the nodule's radius.
 *
 * These are errors without output: a radius, E or ν of a nodule that is out of range (E must be
 * positive and finite, ν 0 to 0.499), or a nodule that fills no part of any cell (the error gives
 * the number of the nodule); an invalid array, or an invalid value in an array; and a cell of
 * another type.
 *
 * Cost: Subdivisions³ distances for each cell whose bounding box intersects the surface of a
 * sphere. For ten thousand cells this takes milliseconds.
 *
 * @code{.py}
 * material = palpate.vtkNoduleMaterial()
 * material.SetInputConnection(solid.GetOutputPort())
 * material.SetYoungsModulus(0.05)                      # MPa
 * material.AddNodule(0, 0, 42, 4, 0.5)                 # x, y, z, radius (mm), modulus (MPa)
 * material.Update()
 * @endcode
 *
 * @sa vtkNoduleDetectability vtkElasticContactResponse
 */
#ifndef vtkNoduleMaterial_h
#define vtkNoduleMaterial_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <array>  // For std::array
#include <string> // For std::string
#include <vector> // For std::vector

namespace palpate
{
struct ElasticMaterial;
}

class PALPATESOLIDRESPONSE_EXPORT vtkNoduleMaterial : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkNoduleMaterial* New();
  vtkTypeMacro(vtkNoduleMaterial, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** E around the nodules, MPa. It is used if there is no array of E. Default 0.1. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  ///@}

  ///@{
  /** ν around the nodules, 0 to 0.499. It is used if there is no array of ν. Default 0.45. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /**
   * Adds a sphere with centre and radius in mm, E in MPa, and ν. Without ν, the Poisson's ratio is
   * that of the tissue around the sphere. The values are checked when the filter runs.
   */
  void AddNodule(double x, double y, double z, double radius, double youngsModulus);
  void AddNodule(
    double x, double y, double z, double radius, double youngsModulus, double poissonRatio);
  ///@}
  void ClearNodules();
  int GetNumberOfNodules() { return static_cast<int>(this->Nodules.size()); }

  ///@{
  /**
   * Number of sample points along each side of a cell that is cut by the surface of a sphere, 1 to
   * 64. Default 8.
   */
  vtkSetMacro(Subdivisions, int);
  vtkGetMacro(Subdivisions, int);
  ///@}

protected:
  vtkNoduleMaterial() = default;
  ~vtkNoduleMaterial() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkNoduleMaterial(const vtkNoduleMaterial&) = delete;
  void operator=(const vtkNoduleMaterial&) = delete;

  /// A sphere, with the values that the user gave.
  struct Nodule
  {
    std::array<double, 3> Middle;
    double Radius;
    double YoungsModulus;
    double PoissonRatio;
    bool HasPoissonRatio;
  };

  std::string Check();
  /// Mixes the materials of the nodules, which fill `fractions` of a cell, with the material of the
  /// cell. Returns the fraction of the cell that all nodules fill together.
  double MixCell(const std::vector<double>& fractions, palpate::ElasticMaterial& material) const;
  std::string Mix(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* output);

  std::vector<Nodule> Nodules;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  int Subdivisions = 8;
};

#endif
