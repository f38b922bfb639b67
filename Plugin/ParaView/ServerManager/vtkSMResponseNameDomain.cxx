// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMResponseNameDomain.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMStringVectorProperty.h"

#include <algorithm>

namespace
{
bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string text(const char* characters)
{
  return characters ? characters : "";
}
} // namespace

vtkStandardNewMacro(vtkSMResponseNameDomain);

//------------------------------------------------------------------------------
std::vector<std::string> vtkSMResponseNameDomain::FindResponses()
{
  std::vector<std::string> found;
  vtkPVDataInformation* input = this->GetInputDataInformation("Input");
  vtkPVDataSetAttributesInformation* arrays =
    input ? input->GetAttributeInformation(vtkDataObject::POINT) : nullptr;
  const std::string end = "Range";
  for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
  {
    const std::string name = text(arrays->GetArrayInformation(i)->GetName());
    if (name.size() <= end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0)
    {
      continue;
    }
    const std::string prefix = name.substr(0, name.size() - end.size());
    const auto has = [arrays, &prefix](const char* part)
    { return arrays->GetArrayInformation((prefix + part).c_str()) != nullptr; };
    if (has("Normal") && ((has("Force") && has("Stiffness")) || has("Coefficient")))
    {
      found.push_back(prefix);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
int vtkSMResponseNameDomain::IsInDomain(vtkSMProperty*)
{
  return IN_DOMAIN;
}

//------------------------------------------------------------------------------
void vtkSMResponseNameDomain::Update(vtkSMProperty*)
{
  std::vector<std::string> names = this->FindResponses();
  auto* property = vtkSMStringVectorProperty::SafeDownCast(this->GetProperty());
  if (property && property->GetNumberOfElements() == 1)
  {
    // The panel would reset a name that is not in its list. A name that a script has set must not
    // be reset.
    const std::string present = text(property->GetElement(0));
    const bool written = present != text(property->GetDefaultValue(0));
    if (!present.empty() && (written || names.empty()) && !contains(names, present))
    {
      names.push_back(present);
    }
  }
  this->SetStrings(names);
}

//------------------------------------------------------------------------------
int vtkSMResponseNameDomain::SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values)
{
  auto* name = vtkSMStringVectorProperty::SafeDownCast(property);
  if (!name || name->GetNumberOfElements() != 1)
  {
    return 0;
  }
  const std::vector<std::string> found = this->FindResponses();
  const std::string usual = text(name->GetDefaultValue(0));
  vtkSMPropertyHelper helper(name);
  helper.SetUseUnchecked(use_unchecked_values);
  helper.Set(0, found.empty() || contains(found, usual) ? usual.c_str() : found.front().c_str());
  return 1;
}
