// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactDeflection
 * @brief the displacement field of the body under one tip of a probe
 *
 * Port 0: the body. Port 1: the output of vtkToolContactProbe. TipIndex selects the tip. Output:
 * the body with the point vectors `ContactDisplacement` (float 3, mm). The vectors are the surface
 * displacement of an elastic half-space under the tool at the tip's deflection (u_r, u_z of
 * vtkContactTool). u_z points against the contact normal, u_r points along the surface away from
 * the contact, and distances r are measured along the surface. The field is zero without contact.
 * To display the field, warp the body by the vectors.
 *
 * The field covers the part of the surface that is connected to the contact and whose normal is
 * within 60° of the contact normal. The field ends at this angle, because beyond it, and on the far
 * side, the body differs from a half-space. With MaximumDistance, the field fades smoothly to zero.
 * The field is exact within 3/4 of this distance and within 50°. r is the length of the circular
 * arc that is tangent to the surface at both ends, r = chord (θ/2)/sin(θ/2), where θ is the angle
 * between the normals. This length is exact on planes, on spheres and around cylinders.
 *
 * If no tool is set, the filter uses the tool that the body's response names (ResponseName, field
 * array `Tool`). On a half-space, PoissonRatio scales only u_r. If the response has layers (point
 * array `LayerThickness` and field array `LayerBase`), the field is computed for a layer with the
 * thickness at the contact (palpate::ContactField). PoissonRatio then determines how the surface
 * bulges around the tool. It must equal the Poisson's ratio of the response.
 *
 * A response may have a global compliance or be computed for the true shape of the body. If the
 * body then has modes (NumberOfModes of vtkElasticCompliance, StoreMotion of
 * vtkElasticContactResponse), the whole surface moves by the modes under the tip's `NormalForce`.
 * The local part is the field for the deflection minus the part of the modes
 * (palpate::ContactField). Without modes, the field shows the local part at the total deflection,
 * and the filter issues one warning. For a response of the true shape, the field also shows the
 * effect of the surroundings of the contact (`NearField`): the surface gives way more near an edge,
 * and less over a nodule or a base. Compared with finite elements under the same force, the error
 * is within 3 % of the deflection at distances beyond two contact radii, on the pressed side of the
 * body (TestDeflectionShape). The surface behind an edge follows only the modes. A `NearField`
 * array with a wrong number of components or tuples is an error. Values of `NearField` that are not
 * finite are ignored.
 *
 * Times: TIME_STEPS contains the steps of body and tips. DATA_TIME_STEP is that of the tips.
 *
 * **Several processes** (Controller), each with a piece of the body: TipIndex counts the tips of
 * all processes, rank by rank. The selected tip presses all pieces, and the dent continues across
 * their seams. Each process stores its own piece and the points of all seams. The tips must have
 * the array `ContactRank` of vtkToolContactProbe. Ghost cells are left out. An error on one process
 * is an error on all. All processes must update the filter.
 *
 * Cost: the neighbours of the mesh are found once per change of its points or triangles, in O(n).
 * Each update evaluates the law once per point within the field. With modes, it also evaluates a
 * sum per point of the body.
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
  /** Index of the tip in port 1. -1 (default) selects the last tip. */
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
   * Distance from the contact at which the field ends, mm, even if it would be valid farther out.
   * Fading begins at 3/4 of the distance. 0 (default) sets no limit. At the distance r, the
   * displacement is about 2a/(πr) times the deflection, where a is the contact radius.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
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

  /** Sets the output of the probe as input port 1. */
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
