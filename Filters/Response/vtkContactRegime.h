// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactRegime
 * @brief whether a body deforms locally or globally under a tool, and so whether the tool's shape
 *   matters
 *
 * Input: the body with the material of its response. The properties and arrays to process are those
 * of vtkToolContactResponse (0 Young's modulus, 1 layer thickness, 2 global compliance, 3 Poisson's
 * ratio). If the response has a global compliance and no array is given for it, the array
 * `GlobalCompliance` of the body is used. Output: the body with these arrays, per point, for the
 * tool pressed `Deflection` deep:
 * - `RegimeIndex` (float): λ = 1 - δ_hs(F)/δ, where δ_hs is the depth of the same tool under the
 *   same force on a half-space of the same modulus. At most 1: near 0 for local deformation, near 1
 *   for global deformation, negative where a near base stiffens the body;
 * - `ToolSensitivity` (float): S = dlnF/dln(size) at fixed δ, where size is the common scale of the
 *   tool's lengths (sphere: R; flat: its radius; cone, which has no length: tan α);
 * - `RegimeVerdict` (uint8): 0 shape matters (a tool twice as large changes the force by more than
 *   10 %, the just noticeable difference), 1 mixed, 2 a point force suffices (a tool four times as
 *   large changes it by less than 5 %). The verdict follows from S, not from λ: on a layer λ < 0,
 *   and size matters more than on a half-space. The verdict is about the size of a tool. The force
 *   of a flat may differ a little more from that of a sphere: by 7 % between the paper's tools
 *   where all three had verdict 2 (Testing/Studies/paper, Figure 5).
 * - field array `RegimeDeflection` (double, mm; the largest depth, if the depth follows Range): the
 *   depth for which λ and S were computed.
 *
 * Without a stable contact (compliance folds the curve, layer too thin) the numbers are NaN and the
 * verdict is 0.
 *
 * Deflection 0 (default): half of the array `<ResponseName>Range` at each point; an error without
 * that array. If the body has the response `ResponseName` of the same tool, its force at that depth
 * must agree with the given material to 2 %, or to its stated error. Otherwise an error names the
 * point, since the regime would be that of a different body than the response. (2 %: the storage
 * error of a response in series. Depths below a hundredth of Range are not compared.)
 *
 * Several processes, each with a piece of the body (Controller): the arrays and RegimeDeflection
 * are those of the whole body. An error on one process is an error on all. Ghost cells are left
 * out.
 *
 * Sources: St. Venant, Castigliano; Mahvash and Hayward 2002, section 2. Cost: three times that of
 * vtkToolContactResponse with a compliance. Threaded by vtkSMPTools; the bits do not depend on the
 * number of threads.
 *
 * @code{.py}
 * regime = palpate.vtkContactRegime()
 * regime.SetInputData(body)
 * regime.SetTool(tool)                                 # the tool and the material of its response
 * regime.SetYoungsModulus(0.05)                        # MPa
 * regime.SetDeflection(1.0)                            # mm
 * regime.Update()
 * verdicts = regime.GetOutput().GetPointData().GetArray("RegimeVerdict")
 * @endcode
 *
 * @sa vtkToolContactResponse vtkElasticCompliance
 */
#ifndef vtkContactRegime_h
#define vtkContactRegime_h

#include "palpateResponseModule.h" // For export macro
#include "vtkToolFilter.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <array>  // For std::array
#include <string> // For std::string
#include <vector> // For std::vector

class vtkContactTool;
class vtkMultiProcessController;

class PALPATERESPONSE_EXPORT vtkContactRegime : public vtkToolFilter
{
public:
  static vtkContactRegime* New();
  vtkTypeMacro(vtkContactRegime, vtkToolFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Depth of the verdict, mm. 0 (default): half of the response's Range at each point. */
  vtkSetMacro(Deflection, double);
  vtkGetMacro(Deflection, double);
  ///@}

  ///@{
  /** As in vtkToolContactResponse, with the same defaults. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  vtkSetClampMacro(LayerBase, int, 0, 2);
  vtkGetMacro(LayerBase, int);
  vtkSetMacro(ComplianceExcludesLayer, bool);
  vtkGetMacro(ComplianceExcludesLayer, bool);
  vtkBooleanMacro(ComplianceExcludesLayer, bool);
  ///@}

  ///@{
  /** As in vtkToolContactResponse. */
  void AddLayer(double thickness, double youngsModulus, double poissonRatio, bool slips = false);
  void ClearLayers();
  int GetNumberOfAddedLayers();
  vtkSetMacro(BaseYoungsModulus, double);
  vtkGetMacro(BaseYoungsModulus, double);
  vtkSetMacro(BasePoissonRatio, double);
  vtkGetMacro(BasePoissonRatio, double);
  ///@}

  ///@{
  /** As in vtkToolContactResponse. */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkContactRegime();
  ~vtkContactRegime() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkContactRegime(const vtkContactRegime&) = delete;
  void operator=(const vtkContactRegime&) = delete;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  double Deflection = 0.0;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double LayerThickness = 0.0;
  int LayerBase = 0;
  bool ComplianceExcludesLayer = false;
  std::vector<std::array<double, 4>> AddedLayers; ///< the arguments of AddLayer
  double BaseYoungsModulus = 1.0;
  double BasePoissonRatio = 0.45;
};

#endif
