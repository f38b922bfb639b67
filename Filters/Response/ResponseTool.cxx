// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseTool.h"

#include "BodyConversion.h"
#include "vtkContactTool.h"

namespace palpate
{
vtkSmartPointer<vtkContactTool> findTool(
  vtkContactTool* set, vtkPolyData* body, const std::string& name, std::string& error)
{
  if (set)
  {
    return set;
  }
  const std::string specification = responseText(body, name, "Tool");
  auto named = vtkSmartPointer<vtkContactTool>::New();
  if (specification.empty() || !named->SetSpecification(specification))
  {
    error = "No Tool is set, and the field array '" + name + "Tool' names none";
    return nullptr;
  }
  return named;
}
} // namespace palpate
