// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVElasticContactResponse
 * @brief responses of true shape on any volume
 *
 * The class is the filter in ParaView's menu. Its body may be any volume mesh, as for
 * vtkPVElasticCompliance. Settings and results are those of the superclass. All lengths except the
 * input's coordinates are in mm.
 */
#ifndef vtkPVElasticContactResponse_h
#define vtkPVElasticContactResponse_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "VolumeInput.h"                // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkElasticContactResponse.h"

class PALPATESERVERMANAGER_EXPORT vtkPVElasticContactResponse : public vtkElasticContactResponse
{
public:
  static vtkPVElasticContactResponse* New();
  vtkTypeMacro(vtkPVElasticContactResponse, vtkElasticContactResponse);

protected:
  vtkPVElasticContactResponse() = default;
  ~vtkPVElasticContactResponse() override = default;

private:
  vtkPVElasticContactResponse(const vtkPVElasticContactResponse&) = delete;
  void operator=(const vtkPVElasticContactResponse&) = delete;

  palpateVolumeInputMacro();
};

#endif
