// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVNoduleDetectability
 * @brief detectability of nodules by the change of the force, on any volume
 *
 * The class is the filter in ParaView's menu. Its body may be any volume mesh, as for
 * vtkPVElasticCompliance. Settings and results are those of the superclass. All lengths except the
 * input's coordinates are in mm.
 */
#ifndef vtkPVNoduleDetectability_h
#define vtkPVNoduleDetectability_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "VolumeInput.h"                // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkNoduleDetectability.h"

class PALPATESERVERMANAGER_EXPORT vtkPVNoduleDetectability : public vtkNoduleDetectability
{
public:
  static vtkPVNoduleDetectability* New();
  vtkTypeMacro(vtkPVNoduleDetectability, vtkNoduleDetectability);

protected:
  vtkPVNoduleDetectability() = default;
  ~vtkPVNoduleDetectability() override = default;

private:
  vtkPVNoduleDetectability(const vtkPVNoduleDetectability&) = delete;
  void operator=(const vtkPVNoduleDetectability&) = delete;

  palpateVolumeInputMacro();
};

#endif
