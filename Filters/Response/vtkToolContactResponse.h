// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToolContactResponse
 * @brief attaches to each point of a body the force-deflection curve of a tool pressed there
 *
 * Input: a vtkPolyData of triangles that wind counter-clockwise seen from outside, in mm. Polygons
 * other than triangles, and strips, are an error; convert them with vtkTriangleFilter. Empty input
 * gives empty output. The input's arrays pass through.
 *
 * Output: the same body with the response arrays. All names have the prefix ResponseName (default
 * `Response`). The samples i = 1..n are at δ_i = MaximumDeflection (i/n)².
 * - point data `Force` (float n, N), `Stiffness` (float n, dF/dδ, N/mm), `Normal` (float 3, unit,
 *   outward), `Range` (float, mm, depth of the last sample), `Status` (uint8: 0 Valid, 1
 *   Degenerate: the point has no triangle with an area, or a zero normal, 2 NotFinite: a coordinate
 *   is not finite, or a force or stiffness is outside the range of a float, 1.2e-38 to 3.4e38; 3
 *   Folded, 4 OutOfReach: the layer is thinner than a tenth of the contact radius at
 *   MaximumDeflection, or the point is not in the mask of array 6), `Validity` (float, mm), `Limit`
 *   (uint8);
 * - field data `Exponent` (double m), `Samples` (int n), `Tool`, `Model`, `Units` (strings);
 * - with layers, point data `LayerThickness` (float, mm, 0 for a half-space) and field data
 *   `LayerBase` (uint8), which vtkContactDeflection uses.
 * palpate/contract.py describes how to evaluate these arrays.
 *
 * The settings of material, strain, error, edges, tilt and relaxation are those of vtkTissueFilter
 * and vtkResponseFilter. If the array to process 5 gives the strengths of the relaxations, the
 * output has the point array `<name>LocalRelaxation` (float, one component per relaxation). In a
 * stack with a StrainModel, all layers have the same StrainModel and must be bonded to each other;
 * layers that slip on each other are an error. If ErrorTolerance is 0, validity ends where the
 * first assumption fails (see below).
 *
 * **AutomaticTerms**: edges are left out if the body has none. Layers, CurvatureCorrection and
 * finite strain are left out if together they change the force by at most TermTolerance. Finite
 * strain is kept if the estimated error without it would exceed TermTolerance. In this case
 * Neo-Hooke is added if its tables contain the tool. The change is computed up to
 * MaximumDeflection, at 95 % of about 400 points (palpate/TermEffect.h). TermReason lists the
 * included and the omitted terms, with their effects in per cent.
 *
 * **Error** (point data, float n) is the estimated relative error of the force at each sample. It
 * includes the errors due to strain, curvature, thickness, edge, storage and the finite elements of
 * a compliance (palpate/ErrorRule.h). **Validity** is the largest depth, at most Range, at which
 * the error is within ErrorTolerance. **Limit** names the largest part of the error just beyond
 * Validity: 0 if there is no limit within Range, 1 strain, 2 curvature, 3 thickness, 5 edge, 7
 * elements, 8 tilt.
 *
 * If ErrorTolerance is 0, `Error` is not stored, and validity ends where the first assumption of
 * the law fails. The assumption on strain fails if the contact radius exceeds 0.4 tip radii. For
 * Flat and Cone, which have no tip radius, it fails if δ/a exceeds 0.4. The assumption on curvature
 * fails if the body's normal rotates by more than 0.2 rad within the contact radius. The assumption
 * on thickness fails if δ exceeds 20 % of a layer's thickness. The assumption on edges fails if the
 * contact circle is wider than the middle of the three side lengths of the body's bounding box.
 *
 * **Arrays to process** are point data with one component, except array 5. Each array is optional:
 * - 0 Young's modulus (MPa), 1 layer thickness (mm, 0 for a half-space), 2 global compliance
 *   (mm/N), 3 Poisson's ratio;
 * - 4 thickness (mm) of the second layer of a stack. By convention the arrays 1 and 4 are then
 *   called `LayerThickness0` and `LayerThickness1`, but the filter uses only the index, not the
 *   name;
 * - 5 strengths of the relaxations (AddRelaxation), with one component per relaxation. They replace
 *   the constants;
 * - 6 a mask, nonzero at the points that get a response (by convention `Pressed`). Their curves are
 *   bitwise equal to those of a response for all points.
 *
 * An array whose name is that of the global compliance followed by `Error` contains the error of
 * the compliance in mm/N. If an index has no name, or an empty name, the constant property is used.
 * A named array that does not exist is an error. A value out of range is an error that names array,
 * index and value.
 *
 * The law is that of the tool on an elastic half-space (vtkContactTool) or, exactly, on a layer of
 * constant thickness on a rigid base (Lebedev and Ufliand 1958). A global compliance C acts in
 * series with this law: δ = δ_local(F) + C F. The exponent m is that of the tip, or 1 if 1 stores
 * the curve more accurately. The filter computes angle-weighted normals. It does not use normals
 * that are stored in the input.
 *
 * **Unsound meshes** are repaired first (palpate/SoundMesh.h). A second body inside another one and
 * a sheet with two sides are errors.
 *
 * Cost per point and core: without compliance, the time to write 4 (2n + 5) + 2 bytes. With
 * compliance or layers and n = 8 it is about 1 µs, and 5 µs for the exact Sphere.
 * CurvatureCorrection and ErrorTolerance add 0.7 µs. A StrainModel adds 3 µs per point and one run
 * of its solver. On layers, these settings together take about 10 µs. The filter is threaded by
 * vtkSMPTools. The results do not depend on the number of threads. After an abort there is no
 * output.
 *
 * **Precision**: curves are stored in floats, to 6e-8. At a kilometre (1e6 mm) from the origin,
 * coordinates stored as double are exact to 1e-10 mm. Coordinates stored as float are on a grid of
 * 0.06 mm there. Therefore forces at a depth of 1 mm deviate by up to 8 %. Pictures are drawn with
 * float coordinates relative to the origin.
 *
 * **Several processes** (Controller): each process may have a piece of the body, or none. The
 * response is that of the whole body, also at a seam, where border points of several pieces
 * coincide. An error on one process is an error on all. Ghost cells are left out. All processes
 * must update the filter.
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
  /**
   * The base of the layers. Bonded (default): the layers are bonded to a rigid base. Slip: the
   * layers lie on a rigid base without friction. ElasticBase: the base is an elastic half-space.
   */
  vtkSetClampMacro(LayerBase, int, Bonded, ElasticBase);
  vtkGetMacro(LayerBase, int);
  void SetLayerBaseToBonded() { this->SetLayerBase(Bonded); }
  void SetLayerBaseToSlip() { this->SetLayerBase(Slip); }
  void SetLayerBaseToElasticBase() { this->SetLayerBase(ElasticBase); }
  ///@}

  ///@{
  /**
   * Declares that the global compliance was found without the base of the layers, so that both are
   * applied. Default off. If it is off, a body with layers and a compliance is an error, because a
   * compliance that was found for the whole body already contains the base.
   */
  vtkSetMacro(ComplianceExcludesLayer, bool);
  vtkGetMacro(ComplianceExcludesLayer, bool);
  vtkBooleanMacro(ComplianceExcludesLayer, bool);
  ///@}

  ///@{
  /**
   * Whether the compliance of the whole body acts in series with the law. vtkBodyCompliance finds
   * the compliance from the closed surface of the body. The first response takes a few seconds. The
   * output then has the arrays of the compliance, and `Model` names the side that holds the body.
   *
   * The compliance is left out if the body has layers, a given compliance, a material that varies,
   * ν above 0.499, an open surface, or a mesh whose triangles are too large, and if Coupling is on.
   * If the compliance cannot be found, it is left out with a warning. Default off; on in ParaView.
   */
  vtkSetMacro(WholeBody, bool);
  vtkGetMacro(WholeBody, bool);
  vtkBooleanMacro(WholeBody, bool);
  ///@}

  ///@{
  /**
   * Layers below the layer of LayerThickness, from top to bottom, at most three. The arguments are
   * the thickness (mm), Young's modulus (MPa), Poisson's ratio, and whether the layer slips without
   * friction below the layer above it. The whole body is then a stack (palpate/LayerStack.h). By
   * default there are none.
   */
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
  /**
   * Whether the law includes the curvature of the body. The principal curvatures of the mesh are
   * added to the tool's profile (palpate/CurvedContact.h). Default on. If it is off, the surface
   * counts as flat. If the tool does not fit into a hollow, the law is that of the flat surface.
   */
  vtkSetMacro(CurvatureCorrection, bool);
  vtkGetMacro(CurvatureCorrection, bool);
  vtkBooleanMacro(CurvatureCorrection, bool);
  ///@}

  ///@{
  /**
   * Whether several tools that press at once interact (vtkToolContactProbe::Coupled,
   * palpate/CoupledContacts.h). The law C(r) is the deflection per force at the distance r from the
   * force. It is stored in the field array `<name>Coupling` (double 3), for the half-space or the
   * layers. If modulus or thickness vary, the output also has the point arrays
   * `<name>CouplingModulus` (float, MPa) and `<name>CouplingThickness` (float, mm). If the body has
   * a point array `CouplingModes` (vtkElasticCompliance) and a global compliance, the output also
   * has `<name>CouplingModes` (float, √(mm/N)). These modes are scaled down where they would yield
   * more than the response. Layers must cover the whole body or be absent; the thickness of a
   * second layer must be constant. If Poisson's ratio varies, the mean of its smallest and largest
   * value is used. Default off.
   */
  vtkSetMacro(Coupling, bool);
  vtkGetMacro(Coupling, bool);
  vtkBooleanMacro(Coupling, bool);
  ///@}

  ///@{
  /**
   * Whether the global compliance belongs to the same material as the body and relaxes with it.
   * Default on. If it is off, the compliance is elastic and acts as a spring below a body that
   * relaxes. It is then stored as the point array `<name>ElasticCompliance` (float, mm/N) and must
   * be >= 0. The setting has no effect without relaxation.
   */
  vtkSetMacro(ComplianceRelaxes, bool);
  vtkGetMacro(ComplianceRelaxes, bool);
  vtkBooleanMacro(ComplianceRelaxes, bool);
  ///@}

  ///@{
  /**
   * The processes that each have a piece of the body. The default is the global controller at the
   * time when the filter is created. Without a controller, or with one process, the input is the
   * whole body.
   */
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
  std::vector<std::array<double, 4>> AddedLayers; ///< arguments of each call of AddLayer
  double BaseYoungsModulus = 1.0;
  double BasePoissonRatio = 0.45;
  bool CurvatureCorrection = true;
  bool Coupling = false;
  bool ComplianceRelaxes = true;
};

#endif
