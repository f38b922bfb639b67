// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMTouchStartDomain.h"

#include "TouchSight.h"
#include "vtkPVTouchStartInformation.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <string>

namespace
{
/// The response that will be touched: at first the default of its own domain.
std::string ResponseNameOf(vtkSMProxy* touch)
{
  vtkSMProperty* property = touch->GetProperty("ResponseName");
  const char* set = property ? vtkSMPropertyHelper(property).GetAsString() : nullptr;
  const std::string name = set ? set : "";
  auto* known = property ? property->FindDomain<vtkSMStringListDomain>() : nullptr;
  unsigned int index = 0;
  const bool isStrange =
    known && known->GetNumberOfStrings() > 0 && !known->IsInDomain(name.c_str(), index);
  return isStrange ? known->GetString(0) : name;
}

vtkSMProxy* ActiveViewOf(vtkSMProxy* proxy)
{
  vtkSMSessionProxyManager* manager = proxy->GetSessionProxyManager();
  vtkSMProxySelectionModel* views = manager ? manager->GetSelectionModel("ActiveView") : nullptr;
  return views ? views->GetCurrentProxy() : nullptr;
}
} // namespace

vtkStandardNewMacro(vtkSMTouchStartDomain);

int vtkSMTouchStartDomain::SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values)
{
  vtkSMProxy* touch = property->GetParent();
  vtkSMProperty* input = this->GetRequiredProperty("Input");
  vtkSMUncheckedPropertyHelper body(input, true);
  auto* source = input && body.GetNumberOfElements() > 0
    ? vtkSMSourceProxy::SafeDownCast(body.GetAsProxy())
    : nullptr;
  if (touch && source)
  {
    vtkNew<vtkPVTouchStartInformation> start;
    start->Ask(static_cast<int>(body.GetOutputPort()), ResponseNameOf(touch),
      palpate::sightOf(ActiveViewOf(touch)));
    source->UpdatePipeline(); // a script may not have; Touch needs the body anyway
    source->GatherInformation(start);
    if (start->IsFound())
    {
      vtkSMPropertyHelper helper(property);
      helper.SetUseUnchecked(use_unchecked_values);
      helper.Set(start->GetStart(), 3);
      return 1;
    }
  }
  return this->Superclass::SetDefaultValues(property, use_unchecked_values);
}
