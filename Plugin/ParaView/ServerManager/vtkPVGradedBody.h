// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVGradedBody
 * @brief any body filled with tetrahedra
 *
 * The class is the filter in ParaView's menu. Its body may be any surface or volume, composite or
 * not, in any unit of length; vtkBodySurface converts the body to triangles in mm. Settings and
 * results are those of the superclass. All lengths except the input's coordinates are in mm.
 */
#ifndef vtkPVGradedBody_h
#define vtkPVGradedBody_h

#include "BodyInput.h"                  // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkGradedBody.h"

class PALPATESERVERMANAGER_EXPORT vtkPVGradedBody : public vtkGradedBody
{
public:
  static vtkPVGradedBody* New();
  vtkTypeMacro(vtkPVGradedBody, vtkGradedBody);

protected:
  vtkPVGradedBody() = default;
  ~vtkPVGradedBody() override = default;

private:
  vtkPVGradedBody(const vtkPVGradedBody&) = delete;
  void operator=(const vtkPVGradedBody&) = delete;

  palpateBodyInputMacro();
};

#endif
