// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMResponseNameDomain
 * @brief the names of a body's responses, to choose from
 *
 * This domain is for a StringVectorProperty of one element that names a response. The panel offers
 * the responses found on the input that the XML requires as function "Input": every prefix p with
 * the point arrays `<p>Range`, `<p>Normal` and either `<p>Force` and `<p>Stiffness` or
 * `<p>Coefficient`.
 *
 * The default is the name in the XML if the body has a response of this name, otherwise the body's
 * first response. A name that a script or a state has set is kept and offered even if the body has
 * no such response; then the filter reports the missing response. While no response is found,
 * because the input is not computed yet, the present name is the only choice.
 *
 * @verbatim
 * <ResponseNameDomain name="responses">
 *   <RequiredProperties><Property name="Input" function="Input" /></RequiredProperties>
 * </ResponseNameDomain>
 * @endverbatim
 */
#ifndef vtkSMResponseNameDomain_h
#define vtkSMResponseNameDomain_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkSMStringListDomain.h"

#include <string> // For std::string
#include <vector> // For std::vector

class PALPATESERVERMANAGER_EXPORT vtkSMResponseNameDomain : public vtkSMStringListDomain
{
public:
  static vtkSMResponseNameDomain* New();
  vtkTypeMacro(vtkSMResponseNameDomain, vtkSMStringListDomain);

  using vtkSMStringListDomain::IsInDomain;
  /** Accepts any name. */
  int IsInDomain(vtkSMProperty* property) override;

  void Update(vtkSMProperty* property) override;
  int SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values) override;

protected:
  vtkSMResponseNameDomain() = default;
  ~vtkSMResponseNameDomain() override = default;

private:
  vtkSMResponseNameDomain(const vtkSMResponseNameDomain&) = delete;
  void operator=(const vtkSMResponseNameDomain&) = delete;

  std::vector<std::string> FindResponses();
};

#endif
