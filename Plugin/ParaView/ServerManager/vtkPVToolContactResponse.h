// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVToolContactResponse
 * @brief responses of any body, with a named material
 *
 * The filter in ParaView's menu: its body may be any surface or volume, composite or not, in any
 * unit of length; vtkBodySurface converts it to triangles in mm. Settings and results are those of
 * the superclass. All lengths except the input's coordinates are in mm. A Material by name replaces
 * YoungsModulus and PoissonRatio, whose values are kept for Custom; arrays per point take
 * precedence. In the same way, a Relaxation by name replaces the single relaxations.
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
