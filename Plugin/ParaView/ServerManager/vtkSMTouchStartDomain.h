// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMTouchStartDomain
 * @brief bounds of a body, and a good starting point of a touch as the default
 *
 * The class extends vtkSMBoundsDomain for a DoubleVectorProperty of a position whose proxy also has
 * a property ResponseName. The default is the point that palpate::findTouchStart finds for the
 * active view, or for a view along -z if there is no active view. For a body without a response,
 * the default is the corner of the bounds, as in vtkSMBoundsDomain. The attribute `beside` moves
 * the default to the right in the view, by this fraction of the body's diagonal. Positions set by
 * scripts, states and traces are not affected.
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

  double Offset = 0.0;
};

#endif
