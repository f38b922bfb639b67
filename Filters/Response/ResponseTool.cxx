// SPDX-License-Identifier: BSD-3-Clause
#include "Response/ResponseTool.h"

#include "Response/BodyConversion.h"
#include "Mechanics/Tools/ToolSpecification.h"
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
  const std::string specification = responseText(body, name, ResponseArray::Tool);
  ToolSpecification known;
  std::string reason;
  if (specification.empty() || !parseTool(specification, known, reason))
  {
    error = "No Tool is set, and the field array '" + name + "Tool' names none" +
      (reason.empty() ? "" : ": ") + reason;
    return nullptr;
  }
  auto named = vtkSmartPointer<vtkContactTool>::New();
  named->SetSpecification(specification);
  return named;
}
} // namespace palpate
