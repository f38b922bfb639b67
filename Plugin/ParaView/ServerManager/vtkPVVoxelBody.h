// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVVoxelBody
 * @brief any body filled with hexahedra
 *
 * The class is the filter in ParaView's menu. Its body may be any surface or volume, composite or
 * not, in any unit of length; vtkBodySurface converts the body to triangles in mm. Settings and
 * results are those of the superclass. All lengths except the input's coordinates are in mm.
 */
#ifndef vtkPVVoxelBody_h
#define vtkPVVoxelBody_h

#include "BodyInput.h"                  // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkVoxelBody.h"

class PALPATESERVERMANAGER_EXPORT vtkPVVoxelBody : public vtkVoxelBody
{
public:
  static vtkPVVoxelBody* New();
  vtkTypeMacro(vtkPVVoxelBody, vtkVoxelBody);

protected:
  vtkPVVoxelBody() = default;
  ~vtkPVVoxelBody() override = default;

private:
  vtkPVVoxelBody(const vtkPVVoxelBody&) = delete;
  void operator=(const vtkPVVoxelBody&) = delete;

  palpateBodyInputMacro();
};

#endif
