// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactToolSource.h"

#include "Response/Touch/ToolSurface.h"
#include "vtkContactTool.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkContactToolSource);

vtkContactToolSource::vtkContactToolSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkContactToolSource::~vtkContactToolSource() = default;

void vtkContactToolSource::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkContactToolSource::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkContactToolSource::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkContactToolSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const palpate::AxisymmetricTool* tool = this->Tool ? this->Tool->GetKernel() : nullptr;
  if (!tool || !(this->Length > 0.0) || !(this->MaximumRadius > 0.0))
  {
    vtkErrorMacro(<< (tool ? "Length and Maximum Radius must be positive."
                           : "A valid Tool is required (SetTool)."));
    return 0;
  }

  const std::string fault = palpate::makeToolSurface(*tool,
    { this->Length, this->MaximumRadius, this->Resolution }, vtkPolyData::GetData(outputVector));
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

void vtkContactToolSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "Length: " << this->Length << " mm\n";
  os << indent << "MaximumRadius: " << this->MaximumRadius << " mm\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
}
