// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRepresentationLook.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMTransferFunctionManager.h"

#include <cstring>
#include <sstream>
#include <vector>

namespace
{
std::vector<double> numbersOf(vtkPVXMLElement* element, const char* attribute)
{
  std::istringstream text(element->GetAttributeOrEmpty(attribute));
  std::vector<double> numbers;
  for (double number = 0.0; text >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

void setNumbers(vtkSMProxy* proxy, const char* property, const std::vector<double>& numbers)
{
  vtkSMPropertyHelper helper(proxy, property);
  const bool isInteger = vtkSMIntVectorProperty::SafeDownCast(proxy->GetProperty(property));
  helper.SetNumberOfElements(static_cast<unsigned int>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto index = static_cast<unsigned int>(i);
    isInteger ? helper.Set(index, static_cast<int>(numbers[i])) : helper.Set(index, numbers[i]);
  }
}

void setColors(vtkSMProxy* representation, vtkPVXMLElement* element)
{
  const char* array = element->GetAttributeOrEmpty("array");
  vtkSMSessionProxyManager* proxies = representation->GetSessionProxyManager();
  const unsigned int before = proxies->GetNumberOfProxies("lookup_tables");
  vtkNew<vtkSMTransferFunctionManager> maps;
  vtkSMProxy* map = maps->GetColorTransferFunction(array, proxies);
  if (proxies->GetNumberOfProxies("lookup_tables") == before)
  {
    return; // the map exists already
  }
  setNumbers(map, "RGBPoints", numbersOf(element, "points"));
  vtkSMPropertyHelper(map, "ColorSpace")
    .Set(VTK_CTF_LAB); // the default differs between versions of ParaView
  map->UpdateVTKObjects();
}
} // namespace

vtkStandardNewMacro(vtkSMRepresentationLook);

void vtkSMRepresentationLook::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType)
{
  for (unsigned int i = 0; i < xml->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = xml->GetNestedElement(i);
    if (std::strcmp(element->GetName(), "Look") == 0)
    {
      setNumbers(proxy, element->GetAttributeOrEmpty("property"), numbersOf(element, "values"));
    }
    else if (std::strcmp(element->GetName(), "ColorMap") == 0)
    {
      setColors(proxy, element);
    }
  }
  proxy->UpdateVTKObjects();
}
