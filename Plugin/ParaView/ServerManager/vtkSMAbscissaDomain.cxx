// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMAbscissaDomain.h"

#include "vtkForceChartRepresentation.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"

vtkStandardNewMacro(vtkSMAbscissaDomain);

void vtkSMAbscissaDomain::PopulateArrayComponents(
  vtkPVArrayInformation* array, std::vector<std::string>& names)
{
  if (names.empty())
  {
    names.emplace_back(vtkForceChartRepresentation::GetFirstColumn());
  }
  this->Superclass::PopulateArrayComponents(array, names);
}

int vtkSMAbscissaDomain::SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values)
{
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(use_unchecked_values);
  helper.Set(vtkForceChartRepresentation::GetFirstColumn());
  return 1;
}
