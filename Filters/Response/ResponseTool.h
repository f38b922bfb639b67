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
/// `set`, or if that is null the tool named by the response `name` of the body. Null, and what is
/// missing, if there is none.
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkContactTool> findTool(
  vtkContactTool* set, vtkPolyData* body, const std::string& name, std::string& error);
} // namespace palpate

#endif
