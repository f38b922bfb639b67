// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVNoduleMaterial
 * @brief nodules in any volume
 *
 * The class is the filter in ParaView's menu. Its body may be any volume mesh, as for
 * vtkPVElasticCompliance. Settings and results are those of the superclass. All lengths except the
 * input's coordinates are in mm.
 */
#ifndef vtkPVNoduleMaterial_h
#define vtkPVNoduleMaterial_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "VolumeInput.h"                // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkNoduleMaterial.h"

class PALPATESERVERMANAGER_EXPORT vtkPVNoduleMaterial : public vtkNoduleMaterial
{
public:
  static vtkPVNoduleMaterial* New();
  vtkTypeMacro(vtkPVNoduleMaterial, vtkNoduleMaterial);

protected:
  vtkPVNoduleMaterial() = default;
  ~vtkPVNoduleMaterial() override = default;

private:
  vtkPVNoduleMaterial(const vtkPVNoduleMaterial&) = delete;
  void operator=(const vtkPVNoduleMaterial&) = delete;

  palpateVolumeInputMacro();
};

#endif
