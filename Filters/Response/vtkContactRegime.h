// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactRegime
 * @brief determines whether a body deforms locally or globally under a tool, and whether the shape
 *   of the tool matters
 *
 * Input: the body with the material of its response. The properties and the arrays to process are
 * those of vtkToolContactResponse (0 Young's modulus, 1 layer thickness, 2 global compliance, 3
 * Poisson's ratio). If the response has a global compliance and no array is given for the
 * compliance, the array `GlobalCompliance` of the body is used. Output: the body with these point
 * arrays, for the tool pressed to the depth `Deflection`:
 * - `RegimeIndex` (float): λ = 1 - δ_hs(F)/δ, where δ_hs is the depth of the same tool under the
 *   same force on a half-space of the same modulus. λ is at most 1. It is near 0 for local
 *   deformation, near 1 for global deformation, and negative where a base close to the surface
 *   stiffens the body;
 * - `ToolSensitivity` (float): S = dlnF/dln(size) at fixed δ, where size is the common scale of the
 *   tool's lengths. The size is R for a sphere, the radius for a flat end, and tan α for a cone,
 *   which has no length;
 * - `RegimeVerdict` (uint8). 0: the shape of the tool matters (a tool twice as large changes the
 *   force by more than 10 %, the just noticeable difference). 1: mixed. 2: a point force suffices
 *   (a tool four times as large changes the force by less than 5 %). The verdict follows from S,
 *   not from λ, because on a layer λ < 0, and the size matters more than on a half-space. The
 *   verdict refers to the size of a tool. The forces of a flat end and a sphere may differ a little
 *   more: by 7 % between the tools of the paper, where all three had verdict 2
 *   (Testing/Studies/paper, Figure 5).
 * - field array `RegimeDeflection` (double, mm): the depth for which λ and S were computed. If the
 *   depth follows Range, it is the largest depth of all points.
 *
 * If there is no stable contact, because the compliance folds the curve or the layer is too thin, λ
 * and S are NaN and the verdict is 0.
 *
 * Deflection 0 (default) selects half of the array `<ResponseName>Range` at each point; if the
 * array is missing, this is an error. If the body has the response `ResponseName` of the same tool,
 * the force of this response must agree with the force for the given material to 2 %, or to the
 * stated error of the response. Otherwise an error names the point, because the regime and the
 * response would belong to different bodies. The limit of 2 % is the storage error of a response in
 * series with a compliance. Depths below a hundredth of Range are not compared.
 *
 * Several processes, each with a piece of the body (Controller): the arrays and RegimeDeflection
 * refer to the whole body. An error on one process is an error on all. Ghost cells are left out.
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
  /** Depth of the verdict, mm. 0 (default) selects half of the response's Range at each point. */
  vtkSetMacro(Deflection, double);
  vtkGetMacro(Deflection, double);
  ///@}

  ///@{
  /** These properties have the same meaning and defaults as in vtkToolContactResponse. */
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
  /** These functions have the same meaning as in vtkToolContactResponse. */
  void AddLayer(double thickness, double youngsModulus, double poissonRatio, bool slips = false);
  void ClearLayers();
  int GetNumberOfAddedLayers();
  vtkSetMacro(BaseYoungsModulus, double);
  vtkGetMacro(BaseYoungsModulus, double);
  vtkSetMacro(BasePoissonRatio, double);
  vtkGetMacro(BasePoissonRatio, double);
  ///@}

  ///@{
  /** This property has the same meaning as in vtkToolContactResponse. */
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
  std::vector<std::array<double, 4>> AddedLayers; ///< arguments of each call of AddLayer
  double BaseYoungsModulus = 1.0;
  double BasePoissonRatio = 0.45;
};

#endif
