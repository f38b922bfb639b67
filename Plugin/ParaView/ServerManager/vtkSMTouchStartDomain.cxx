// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMTouchStartDomain.h"

#include "TouchSight.h"
#include "vtkPVTouchStartInformation.h"

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <Eigen/Geometry>

#include <string>

namespace
{
/// Returns the name of the response for the touch. Before the user chooses one, it is the default
/// of its domain.
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

int vtkSMTouchStartDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  element->GetScalarAttribute("beside", &this->Offset);
  return this->Superclass::ReadXMLAttributes(property, element);
}

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
    const palpate::Sight sight = palpate::sightOf(ActiveViewOf(touch));
    start->Ask(static_cast<int>(body.GetOutputPort()), ResponseNameOf(touch), sight);
    // The source is updated here, because a script may not have updated it, and Touch needs the
    // body anyway.
    source->UpdatePipeline();
    source->GatherInformation(start);
    if (start->IsFound())
    {
      double bounds[6];
      source->GetDataInformation(body.GetOutputPort())->GetBounds(bounds);
      const vtkBoundingBox box(bounds);
      const palpate::Vector3 place = palpate::Vector3(start->GetStart()) +
        this->Offset * box.GetDiagonalLength() * sight.up.cross(sight.towards).normalized();
      vtkSMPropertyHelper helper(property);
      helper.SetUseUnchecked(use_unchecked_values);
      helper.Set(place.data(), 3);
      return 1;
    }
  }
  return this->Superclass::SetDefaultValues(property, use_unchecked_values);
}
