// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVToolContactResponse
 * @brief responses of any body, with a named material
 *
 * The class is the filter in ParaView's menu. Its body may be any surface or volume, composite or
 * not, in any unit of length; vtkBodySurface converts the body to triangles in mm. Settings and
 * results are those of the superclass. All lengths except the input's coordinates are in mm. A
 * named material replaces YoungsModulus and PoissonRatio, whose values are kept for Custom; point
 * arrays take precedence over both. In the same way, a named relaxation replaces the relaxation
 * branches of the user.
 */
#ifndef vtkPVToolContactResponse_h
#define vtkPVToolContactResponse_h

#include "BodyInput.h"                  // For its macro
#include "MaterialPreset.h"             // For its macro
#include "RelaxationPreset.h"           // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkToolContactResponse.h"

class PALPATESERVERMANAGER_EXPORT vtkPVToolContactResponse : public vtkToolContactResponse
{
public:
  static vtkPVToolContactResponse* New();
  vtkTypeMacro(vtkPVToolContactResponse, vtkToolContactResponse);

protected:
  vtkPVToolContactResponse() = default;
  ~vtkPVToolContactResponse() override = default;

private:
  vtkPVToolContactResponse(const vtkPVToolContactResponse&) = delete;
  void operator=(const vtkPVToolContactResponse&) = delete;

  palpateBodyInputMacro();
  palpateMaterialPresetMacro();
  palpateRelaxationPresetMacro();
};

#endif
