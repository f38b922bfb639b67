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
/// Returns `set`; if it is null, the tool that the response `name` of the body names. Returns null
/// and an error that names the missing part if the body names no tool.
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkContactTool> findTool(
  vtkContactTool* set, vtkPolyData* body, const std::string& name, std::string& error);
} // namespace palpate

#endif
