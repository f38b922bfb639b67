// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactDeflection
 * @brief the displacement field of the body under one tip of a probe
 *
 * Port 0: the body. Port 1: the output of vtkToolContactProbe; TipIndex chooses the tip. Output:
 * the body with point vectors `ContactDisplacement` (float 3, mm). They are the surface
 * displacement of the tool on an elastic half-space (u_r, u_z of vtkContactTool) at the tip's
 * deflection. u_z points against the contact normal, u_r points along the surface away from the
 * contact, and distances r are measured along the surface. The field is zero without contact. To
 * see the field, warp by the vector.
 *
 * The field covers the part of the surface that is connected to the contact and whose normal is
 * within 60° of the contact normal. It ends there, because beyond that angle, and on the far side,
 * the body is not like a half-space. With MaximumDistance the field fades smoothly to zero; it is
 * exact within 3/4 of that distance and within 50°. r is the length of the circular arc that is
 * tangent to the surface at both ends, r = chord (θ/2)/sin(θ/2), where θ is the angle between the
 * normals. It is exact on planes, on spheres and around cylinders.
 *
 * Tool: if none is set, the tool that the body's response names (ResponseName, field array `Tool`).
 * On a half-space PoissonRatio scales u_r only. If the response has layers (its point array
 * `LayerThickness` and field array `LayerBase`), the field is that of a layer with the thickness at
 * the contact (palpate::ContactField). PoissonRatio then determines how the surface bulges around
 * the tool; it must be that of the response.
 *
 * If the response has a global compliance or is of true shape, and the body has its modes
 * (NumberOfModes of vtkElasticCompliance, StoreMotion of vtkElasticContactResponse), the whole
 * surface moves by the modes under the tip's `NormalForce`. The local part is then the field for
 * the deflection minus the modes' part (palpate::ContactField). Without modes the field shows the
 * local part at the whole deflection, with one warning. A response of true shape also shows the
 * effect of its surroundings (`NearField`): the surface gives way more near an edge, and less over
 * a nodule or a base. Compared with finite elements under the same force, the error is within 3 %
 * of the deflection beyond two contact radii, on the side that is pressed (TestDeflectionShape).
 * The side behind an edge follows the modes only. A `NearField` of another shape is an error; if it
 * is not finite, it is not drawn.
 *
 * Times: TIME_STEPS of body and tips together, DATA_TIME_STEP of the tips.
 *
 * **Several processes** (Controller), each with a piece of the body: tips are counted through all
 * processes, rank by rank. The chosen tip presses all pieces, and the dent continues across their
 * seams. Each process stores its own piece and the points of all seams. The tips must have the
 * array `ContactRank` of vtkToolContactProbe. Ghost cells are left out. An error on one process is
 * an error on all. All processes must update the filter.
 *
 * Cost: the mesh's neighbours are found once per change of its points or triangles, O(n). Then each
 * update evaluates the law once per point within the field and, with modes, a sum per point of the
 * body.
 *
 * @code{.py}
 * dent = palpate.vtkContactDeflection()
 * dent.SetInputData(0, body)                           # with the response that was probed
 * dent.SetTipConnection(probe.GetOutputPort())
 * dent.SetTipIndex(0)
 * dent.Update()
 * displacement = dent.GetOutput().GetPointData().GetArray("ContactDisplacement")  # mm
 * @endcode
 */
#ifndef vtkContactDeflection_h
#define vtkContactDeflection_h

#include "palpateResponseModule.h" // For export macro
#include "vtkToolFilter.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkContactTool;
class vtkMultiProcessController;

namespace palpate
{
class BodyField;
} // namespace palpate

class PALPATERESPONSE_EXPORT vtkContactDeflection : public vtkToolFilter
{
public:
  static vtkContactDeflection* New();
  vtkTypeMacro(vtkContactDeflection, vtkToolFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Index of the tip in port 1; -1 (default): the last tip. */
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
   * The field ends at this distance from the contact, mm, even if it would be valid farther out.
   * Fading begins at 3/4 of the distance. 0 (default): no limit. At the distance r the displacement
   * is about 2a/(πr) times the deflection.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * The processes that each have a piece of the body. Default: the global controller at the time
   * when the filter is made. With none, or with one process, the input is the whole body.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** The probe's output, port 1. */
  void SetTipConnection(vtkAlgorithmOutput* tips) { this->SetInputConnection(1, tips); }
  void SetTipData(vtkDataObject* tips) { this->SetInputData(1, tips); }

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

  /// Checks body, tool and Poisson's ratio, and finds the tool. Returns "" or an error message.
  std::string FindTool(vtkPolyData* body, vtkSmartPointer<vtkContactTool>& tool);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkIdType TipIndex = -1;
  double PoissonRatio = 0.45;
  double MaximumDistance = 0.0;
  std::unique_ptr<palpate::BodyField> Field;
};

#endif
