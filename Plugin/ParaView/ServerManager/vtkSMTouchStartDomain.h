// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMTouchStartDomain
 * @brief bounds of a body, and as default a good place to begin a touch
 *
 * As vtkSMBoundsDomain, for a DoubleVectorProperty of a position, beside a property ResponseName.
 * The default is the place of palpate::findTouchStart for the active view, or for one along -z; on
 * a body without a response the corner of the bounds, as in vtkSMBoundsDomain. With the attribute
 * `beside` it is to the right of that in the view, by this fraction of the body's diagonal.
 * Positions set by scripts, states and traces are not affected.
 */
#ifndef vtkSMTouchStartDomain_h
#define vtkSMTouchStartDomain_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkSMBoundsDomain.h"

class PALPATESERVERMANAGER_EXPORT vtkSMTouchStartDomain : public vtkSMBoundsDomain
{
public:
  static vtkSMTouchStartDomain* New();
  vtkTypeMacro(vtkSMTouchStartDomain, vtkSMBoundsDomain);

  int SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values) override;

protected:
  vtkSMTouchStartDomain() = default;
  ~vtkSMTouchStartDomain() override = default;
  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMTouchStartDomain(const vtkSMTouchStartDomain&) = delete;
  void operator=(const vtkSMTouchStartDomain&) = delete;

  double Beside = 0.0;
};

#endif
