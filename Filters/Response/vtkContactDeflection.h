// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactDeflection
 * @brief the displacement field of the body under one tip of a probe
 *
 * Port 0: the body. Port 1: the output of vtkToolContactProbe; TipIndex chooses the tip. Output:
 * the body with point vectors `ContactDisplacement` (float 3, mm), the surface displacement of the
 * tool on an elastic half-space (u_r, u_z of vtkContactTool) at the tip's deflection, with u_z
 * against the contact normal and u_r along the surface away from the contact, at distances r
 * measured along the surface. Zero without contact. To see it, warp by the vector.
 *
 * The field covers the part of the surface that is connected to the contact and whose normal is
 * within 60° of the contact normal, and ends there: beyond it, and on the far side, the body is not
 * a half-space. With MaximumDistance it fades smoothly to zero, and is exact within 3/4 of that
 * distance and 50°. There r is the length of the circular arc that leaves and arrives along the
 * surface, r = chord (θ/2)/sin(θ/2) with θ the angle between the normals; exact on planes, spheres
 * and around cylinders.
 *
 * Tool: if none is set, the one named in the body's response (ResponseName, field array `Tool`).
 * On a half-space PoissonRatio scales u_r alone. Where the response has layers (its point array
 * `LayerThickness` and field array `LayerBase`), the field is that of a layer as thick as at the
 * contact (palpate::ContactField), in which PoissonRatio decides how the surface bulges beside the
 * tool; it must be that of the response.
 *
 * Where the response has a global compliance or is of true shape and the body carries its modes
 * (NumberOfModes of vtkElasticCompliance, StoreMotion of vtkElasticContactResponse), the whole
 * surface moves by them under the tip's `NormalForce`, and the local part is that of the deflection
 * they leave (palpate::ContactField). Without modes the field shows the local part at the whole
 * deflection; a warning says so, once. A response of true shape also shows what lies near the
 * contact (`NearField`): beside an edge the surface gives more, over a nodule or a base less.
 * Against finite elements under the same force, beyond two contact radii and on the side that is
 * pressed, within 3 % of the deflection (TestDeflectionShape); the side behind an edge follows the
 * modes alone. A `NearField` of another shape is an error; one that is not finite is not drawn.
 *
 * Times: TIME_STEPS of body and tips together, DATA_TIME_STEP of the tips.
 *
 * **Several processes** (Controller), each with a piece of the body: tips are counted through all
 * processes, rank by rank; the chosen one presses all pieces, and the dent continues across their
 * seams. Each process holds its own piece and the points of all seams. `ContactRank` of
 * vtkToolContactProbe must be among the tips' arrays. Ghost cells are left out. An error on one is
 * an error on all. All processes must update the filter.
 *
 * Cost: the mesh's neighbours are found once per change of its points or triangles, O(n); then one
 * evaluation of the law per point within the field, and, with modes, a sum per point of the body.
 */
#ifndef vtkContactDeflection_h
#define vtkContactDeflection_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkContactTool;
class vtkMultiProcessController;

namespace palpate
{
class BodyField;
} // namespace palpate

class PALPATERESPONSE_EXPORT vtkContactDeflection : public vtkPolyDataAlgorithm
{
public:
  static vtkContactDeflection* New();
  vtkTypeMacro(vtkContactDeflection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tool; default: the one the response names. */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** Which tip of port 1; -1 (default) is the last. */
  vtkSetMacro(TipIndex, vtkIdType);
  vtkGetMacro(TipIndex, vtkIdType);
  ///@}

  ///@{
  /** Poisson's ratio of the body, 0 to 0.5. Default 0.45. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /**
   * The field ends at this distance from the contact, mm, even where it would be valid beyond, and
   * fades from 3/4 of it on; 0 (default) for no such end. It has fallen to about (2a/πr) of the
   * deflection at r.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /** Prefix of the response arrays, for the tool's name. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /**
   * The processes that have a piece of the body each. Default: the global controller when the
   * filter is made. None, or one process: the input is the whole body.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** The probe's output, port 1. */
  void SetTipConnection(vtkAlgorithmOutput* tips) { this->SetInputConnection(1, tips); }
  void SetTipData(vtkDataObject* tips) { this->SetInputData(1, tips); }

  vtkMTimeType GetMTime() override;

protected:
  vtkContactDeflection();
  ~vtkContactDeflection() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkContactDeflection(const vtkContactDeflection&) = delete;
  void operator=(const vtkContactDeflection&) = delete;

  /// What is wrong with body, tool or Poisson's ratio, or "".
  std::string FindTool(vtkPolyData* body, vtkSmartPointer<vtkContactTool>& tool);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkSmartPointer<vtkContactTool> Tool;
  vtkIdType TipIndex = -1;
  double PoissonRatio = 0.45;
  double MaximumDistance = 0.0;
  std::string ResponseName = "Response";
  std::unique_ptr<palpate::BodyField> Field;
};

#endif
