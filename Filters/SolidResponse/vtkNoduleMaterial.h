// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNoduleMaterial
 * @brief spheres of another material in a volume mesh
 *
 * Input: a vtkUnstructuredGrid of VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and VTK_QUADRATIC_TETRA
 * cells in mm. E and ν of the tissue around the nodules come from arrays to process 0 and 1 (cell
 * data, one component) or, without arrays, from the constants. Empty input gives empty output.
 *
 * Output: the same grid with the cell arrays (doubles)
 * - `YoungsModulus` (MPa) and `PoissonRatio`: with the nodules;
 * - `YoungsModulusWithout` and `PoissonRatioWithout`: without the nodules;
 * - `NoduleFraction`: the fraction of the cell's volume that nodules fill, 0 to 1.
 *
 * In a cell that is cut by the surface of a sphere, the materials are mixed by their fractions of
 * the volume, counted at Subdivisions³ points of the cell. E is mixed by palpate::mixedModulus,
 * harmonically for a harder nodule and geometrically for a softer one; ν is mixed by volume. Where
 * spheres overlap, the sphere that was added last determines the material.
 *
 * **Accuracy.** Error of the force on a nodule of 3 mm, ten times as hard, in cells of 1 mm: 1.5 %
 * at a depth of 2 mm or more, 4 % at 1 mm. Cells should be no larger than half the distance of a
 * nodule's top from the surface, and no larger than a third of its radius.
 *
 * These are errors without output: a wrong radius, E or ν (E positive and finite, ν 0 to 0.499), or
 * a nodule that fills no part of any cell, with its number; a wrong array or a wrong value in it; a
 * cell of another kind.
 *
 * Cost: Subdivisions³ distances for each cell whose box a sphere's surface cuts, milliseconds for
 * ten thousand cells.
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
  /** E around the nodules, MPa, used if there is no array. Default 0.1. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  ///@}

  ///@{
  /** ν around the nodules, 0 to 0.499, used if there is no array. Default 0.45. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /**
   * Adds a sphere: centre and radius in mm, E in MPa, and ν. Without ν, its Poisson's ratio is that
   * of the tissue around it. The values are checked when the filter runs.
   */
  void AddNodule(double x, double y, double z, double radius, double youngsModulus);
  void AddNodule(
    double x, double y, double z, double radius, double youngsModulus, double poissonRatio);
  ///@}
  void ClearNodules();
  int GetNumberOfNodules() { return static_cast<int>(this->Nodules.size()); }

  ///@{
  /**
   * Number of sample points along each side of a cell that is cut by a sphere's surface, 1 to 64.
   * Default 8.
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

  /// A sphere as given by the user.
  struct Nodule
  {
    std::array<double, 3> Middle;
    double Radius;
    double YoungsModulus;
    double PoissonRatio;
    bool HasPoissonRatio;
  };

  std::string Check();
  /// Mixes the nodules, which fill `fractions` of a cell, into its material. Returns the fraction
  /// of the cell that all nodules fill together.
  double MixCell(const std::vector<double>& fractions, palpate::ElasticMaterial& material) const;
  std::string Mix(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* output);

  std::vector<Nodule> Nodules;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  int Subdivisions = 8;
};

#endif
