// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVElasticCompliance
 * @brief the compliance of any volume
 *
 * The class is the filter in ParaView's menu. Its body may be any volume mesh, in any unit of
 * length. Blocks and partitions are joined where their points coincide exactly. For a surface, the
 * filter reports an error that names the filter Voxel Body. Settings and results are those of the
 * superclass. All lengths except the input's coordinates are in mm.
 */
#ifndef vtkPVElasticCompliance_h
#define vtkPVElasticCompliance_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "VolumeInput.h"                // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkElasticCompliance.h"

class PALPATESERVERMANAGER_EXPORT vtkPVElasticCompliance : public vtkElasticCompliance
{
public:
  static vtkPVElasticCompliance* New();
  vtkTypeMacro(vtkPVElasticCompliance, vtkElasticCompliance);

protected:
  vtkPVElasticCompliance() = default;
  ~vtkPVElasticCompliance() override = default;

private:
  vtkPVElasticCompliance(const vtkPVElasticCompliance&) = delete;
  void operator=(const vtkPVElasticCompliance&) = delete;

  palpateVolumeInputMacro();
};

#endif
