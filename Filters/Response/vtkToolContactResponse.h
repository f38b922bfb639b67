// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToolContactResponse
 * @brief attaches to each point of a body the force-deflection curve of a tool pressed there
 *
 * Input: a vtkPolyData of triangles that wind counter-clockwise seen from outside, in mm. Polygons
 * other than triangles, and strips, are an error: use vtkTriangleFilter. Empty input gives empty
 * output. The input's arrays pass through.
 *
 * Output: the same body with the response arrays, all with the prefix ResponseName (default
 * `Response`), samples i = 1..n at δ_i = MaximumDeflection (i/n)²:
 * - point data `Force` (float n, N), `Stiffness` (float n, dF/dδ, N/mm), `Normal` (float 3, unit,
 *   outward), `Range` (float, mm, depth of the last sample), `Status` (uint8: 0 Valid, 1
 *   Degenerate: the point has no triangle with an area, or a zero normal, 2 NotFinite: a coordinate
 *   is not finite, or a force or stiffness is outside the range of a float, 1.2e-38 to 3.4e38; 3
 *   Folded, 4 OutOfReach: the layer is thinner than a tenth of the contact radius at
 *   MaximumDeflection, or no response was requested), `Validity` (float, mm), `Limit` (uint8);
 * - field data `Exponent` (double m), `Samples` (int n), `Tool`, `Model`, `Units` (strings);
 * - with layers, point data `LayerThickness` (float, mm, 0 for a half-space) and field data
 *   `LayerBase` (uint8), which vtkContactDeflection uses.
 * palpate/contract.py describes how to evaluate them.
 *
 * The settings of the material, of strain, error, edges, tilt and relaxation are those of
 * vtkTissueFilter and vtkResponseFilter. If array to process 5 gives strengths of relaxations, the
 * output has the point array `<name>LocalRelaxation` (float, a component each). In a stack all
 * layers have the one StrainModel and are bonded to each other; layers that slip on each other are
 * an error. With an ErrorTolerance of 0 validity ends where the first assumption fails, see below.
 *
 * **AutomaticTerms**: edges are left out if the body has none. Layers, CurvatureCorrection and
 * finite strain are left out if together they change the force by at most TermTolerance. Finite
 * strain is kept if without it the estimated error would exceed TermTolerance; Neo-Hooke is then
 * added if its tables contain the tool. The change is computed up to MaximumDeflection, at 95 % of
 * about 400 points (palpate/TermEffect.h). TermReason lists the terms that are included and left
 * out, with per cents.
 *
 * **Error** (point data, float n) is the estimated relative error of the force at each sample, by
 * strain, curvature, thickness, edge, storage and the elements of a compliance
 * (palpate/ErrorRule.h). **Validity** is the largest depth, at most Range, at which the error is
 * within ErrorTolerance. **Limit** names the largest part just beyond it: 0 none within Range, 1
 * strain, 2 curvature, 3 thickness, 5 edge, 7 elements, 8 tilt.
 *
 * With an ErrorTolerance of 0 `Error` is not stored, and validity ends where the first assumption
 * of the law fails. Strain: the contact radius exceeds 0.4 tip radii (for Flat and Cone, which have
 * no tip radius, δ/a exceeds 0.4). Curvature: the body's normal turns by more than 0.2 rad under
 * the contact radius. Thickness: δ exceeds 20 % of a layer's thickness. Edge: the contact circle is
 * wider than the middle one of the three lengths of the body's box.
 *
 * **Arrays to process** are point data with one component. Each is optional:
 * - 0 Young's modulus (MPa), 1 layer thickness (mm, 0 for a half-space), 2 global compliance
 *   (mm/N), 3 Poisson's ratio;
 * - 4 thickness (mm) of the second layer of a stack. By convention the arrays 1 and 4 are then
 *   called `LayerThickness0` and `LayerThickness1`; only the index matters, not the name;
 * - 5 strengths of the relaxations (AddRelaxation), with one component per relaxation. They replace
 *   the constants;
 * - 6 a mask, nonzero at the points that get a response (by convention `Pressed`). Their curves are
 *   bitwise equal to those of a response for all points.
 *
 * The array with the name of the global compliance followed by `Error`, if present, is the error of
 * the compliance in mm/N. If an index has no name, or an empty name, the constant property is used.
 * A named array that does not exist is an error. A value out of range is an error that names array,
 * index and value.
 *
 * The law is that of the tool on an elastic half-space (vtkContactTool) or, exactly, on a layer of
 * constant thickness on a rigid base (Lebedev and Ufliand 1958). A global compliance is in series
 * with this law: δ = δ_local(F) + C F. The exponent m is that of the tip, or 1 if the curve is then
 * stored more accurately. Normals are computed, angle-weighted; normals stored in the input are not
 * used.
 *
 * **Unsound meshes** are repaired first (palpate/SoundMesh.h). A second body inside another one and
 * a sheet with two sides are errors.
 *
 * Cost per point and core: without compliance the writing of 4 (2n + 5) + 2 bytes; with compliance
 * or layers and n = 8 about 1 µs, 5 µs for the exact Sphere. CurvatureCorrection and ErrorTolerance
 * add 0.7 µs, a StrainModel 3 µs and its solver once; on layers about 10 µs together. Threaded by
 * vtkSMPTools; the bits do not depend on the number of threads. Abort leaves no output.
 *
 * **Precision**: curves are stored in floats, to 6e-8. At a kilometre (1e6 mm) from the origin,
 * coordinates stored as double are exact to 1e-10 mm. Coordinates stored as float are on a grid of
 * 0.06 mm there, so forces at 1 mm deviate by up to 8 %. Pictures are drawn in floats about the
 * origin.
 *
 * **Several processes**: each may have a piece of the body, or none (Controller). The response is
 * that of the whole body, also at a seam, where border points of several pieces coincide. An error
 * on one process is an error on all. Ghost cells are left out. All must update the filter.
 *
 * @code{.py}
 * tool = palpate.vtkContactTool()
 * tool.SetSpecification("sphere:6.35")                 # radius in mm
 * response = palpate.vtkToolContactResponse()
 * response.SetInputConnection(surface.GetOutputPort())
 * response.SetTool(tool)
 * response.SetYoungsModulus(0.05)                      # MPa
 * response.Update()
 * @endcode
 *
 * @sa vtkResponseFilter vtkContactTool vtkToolContactProbe
 */
#ifndef vtkToolContactResponse_h
#define vtkToolContactResponse_h

#include "palpateResponseModule.h" // For export macro
#include "vtkResponseFilter.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <array>  // For std::array
#include <vector> // For std::vector

class vtkMultiProcessController;

class PALPATERESPONSE_EXPORT vtkToolContactResponse : public vtkResponseFilter
{
public:
  static vtkToolContactResponse* New();
  vtkTypeMacro(vtkToolContactResponse, vtkResponseFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of LayerBase.
  enum LayerBaseType
  {
    Bonded = 0,
    Slip = 1,
    ElasticBase = 2
  };

  ///@{
  /** The base of the layers: Bonded to a rigid base (default), Slip (on it without friction), or
   * ElasticBase (an elastic half-space). */
  vtkSetClampMacro(LayerBase, int, Bonded, ElasticBase);
  vtkGetMacro(LayerBase, int);
  void SetLayerBaseToBonded() { this->SetLayerBase(Bonded); }
  void SetLayerBaseToSlip() { this->SetLayerBase(Slip); }
  void SetLayerBaseToElasticBase() { this->SetLayerBase(ElasticBase); }
  ///@}

  ///@{
  /** Declares that the global compliance was found without the layers' base, so that both count.
   * Default off: a body with layers and a compliance is an error, since a compliance found on the
   * whole body already contains the base. */
  vtkSetMacro(ComplianceExcludesLayer, bool);
  vtkGetMacro(ComplianceExcludesLayer, bool);
  vtkBooleanMacro(ComplianceExcludesLayer, bool);
  ///@}

  ///@{
  /** Whether the law is in series with the compliance of the whole body. vtkBodyCompliance finds
   * the compliance from the closed surface of the body, within a few seconds for the first
   * response. The output then has the arrays of the compliance, and `Model` names the side that
   * holds the body. The compliance is left out with layers, a given compliance, a material that
   * varies, Coupling, ν above 0.499, an open surface, or a mesh whose triangles are too large. It
   * is also left out, with a warning, if it cannot be found. Default off; on in ParaView. */
  vtkSetMacro(WholeBody, bool);
  vtkGetMacro(WholeBody, bool);
  vtkBooleanMacro(WholeBody, bool);
  ///@}

  ///@{
  /** Layers below that of LayerThickness, from top to bottom, up to three: thickness (mm), Young's
   * modulus (MPa), Poisson's ratio, and whether the layer slips without friction below the layer
   * above it. The whole body is then a stack (palpate/LayerStack.h). Default none. */
  void AddLayer(double thickness, double youngsModulus, double poissonRatio, bool slips = false);
  void ClearLayers();
  int GetNumberOfAddedLayers();
  ///@}

  ///@{
  /** Young's modulus (MPa) and Poisson's ratio of an ElasticBase. Default 1 and 0.45. */
  vtkSetMacro(BaseYoungsModulus, double);
  vtkGetMacro(BaseYoungsModulus, double);
  vtkSetMacro(BasePoissonRatio, double);
  vtkGetMacro(BasePoissonRatio, double);
  ///@}

  ///@{
  /** Whether the law takes the body's curvature into account: the principal curvatures of the mesh
   * are added to the tool's profile (palpate/CurvedContact.h). Default on; off: the surface counts
   * as flat. If the tool does not fit into a hollow, the law is that of the flat surface. */
  vtkSetMacro(CurvatureCorrection, bool);
  vtkGetMacro(CurvatureCorrection, bool);
  vtkBooleanMacro(CurvatureCorrection, bool);
  ///@}

  ///@{
  /**
   * Whether several tools that press at once interact (vtkToolContactProbe::Coupled,
   * palpate/CoupledContacts.h). The law C(r), the deflection per force at the distance r from the
   * force, is stored in the field array `<name>Coupling` (double 3), for the half-space or the
   * layers. If modulus or thickness vary, the output also has the point arrays
   * `<name>CouplingModulus` (float, MPa) and `<name>CouplingThickness` (float, mm). If the body has
   * a point array `CouplingModes` (vtkElasticCompliance) and a global compliance, the output also
   * has `<name>CouplingModes` (float, √(mm/N)). These modes are scaled down where they would exceed
   * the response. Layers must cover the whole body or be absent; the thickness of a second layer
   * must be constant. Poisson's ratio is the mean of its smallest and largest value. Default off.
   */
  vtkSetMacro(Coupling, bool);
  vtkGetMacro(Coupling, bool);
  vtkBooleanMacro(Coupling, bool);
  ///@}

  ///@{
  /** Whether the global compliance is of the same material as the body and relaxes with it. Default
   * on. Off: the compliance is elastic, a spring below a body that relaxes. It is then stored as
   * point array `<name>ElasticCompliance` (float, mm/N) and must be >= 0. No effect without
   * relaxation. */
  vtkSetMacro(ComplianceRelaxes, bool);
  vtkGetMacro(ComplianceRelaxes, bool);
  vtkBooleanMacro(ComplianceRelaxes, bool);
  ///@}

  ///@{
  /** The processes that each have a piece of the body. Default: the global controller at the time
   * when the filter is made. With none, or with one process, the input is the whole body. */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkToolContactResponse();
  ~vtkToolContactResponse() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkToolContactResponse(const vtkToolContactResponse&) = delete;
  void operator=(const vtkToolContactResponse&) = delete;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  int LayerBase = Bonded;
  bool ComplianceExcludesLayer = false;
  bool WholeBody = false;
  std::vector<std::array<double, 4>> AddedLayers; ///< the arguments of AddLayer
  double BaseYoungsModulus = 1.0;
  double BasePoissonRatio = 0.45;
  bool CurvatureCorrection = true;
  bool Coupling = false;
  bool ComplianceRelaxes = true;
};

#endif
