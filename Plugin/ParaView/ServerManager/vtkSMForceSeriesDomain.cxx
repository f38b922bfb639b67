// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMForceSeriesDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"

vtkStandardNewMacro(vtkSMForceSeriesDomain);

int vtkSMForceSeriesDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  const char* measured = element->GetAttribute("measured_value");
  this->MeasuredValue = measured ? measured : "";
  return this->Superclass::ReadXMLAttributes(property, element);
}

bool vtkSMForceSeriesDomain::GetDefaultSeriesVisibility(const char* series)
{
  const std::string name = series ? series : "";
  const std::string unit = "(N)";
  return name.size() > unit.size() &&
    name.compare(name.size() - unit.size(), unit.size(), unit) == 0;
}

std::vector<std::string> vtkSMForceSeriesDomain::GetDefaultValue(const char* series)
{
  const std::string name = series ? series : "";
  if (this->DefaultMode == VALUE && !this->MeasuredValue.empty() &&
    name.find(" measured") != std::string::npos)
  {
    return { this->MeasuredValue };
  }
  return this->Superclass::GetDefaultValue(series);
}
