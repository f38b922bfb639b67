// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolFilter.h"

#include "vtkContactTool.h"

#include <algorithm>

vtkToolFilter::vtkToolFilter() = default;
vtkToolFilter::~vtkToolFilter() = default;

void vtkToolFilter::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkToolFilter::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkToolFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkToolFilter::Report(const std::string& fault)
{
  if (fault.empty())
  {
    return 1;
  }
  vtkErrorMacro(<< fault << ".");
  return 0;
}

void vtkToolFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}
