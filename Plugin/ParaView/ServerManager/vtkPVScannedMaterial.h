// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVScannedMaterial
 * @brief materials from an image, for any volume
 *
 * The class is the filter in ParaView's menu. Its body may be any volume mesh, as for
 * vtkPVElasticCompliance. Settings and results are those of the superclass. All lengths except the
 * input's coordinates are in mm.
 */
#ifndef vtkPVScannedMaterial_h
#define vtkPVScannedMaterial_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "VolumeInput.h"                // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkScannedMaterial.h"

class PALPATESERVERMANAGER_EXPORT vtkPVScannedMaterial : public vtkScannedMaterial
{
public:
  static vtkPVScannedMaterial* New();
  vtkTypeMacro(vtkPVScannedMaterial, vtkScannedMaterial);

protected:
  vtkPVScannedMaterial() = default;
  ~vtkPVScannedMaterial() override = default;

private:
  vtkPVScannedMaterial(const vtkPVScannedMaterial&) = delete;
  void operator=(const vtkPVScannedMaterial&) = delete;

  palpateVolumeInputMacro();
};

#endif
