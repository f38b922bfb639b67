// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseTool_h
#define ResponseTool_h

#include "palpateResponseModule.h" // For export macro

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkContactTool;
class vtkPolyData;

namespace palpate
{
/// Returns `set` if it is not null. Otherwise returns the tool that is stored with the response
/// `name` of the body. If no tool is stored, returns null and an error that names the missing part.
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkContactTool> findTool(
  vtkContactTool* set, vtkPolyData* body, const std::string& name, std::string& error);
} // namespace palpate

#endif
