// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMRepresentationLook
 * @brief the look of a representation when it is first shown
 *
 * An initialization helper for representations of ParaView. It replaces some values that the
 * palette and the user's settings would otherwise determine:
 *
 * @verbatim
 * <Hints>
 *   <InitializationHelper class="vtkSMRepresentationLook">
 *     <Look property="Opacity" values="0.4" />
 *     <ColorMap array="Dent (mm)" points="0 0.9 0.9 0.8  1 0.1 0 0.3" />
 *   </InitializationHelper>
 * </Hints>
 * @endverbatim
 *
 * Look sets a property to the given numbers. ColorMap sets position, red, green and blue of each
 * colour in the colour map of the given array. An existing colour map is not changed.
 */
#ifndef vtkSMRepresentationLook_h
#define vtkSMRepresentationLook_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkSMProxyInitializationHelper.h"

class PALPATESERVERMANAGER_EXPORT vtkSMRepresentationLook : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMRepresentationLook* New();
  vtkTypeMacro(vtkSMRepresentationLook, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType time) override;

protected:
  vtkSMRepresentationLook() = default;
  ~vtkSMRepresentationLook() override = default;

private:
  vtkSMRepresentationLook(const vtkSMRepresentationLook&) = delete;
  void operator=(const vtkSMRepresentationLook&) = delete;
};

#endif
