// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMTouchStartDomain
 * @brief bounds of a body to be touched, and by default a place where a touch begins well
 *
 * As vtkSMBoundsDomain, for a DoubleVectorProperty of a position, beside a property ResponseName.
 * The default is where palpate::findTouchStart begins, as the active view looks at the body, or
 * along -z without one; on a body without a response the corner of the bounds, as of
 * vtkSMBoundsDomain. With the attribute `beside` it lies beside that, to the right in the view, by
 * so much of the body's diagonal. Positions that are set by scripts, states and traces are not its
 * business.
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
