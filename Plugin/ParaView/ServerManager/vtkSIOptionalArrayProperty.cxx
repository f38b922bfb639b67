// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSIOptionalArrayProperty.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMMessage.h"

#include <cstdlib>
#include <string>

namespace
{
// The elements are the arguments of SetInputArrayToProcess: index, port, connection, association,
// name.
constexpr int NumberOfElements = 5;
constexpr int NameElement = 4;

bool isNone(const std::string& name)
{
  return name.empty() || name == "None"; // the value of none_string in the XML
}
} // namespace

vtkStandardNewMacro(vtkSIOptionalArrayProperty);

bool vtkSIOptionalArrayProperty::Push(vtkSMMessage* message, int offset)
{
  const Variant& value = message->GetExtension(ProxyState::property, offset).value();
  if (value.txt_size() != NumberOfElements)
  {
    vtkErrorMacro(<< "Property '" << this->GetXMLName() << "' must have " << NumberOfElements
                  << " elements, but has " << value.txt_size() << ".");
    return false;
  }
  if (!isNone(value.txt(NameElement)))
  {
    return this->Superclass::Push(message, offset);
  }
  this->SaveValueToCache(message, offset);
  this->Forget(std::atoi(value.txt(0).c_str()));
  return true;
}

bool vtkSIOptionalArrayProperty::ReadXMLAttributes(vtkSIProxy* proxy, vtkPVXMLElement* element)
{
  // The superclass passes the default value, which is None.
  int index = 0;
  const bool read = this->Superclass::ReadXMLAttributes(proxy, element);
  if (read && element->GetScalarAttribute("default_values", &index))
  {
    this->Forget(index);
  }
  return read;
}

void vtkSIOptionalArrayProperty::Forget(int index)
{
  auto* filter = vtkAlgorithm::SafeDownCast(this->GetVTKObject());
  if (filter && filter->GetInputArrayInformation(index)->Has(vtkAlgorithm::INPUT_PORT()))
  {
    filter->GetInputArrayInformation(index)->Clear();
    filter->Modified();
  }
}
