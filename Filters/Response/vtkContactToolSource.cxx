// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactToolSource.h"

#include "AxisymmetricTool.h"
#include "vtkContactTool.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRotationalExtrusionFilter.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int ProfilePoints = 48;

/// Radius where the drawn profile ends: its outer wall, or `maximum` if it widens for ever.
double outerRadius(const palpate::AxisymmetricTool& tool, double maximum, double length)
{
  double inside = 0.0;
  double outside = maximum;
  const auto fits = [&](double r) { return tool.profile(r) <= 0.9 * length; };
  if (fits(outside))
  {
    return outside;
  }
  for (int i = 0; i < 80; ++i)
  {
    const double middle = 0.5 * (inside + outside);
    (fits(middle) ? inside : outside) = middle;
  }
  return inside;
}
} // namespace

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
    vtkErrorMacro(<< (tool ? "Length and MaximumRadius must be positive."
                           : "A valid Tool is required: call SetTool."));
    return 0;
  }

  // A tool with a wall is drawn to its wall, however wide.
  const int shape = this->Tool->GetShape();
  const bool walled = shape == vtkContactTool::Flat || shape == vtkContactTool::Sphere;
  const double outer =
    walled ? this->Tool->GetRadius() : outerRadius(*tool, this->MaximumRadius, this->Length);
  const double top = std::max(this->Length, tool->profile(outer) + 1e-3 * this->Length);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i <= ProfilePoints; ++i)
  {
    // Sine spacing puts points where a sphere's profile turns steep.
    const double r = i == ProfilePoints ? outer : outer * std::sin(0.5 * Pi * i / ProfilePoints);
    points->InsertNextPoint(r, 0.0, tool->profile(r));
  }
  points->InsertNextPoint(outer, 0.0, top);
  points->InsertNextPoint(0.0, 0.0, top);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    line->InsertCellPoint(i);
  }
  vtkNew<vtkPolyData> profile;
  profile->SetPoints(points);
  profile->SetLines(line);

  vtkNew<vtkRotationalExtrusionFilter> turn;
  turn->SetInputData(profile);
  turn->SetResolution(this->Resolution);
  turn->CappingOff();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(turn->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(triangles->GetOutputPort());
  normals->SetFeatureAngle(30.0);
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOn();
  normals->Update();
  vtkPolyData::GetData(outputVector)->ShallowCopy(normals->GetOutput());
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
