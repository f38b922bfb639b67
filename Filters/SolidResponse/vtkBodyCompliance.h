// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkBodyCompliance
 * @brief computes the global compliance of a closed body at each point of its surface within
 *   seconds
 *
 * Input: a closed vtkPolyData of triangles, mm, as for vtkGradedBody. It is the surface of a solid
 * body of one material. Empty input gives empty output.
 *
 * Output: the same surface with its arrays and
 * - `GlobalCompliance` (double, mm/N): the compliance C in series with the law of a tool on a
 *   half-space, δ = δ_local(F) + C F. Use it as the array to process 2 of vtkToolContactResponse. C
 *   is negative where a near support stiffens the contact, and positive near edges and on thin
 *   parts;
 * - `GlobalComplianceError` (double, mm/N, >= 0): error of C. vtkToolContactResponse finds the
 *   array by its name and includes it in the error of the force;
 * - `ComplianceStatus` (uint8): 0 Valid; 4 OutOfReach: the point is held; 5 Edge and 1 Degenerate:
 *   C is not known. If the status is not 0, C is 0, and its error is the compliance of a contact of
 *   ContactRadius on a half-space.
 * - `GlobalMode0`... `GlobalMode5` (float 3, sqrt(mm/N)) and the field array `GlobalModeSign`
 *   (int8): the motion of the whole body under a force at any point, as in vtkElasticCompliance.
 *   vtkContactDeflection and vtkToolTouch use the modes to bend the body; no force depends on the
 *   modes.
 *
 * **Method.** The surface is filled with at most about NumberOfCells quadratic tetrahedra
 * (vtkGradedBody) and held at FixedFaces. The finite elements give the regular part H of the Green
 * function at some of the surface points (vtkElasticContactResponse). C at a point is the mean of
 * H, weighted by the pressure of a round tool with ContactRadius. H is interpolated from the
 * nearest solved points with a similar normal. A second filling with cells twice as long gives the
 * error due to the elements. The error also includes that of the interpolation. One C is used for
 * all tools and depths. The error includes the resulting differences between a round and a flat
 * tool, and between ContactRadius and a small contact.
 *
 * The compliance is that of a held body, but the surface does not show where the body is held. By
 * default it is held at the side of its bounding box with the largest supporting area (GetHeldAt).
 * C includes neither the shape of the tool nor large strain, because both are part of the local
 * law.
 *
 * **Cost.** About ten seconds on two cores for 10⁵ triangles; the solutions take most of this time.
 * Later runs on the same surface read the solutions from the cache (SolutionCache.h), also for
 * contact radii down to an eighth of the first one. The filter uses as many threads as vtkSMPTools.
 * The result is bit-identical for any number of threads. Abort is checked between steps and
 * solutions. The filter needs the modules Solids and Mesher.
 *
 * **Limits.** The error is valid only where the series of the kernel converges. It is not valid
 * where the contact is wider than its distance from an edge, a crease or the held part. Compared
 * with direct contact, the force was within its stated error at 74 of 77 random places of a bunny
 * (validation.md). A part of the body that is not held is an error.
 *
 * Error messages name the property or the input. These are errors: a surface that is open, inside
 * out or too thin for its cells; an unknown side; and a Poisson's ratio above 0.499.
 *
 * @code{.py}
 * compliance = palpate.vtkBodyCompliance()
 * compliance.SetInputConnection(surface.GetOutputPort())  # closed
 * compliance.SetYoungsModulus(0.05)                    # MPa
 * compliance.SetFixedFaces("z-")                       # the lowest side holds the body
 * response.SetInputConnection(compliance.GetOutputPort())
 * response.SetInputArrayToProcess(2, 0, 0, 0, "GlobalCompliance")
 * @endcode
 *
 * @sa vtkToolContactResponse vtkElasticCompliance vtkElasticContactResponse
 */
#ifndef vtkBodyCompliance_h
#define vtkBodyCompliance_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

class PALPATESOLIDRESPONSE_EXPORT vtkBodyCompliance : public vtkPolyDataAlgorithm
{
public:
  static vtkBodyCompliance* New();
  vtkTypeMacro(vtkBodyCompliance, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Young's modulus E of the body, MPa, > 0. C is proportional to 1/E. Default 0.1. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  ///@}

  ///@{
  /** Poisson's ratio of the body, 0 to 0.499. Default 0.45. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /**
   * Radius of the contact for which C is exact, mm, > 0. Use the contact radius of the tool at its
   * largest depth (vtkContactTool::GetContactRadius). Default 2.
   */
  vtkSetMacro(ContactRadius, double);
  vtkGetMacro(ContactRadius, double);
  ///@}

  ///@{
  /**
   * Sides of the bounding box that hold the body, as in vtkGradedBody. The default "" selects the
   * side with the largest supporting area, see GetHeldAt.
   */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  ///@{
  /**
   * Approximate upper limit of the number of cells, >= 100. More cells give a smaller error. The
   * cost is proportional to the number of cells to the power of 1.5. Default 12000.
   */
  vtkSetMacro(NumberOfCells, int);
  vtkGetMacro(NumberOfCells, int);
  ///@}

  /// Sides at which the body was held in the last run, as in FixedFaces; "" before the first run.
  vtkGetMacro(HeldAt, std::string);

protected:
  vtkBodyCompliance() = default;
  ~vtkBodyCompliance() override = default;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkBodyCompliance(const vtkBodyCompliance&) = delete;
  void operator=(const vtkBodyCompliance&) = delete;

  std::string Attach(vtkPolyData* body, vtkPolyData* output);

  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double ContactRadius = 2.0;
  std::string FixedFaces;
  int NumberOfCells = 12000;
  std::string HeldAt;
};

#endif
