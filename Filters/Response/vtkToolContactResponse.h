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
 * **Arrays to process**, point data, one component, each optional: 0 Young's modulus (MPa), 1 layer
 * thickness (mm, 0 for a half-space), 2 global compliance (mm/N), 3 Poisson's ratio, 4 thickness
 * (mm) of the second layer of a stack (by convention `LayerThickness0` and `LayerThickness1`; an
 * array counts by its index, not by its name), 5 strengths of the relaxations, one component each
 * (AddRelaxation), which replace the constants, 6 a mask, nonzero at the points that get a response
 * (by convention `Pressed`); their curves are, bit for bit, those of a response for all points. For
 * a global compliance the array of its name followed by `Error`, if present, is its error in mm/N.
 * An index without a name, or with an empty one, means the constant property. A named array that
 * does not exist is an error. So is a value out of range; the error names array, index and value.
 *
 * The law is the tool's on an elastic half-space (vtkContactTool) or, exactly, on a layer of
 * constant thickness on a rigid base (Lebedev and Ufliand 1958). A global compliance is in series
 * with this law: δ = δ_local(F) + C F. The exponent m is the tip's, or 1 if that stores the curve
 * better. Normals are computed, angle-weighted; normals stored in the input are not used.
 *
 * **Unsound meshes** are repaired first (palpate/SoundMesh.h). A second body inside another one and
 * a sheet with two sides are errors.
 *
 * Cost per point and core: without compliance the writing of 4 (2n + 5) + 2 bytes; with compliance
 * or layers and n = 8 about 1 µs, 5 µs for the exact Sphere. CurvatureCorrection and ErrorTolerance
 * add 0.7 µs, a StrainModel 3 µs and its solver once; on layers about 10 µs together. Threaded by
 * vtkSMPTools; the bits do not depend on the number of threads. Abort leaves no output.
 *
 * **Precision**: curves are stored in floats, to 6e-8. Coordinates stored as double keep 1e-10 mm a
 * kilometre (1e6 mm) from the origin. Those stored as float are on a grid of 0.06 mm there, and
 * forces at 1 mm deviate by up to 8 %. Pictures are drawn in floats about the origin.
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
 * @sa vtkContactTool vtkToolContactProbe
 */
#ifndef vtkToolContactResponse_h
#define vtkToolContactResponse_h

#include "Response/Curves/RelaxationList.h" // For palpate::RelaxationList
#include "palpateResponseModule.h"          // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <array>  // For std::array
#include <string> // For std::string
#include <vector> // For std::vector

class vtkContactTool;
class vtkMultiProcessController;

class PALPATERESPONSE_EXPORT vtkToolContactResponse : public vtkPolyDataAlgorithm
{
public:
  static vtkToolContactResponse* New();
  vtkTypeMacro(vtkToolContactResponse, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tool; required. Its changes count in this filter's modification time. */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** Young's modulus E, MPa, > 0, and Poisson's ratio, 0 to 0.5, of points without an array.
   * Default 0.1 and 0.45. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** Thickness h of an elastic layer on a rigid base, mm, of points without an array. 0, the
   * default, means a half-space. */
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  ///@}

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
  /** Whether the law is in series with the compliance of the whole body, which vtkBodyCompliance
   * finds from its closed surface, within a few seconds for the first response. The output then has
   * the arrays of the compliance, and `Model` names the side that holds the body. The compliance is
   * left out with layers, a given compliance, a material that varies, EdgeCorrection, Coupling, ν
   * above 0.499 or an open surface, and, with a warning, if it cannot be found. Default off; on in
   * ParaView. */
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
   * Whether sharp convex edges have an effect: a contact near an edge is softer and is pushed off
   * the body, and its force falls to zero as it leaves over the edge (palpate/BodyEdges.h; Hetényi
   * 1970). The curves remain those far from edges. A field array `<name>Edges` (double 5: exponent
   * m, contact radius at 1 mm in mm, Poisson's ratio, extent in mm, 1 if the curves include the
   * edges) lets probe, touch and servo loop apply them; the error includes the rest of their
   * effect. Default off: the force drops where a contact passes an edge.
   */
  vtkSetMacro(EdgeCorrection, bool);
  vtkGetMacro(EdgeCorrection, bool);
  vtkBooleanMacro(EdgeCorrection, bool);
  ///@}

  ///@{
  /**
   * Largest tilt of the tool against the body's normal, degrees, >= 0. Default 0: the tool counts
   * as upright, whatever its axis.
   *
   * Above 0 the output has the field arrays `<name>Tilt`, `<name>TiltDrop`, `<name>TiltNode`
   * (double) and, if points differ in more than their modulus, the point array `<name>TiltWeight`
   * (float): how a tilt changes the work of the upright tool (palpate/TiltTable.h). A probe or
   * session that knows the tool's axis then applies its tilt, and a torque. The law is exact for a
   * sphere and, on a half-space, for a flat end. Its error is 0.5 % for cones, 1 % for other tools,
   * and 3 % for flat-ended tools beyond a tenth of their size. On layers it uses the axisymmetric
   * tool of equal contact radius, within Validity. An angle within 4 degrees of that at which a
   * flank of the tool is parallel to the surface, or beyond, is an error. Cost: a few seconds for
   * each tool without closed form.
   */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}

  ///@{
  /**
   * Whether several tools that press at once interact (vtkToolContactProbe::Coupled,
   * palpate/CoupledContacts.h). The law C(r), the deflection per force at the distance r from the
   * force, is stored in the field array `<name>Coupling` (double 3), for the half-space or the
   * layers. If modulus or thickness vary, also point arrays `<name>CouplingModulus` (float, MPa)
   * and `<name>CouplingThickness` (float, mm). If the body has a point array `CouplingModes`
   * (vtkElasticCompliance) and a global compliance, also `<name>CouplingModes` (float, √(mm/N)),
   * scaled down where the modes would exceed the response. Layers must cover the whole body or be
   * absent; the thickness of a second layer must be constant. Poisson's ratio is the mean of its
   * smallest and largest value. Default off.
   */
  vtkSetMacro(Coupling, bool);
  vtkGetMacro(Coupling, bool);
  vtkBooleanMacro(Coupling, bool);
  ///@}

  ///@{
  /**
   * How the body relaxes: E(t)/E∞ = 1 + Σ p exp(-t/τ). Each branch has a strength p >= 0, relative
   * to the slow modulus E∞, and a time τ > 0 in seconds; up to four. Default none.
   *
   * Poisson's ratio does not change. Curves, YoungsModulus and Error are those of the slow
   * response; the force in time is larger, up to 1 + Σ p times (palpate/ToolContact.h). A fraction
   * g of the instantaneous modulus, as in the literature, is p = g/(1 - Σ g). A modulus measured in
   * a press at constant speed is above the slow one (palpate/PronySeries.h, rampFactor). The output
   * has the field arrays `<name>RelaxationStrength` and `<name>RelaxationTime` (double, a tuple
   * each, s) and, if array to process 5 gives strengths, `<name>LocalRelaxation` (point data,
   * float, a component each).
   */
  void AddRelaxation(double strength, double seconds);
  void ClearRelaxations();
  int GetNumberOfRelaxations() { return this->Relaxations.count(); }
  double GetRelaxationStrength(int relaxation) { return this->Relaxations.strength(relaxation); }
  double GetRelaxationTime(int relaxation) { return this->Relaxations.seconds(relaxation); }
  ///@}

  ///@{
  /** Whether the global compliance is of the same material and relaxes with it. Default on; off:
   * the compliance is elastic, a spring below a body that relaxes. It is then stored as point array
   * `<name>ElasticCompliance` (float, mm/N) and must be >= 0. No effect without relaxation. */
  vtkSetMacro(ComplianceRelaxes, bool);
  vtkGetMacro(ComplianceRelaxes, bool);
  vtkBooleanMacro(ComplianceRelaxes, bool);
  ///@}

  /// Values of StrainModel.
  enum StrainModelType
  {
    SmallStrain = 0,
    NeoHooke = 1,
    Ogden = 2,
    Demiray = 3
  };

  ///@{
  /**
   * Law of the body at large strain: SmallStrain (default), the exact laws of linear elasticity;
   * NeoHooke; Ogden with one term of the exponent OgdenExponent; Demiray with the exponent
   * DemirayExponent. Modulus and Poisson's ratio are those at small strain. In a stack all layers
   * have this one model and are bonded to each other; layers that slip on each other are an error.
   */
  vtkSetClampMacro(StrainModel, int, SmallStrain, Demiray);
  vtkGetMacro(StrainModel, int);
  void SetStrainModelToSmallStrain() { this->SetStrainModel(SmallStrain); }
  void SetStrainModelToNeoHooke() { this->SetStrainModel(NeoHooke); }
  void SetStrainModelToOgden() { this->SetStrainModel(Ogden); }
  void SetStrainModelToDemiray() { this->SetStrainModel(Demiray); }
  ///@}

  ///@{
  /** Ogden's exponent, not 0, and Demiray's exponent b, > 0. Default 2 (Neo-Hooke) and 1. */
  vtkSetMacro(OgdenExponent, double);
  vtkGetMacro(OgdenExponent, double);
  vtkSetMacro(DemirayExponent, double);
  vtkGetMacro(DemirayExponent, double);
  ///@}

  ///@{
  /**
   * Validity ends where the estimated relative error of the force (palpate/ErrorRule.h) exceeds
   * this. Default 0.05, 5 %. 0: Validity is the depth at which the first assumption fails, as
   * above. StoreError: whether the error at each sample is stored in the array `Error`, for
   * displays. Default on; no effect if ErrorTolerance is 0.
   */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  vtkSetMacro(StoreError, bool);
  vtkGetMacro(StoreError, bool);
  vtkBooleanMacro(StoreError, bool);
  ///@}

  ///@{
  /**
   * Whether to choose the terms of the law by their effect. Edges are left out if the body has
   * none. Layers, CurvatureCorrection and finite strain are left out if together they change the
   * force by no more than TermTolerance. Finite strain is kept if the error stated without it would
   * exceed that; Neo-Hooke is then added if its tables have the tool. The change is judged up to
   * MaximumDeflection, at 95 % of about 400 points (palpate/TermEffect.h). GetTermReason and the
   * field array `<name>Terms` list the terms that are included and left out, with per cents.
   * Default off: all terms as set.
   */
  vtkSetMacro(AutomaticTerms, bool);
  vtkGetMacro(AutomaticTerms, bool);
  vtkBooleanMacro(AutomaticTerms, bool);
  ///@}

  ///@{
  /** Relative change of the force that AutomaticTerms may leave out, >= 0. Default 0.01. */
  vtkSetMacro(TermTolerance, double);
  vtkGetMacro(TermTolerance, double);
  ///@}

  /// Result of the last execution: the terms that AutomaticTerms included and left out; "" without
  /// it.
  vtkGetMacro(TermReason, std::string);

  ///@{
  /** Depth of the last sample, mm, > 0, and samples per curve n, 2 to 256. Default 2 and 8. */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /** Prefix of the arrays. Use a different prefix for each tool on one body. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /** The processes that each have a piece of the body. Default: the global controller at the time
   * when the filter is made. With none, or with one process, the input is the whole body. */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkToolContactResponse();
  ~vtkToolContactResponse() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkToolContactResponse(const vtkToolContactResponse&) = delete;
  void operator=(const vtkToolContactResponse&) = delete;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkSmartPointer<vtkContactTool> Tool;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double LayerThickness = 0.0;
  int LayerBase = Bonded;
  bool ComplianceExcludesLayer = false;
  bool WholeBody = false;
  std::vector<std::array<double, 4>> AddedLayers; ///< the arguments of AddLayer
  double BaseYoungsModulus = 1.0;
  double BasePoissonRatio = 0.45;
  bool CurvatureCorrection = true;
  bool EdgeCorrection = false;
  double MaximumTilt = 0.0;
  bool Coupling = false;
  palpate::RelaxationList Relaxations;
  bool ComplianceRelaxes = true;
  int StrainModel = SmallStrain;
  double OgdenExponent = 2.0;
  double DemirayExponent = 1.0;
  double ErrorTolerance = 0.05;
  bool StoreError = true;
  bool AutomaticTerms = false;
  double TermTolerance = 0.01;
  std::string TermReason;
  double MaximumDeflection = 2.0;
  int NumberOfSamples = 8;
  std::string ResponseName = "Response";
};

#endif
