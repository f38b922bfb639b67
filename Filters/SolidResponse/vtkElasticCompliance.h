// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkElasticCompliance
 * @brief computes the global compliance of a body at each point of its surface with finite elements
 *
 * Input: a vtkUnstructuredGrid of VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and VTK_QUADRATIC_TETRA
 * cells in mm, with the point array `Fixed` (one component; the bits 1, 2, 4 hold a point along x,
 * y, z). Cells are connected by shared points. These are errors, and the message names cell and
 * value: a cell of another type, an inverted cell, a part of the body that can move freely in spite
 * of its fixed points, and E or ν out of range. Empty input gives empty output.
 *
 * Output: the body's outer surface, including inner cavities, as triangles (quadrilaterals are
 * split in two, quadratic faces in four), with the input's point arrays and
 * - `GlobalCompliance` (double, mm/N): the compliance C_g in series with the law of a tool on a
 *   half-space, δ = δ_local(F) + C_g F. Use it as the array to process 2 of vtkToolContactResponse.
 *   C_g is negative where a near support stiffens the contact;
 * - `ComplianceStatus` (uint8): 0 Valid; 5 Edge: the normal of the surface varies by more than 30°
 *   under the patch; 4 OutOfReach: the patch covers fixed points; 1 Degenerate. Where the status is
 *   not 0, the compliance is interpolated from the six nearest valid points along the surface,
 *   weighted by 1/distance². It is NaN in a part of the surface without valid points;
 * - `GlobalComplianceError` (double, mm/N, >= 0): error of C_g due to the elements
 *   (palpate::complianceErrors, estimated from about ten points). It is at least |C_g| where C_g is
 *   interpolated. vtkToolContactResponse finds the array by its name and includes it in the error
 *   of the force. The array is absent if none of the ten points can be pressed;
 * - `OriginalPointIds` (vtkIdType): the ids of the points in the input;
 * - `GlobalMode0`, `GlobalMode1`... φ_k (float 3, sqrt(mm/N); NumberOfModes arrays) and the field
 *   array `GlobalModeSign` s_k (int, 1 or -1): the motion of the whole body; see **Modes** below;
 * - `CouplingModes` φ (float, NumberOfCouplingModes components, sqrt(mm/N)): the inward motion
 *   along the normal at each point. An inward force F at point j lowers point i by F Σ φ(i) φ(j) in
 *   addition to the dent (palpate/CouplingModes.h), and raises the opposite side of a plate. With
 *   CouplingOn, vtkToolContactResponse adds the modes to its response;
 * - `LoadedDisplacement` (double 3, mm), if LoadedPoint is set: the motion of the whole surface
 *   under the inward force LoadForce on the patch of this point. Within about one patch radius of
 *   the point, the motion is that under the patch, not under a tool.
 *
 * **Method.** By Castigliano's theorem, the mean displacement under a uniform normal load of 1 N on
 * a patch is twice the strain energy, bᵀK⁻¹b. The displacement of the same patch on a half-space of
 * the same elements is subtracted, so that the errors of the elements under the patch cancel
 * (palpate::patchCompliances, PatchSelfTerm). The remainder is C_g with a bias proportional to the
 * square of the patch radius. The use of two radii eliminates this bias. E* of the half-space
 * follows from the mean E and ν of the cells at the point. If E changes within a few cells under
 * the point, the tool's law with this E* no longer describes the local part, and C_g depends on the
 * mesh.
 *
 * **Accuracy.** The error is within 2 % on layers and plates with six or more hexahedra (three or
 * more quadratic tetrahedra) through the thickness, and of second order in the size of the cells.
 * The hexahedron has incompatible modes (Wilson et al. 1973, Taylor et al. 1976). It locks neither
 * in bending nor near ν = 0.5. Linear tetrahedra lock. Do not use them beyond ν = 0.4 or in
 * bending. Beyond ν = 0.47 quadratic tetrahedra have an error of a few per cent, in the half-space
 * term.
 *
 * **Modes.** An inward force F at the point X with the outward normal n moves the surface by
 *     u(x) = -F Σ_k s_k φ_k(x) (n·φ_k(X)) in mm,
 * in addition to the dent of the tool. X itself moves inwards by F Σ_k s_k (n·φ_k(X))² ≈ C_g F. The
 * surface stays on a tool pressed by δ if the dent has the remaining depth, δ - F Σ_k s_k
 * (n·φ_k(X))². Within a triangle φ is linear. The modes are computed from full solutions for eight
 * forces per mode, spread over the points of status 0. The dent of each force is subtracted on the
 * part of the surface with a similar normal (palpate::GlobalModes, RegularField). Therefore the
 * modes are valid at points of any status, and where the body is fixed they cancel the displacement
 * of the dent. If a body has several parts, a mode moves only one of them. If there are fewer
 * forces than modes, the last modes are zero. All modes are zero if no point has status 0. Modes of
 * equal strength, as on a square bar, are determined only up to their linear combination; sums over
 * them are unique.
 *
 * **Neglected by the modes**: higher modes, which form the sharp minimum of the deflection at the
 * force (their relative effect is largest near supports, where the deflection is small); forces
 * along the surface; the rest of a dent, if the display ends the dent before the normal of the
 * surface varies by 50°. Six modes were compared with full solutions. The following errors are the
 * largest error at any point relative to the largest motion. Cantilever of 40 × 4 × 4 mm: 0.3 % for
 * forces beyond two fifths of its length, 1 % for a force at a quarter of its length; Σ s (n·φ)² is
 * within 0.2 % of C_g (r.m.s. over the surface). Circular plate of 60 × 4 mm clamped at its rim: 4
 * % for a force at the centre, 8 % for a force half-way to the rim (0.6 and 1.6 % r.m.s. over the
 * plate); Σ s (n·φ)² is 16 % below C_g, because no six functions represent more than four fifths of
 * the compliance of a plate. A body that is bonded along a whole side deforms locally, and few
 * modes do not describe this deformation (40 % below C_g on a block of 20 × 20 × 5 mm). See
 * GetNeglectedByModes().
 *
 * **Cost.** One Cholesky factorisation takes 8 s for 100 thousand unknowns on one thread. The
 * solutions for all points and both radii take half of this time on two cores if the cells form a
 * regular grid. On irregular meshes the cells around each point differ, and the half-space terms
 * take about 8 ms per point and core (`./run bench filters --benchmark_filter=ElasticCompliance`).
 * The error takes about ten solutions of the whole body, and 100 µs per cell for each of them. The
 * solver is CHOLMOD with OpenBLAS if Palpate was built with it, otherwise Eigen, which is about a
 * hundred times slower. A body that needs more than MemoryLimit is refused before it is solved. If
 * the number of points (palpate::MemoryForecast) shows this with certainty, the body is refused
 * before assembly. Otherwise it is refused after the analysis, which predicts the memory of the
 * factor within a seventh. A cube of n³ points takes about 0.9 n⁴ kB. This is 14 GiB for 64 points
 * on a side, the largest size that CHOLMOD can index. Abort is checked between steps, not during
 * the factorisation. The filter uses as many threads as vtkSMPTools, or one per core if vtkSMPTools
 * is Sequential. The result is bit-identical for any number of these threads and of OpenBLAS's
 * threads.
 *
 * @code{.py}
 * compliance = palpate.vtkElasticCompliance()
 * compliance.SetInputConnection(solid.GetOutputPort()) # vtkVoxelBody
 * compliance.SetYoungsModulus(0.05)                    # MPa
 * compliance.SetNumberOfModes(2)
 * response.SetInputConnection(compliance.GetOutputPort())
 * response.SetInputArrayToProcess(2, 0, 0, 0, "GlobalCompliance")
 * @endcode
 *
 * @sa vtkVoxelBody vtkToolContactResponse
 */
#ifndef vtkElasticCompliance_h
#define vtkElasticCompliance_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

namespace palpate
{
struct FactorRequest;
}

class PALPATESOLIDRESPONSE_EXPORT vtkElasticCompliance : public vtkPolyDataAlgorithm
{
public:
  static vtkElasticCompliance* New();
  vtkTypeMacro(vtkElasticCompliance, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Solver.
  enum SolverKind
  {
    Automatic = 0,
    Supernodal = 1,
    Simplicial = 2
  };

  ///@{
  /**
   * Young's modulus E, MPa, > 0. It is used if there is no array of E (array to process 0, cell
   * data, one component). Default 0.1.
   */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  ///@}

  ///@{
  /**
   * Poisson's ratio ν, 0 to 0.499. It is used if there is no array of ν (array to process 1, cell
   * data, one component). Default 0.45.
   */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /**
   * Radius of the smaller patch, mm. The other patch has twice this radius. The default 0 selects
   * 0.75 times the distance to the neighbouring points, at each point.
   */
  vtkSetMacro(PatchRadius, double);
  vtkGetMacro(PatchRadius, double);
  ///@}

  ///@{
  /**
   * Largest memory of the factorisation, MiB. The default 0 allows nine tenths of the memory that
   * is available on the machine when the filter runs.
   */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /**
   * Automatic (default) selects Supernodal (CHOLMOD) if it was built in, otherwise Simplicial
   * (Eigen).
   */
  vtkSetMacro(Solver, int);
  vtkGetMacro(Solver, int);
  ///@}

  ///@{
  /**
   * Number of GlobalMode arrays, 0 to 6. With the default 0, there is also no GlobalModeSign. Each
   * mode takes eight solutions of the whole body.
   */
  vtkSetMacro(NumberOfModes, int);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  ///@{
  /**
   * Point of the output at which the load for LoadedDisplacement acts. The default -1 means no
   * load.
   */
  vtkSetMacro(LoadedPoint, vtkIdType);
  vtkGetMacro(LoadedPoint, vtkIdType);
  ///@}

  ///@{
  /** The force at LoadedPoint, N. Default 1. */
  vtkSetMacro(LoadForce, double);
  vtkGetMacro(LoadForce, double);
  ///@}

  ///@{
  /**
   * Number of components of CouplingModes, 0 to 16. With the default 0, the array is absent. Each
   * component takes eight solutions of the whole body. A strip needs four components, a plate
   * twelve.
   */
  vtkSetMacro(NumberOfCouplingModes, int);
  vtkGetMacro(NumberOfCouplingModes, int);
  ///@}

  /**
   * Fraction of the coupling that the modes of the last run neglect: the root mean square of C_ij -
   * Σ φ(i) φ(j) between points spread over the surface, relative to that of C_ij. It is 0 without
   * coupling modes.
   */
  vtkGetMacro(NeglectedByCouplingModes, double);

  /**
   * Fraction of the compliance that the modes of the last run neglect: the root mean square of C_g
   * - Σ s (n·φ)² over the points of status 0, relative to that of C_g. It is 0 without modes.
   */
  vtkGetMacro(NeglectedByModes, double);

  /**
   * Estimated memory of the last factorisation, MiB. It is also set if the factorisation was
   * refused.
   */
  vtkGetMacro(MemoryEstimate, double);

protected:
  vtkElasticCompliance() = default;
  ~vtkElasticCompliance() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkElasticCompliance(const vtkElasticCompliance&) = delete;
  void operator=(const vtkElasticCompliance&) = delete;

  std::string CheckProperties(const palpate::FactorRequest& request);

  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double PatchRadius = 0.0;
  double MemoryLimit = 0.0;
  int Solver = Automatic;
  vtkIdType LoadedPoint = -1;
  double LoadForce = 1.0;
  int NumberOfModes = 0;
  double NeglectedByModes = 0.0;
  int NumberOfCouplingModes = 0;
  double NeglectedByCouplingModes = 0.0;
  double MemoryEstimate = 0.0;
};

#endif
