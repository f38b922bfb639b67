// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVMeasuredContactResponse
 * @brief measured responses on any body
 *
 * The class is the filter in ParaView's menu. Its body may be any surface or volume, composite or
 * not, in any unit of length; vtkBodySurface converts the body to triangles in mm. Settings and
 * results are those of the superclass. All lengths except the input's coordinates are in mm.
 */
#ifndef vtkPVMeasuredContactResponse_h
#define vtkPVMeasuredContactResponse_h

#include "BodyInput.h"                  // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkMeasuredContactResponse.h"

class PALPATESERVERMANAGER_EXPORT vtkPVMeasuredContactResponse : public vtkMeasuredContactResponse
{
public:
  static vtkPVMeasuredContactResponse* New();
  vtkTypeMacro(vtkPVMeasuredContactResponse, vtkMeasuredContactResponse);

protected:
  vtkPVMeasuredContactResponse() = default;
  ~vtkPVMeasuredContactResponse() override = default;

private:
  vtkPVMeasuredContactResponse(const vtkPVMeasuredContactResponse&) = delete;
  void operator=(const vtkPVMeasuredContactResponse&) = delete;

  palpateBodyInputMacro();
};

#endif
