// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSIOptionalArrayProperty
 * @brief an optional input array to process
 *
 * The XML selects this class by si_class for a StringVectorProperty of five elements with the
 * command SetInputArrayToProcess. ParaView would pass the choice "None" to the filter as the name
 * of an array. This class instead resets the array with this index in the filter, as if it had
 * never been set. An empty name (None in Python) has the same effect.
 */
#ifndef vtkSIOptionalArrayProperty_h
#define vtkSIOptionalArrayProperty_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkSIStringVectorProperty.h"

class PALPATESERVERMANAGER_EXPORT vtkSIOptionalArrayProperty : public vtkSIStringVectorProperty
{
public:
  static vtkSIOptionalArrayProperty* New();
  vtkTypeMacro(vtkSIOptionalArrayProperty, vtkSIStringVectorProperty);

protected:
  vtkSIOptionalArrayProperty() = default;
  ~vtkSIOptionalArrayProperty() override = default;

  bool Push(vtkSMMessage* message, int offset) override;
  bool ReadXMLAttributes(vtkSIProxy* proxy, vtkPVXMLElement* element) override;

private:
  vtkSIOptionalArrayProperty(const vtkSIOptionalArrayProperty&) = delete;
  void operator=(const vtkSIOptionalArrayProperty&) = delete;

  void Forget(int index);
};

#endif
