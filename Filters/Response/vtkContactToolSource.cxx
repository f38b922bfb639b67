// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactToolSource.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Numerics/Constants.h"
#include "vtkContactTool.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRotationalExtrusionFilter.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr int ProfilePoints = 48; // and one more for each kink, at most

/// Radius where the drawn profile ends: its outer wall, however wide, or `maximum` if it widens for
/// ever.
double outerRadius(const palpate::AxisymmetricTool& tool, double maximum, double length)
{
  if (std::isfinite(tool.largestContactRadius()))
  {
    return tool.largestContactRadius();
  }
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

/// Radii to draw the profile at: its kinks, and between them points that crowd towards the outer
/// end, as a sphere's profile asks for.
std::vector<double> drawnRadii(const palpate::AxisymmetricTool& tool, double outer)
{
  std::vector<double> ends;
  for (const double kink : tool.kinks())
  {
    if (kink < outer)
    {
      ends.push_back(kink);
    }
  }
  ends.push_back(outer);
  std::vector<double> radii = { 0.0 };
  for (const double end : ends)
  {
    const double begin = radii.back();
    const int count =
      std::max(1, static_cast<int>(std::ceil(ProfilePoints * (end - begin) / outer)));
    for (int i = 1; i < count; ++i)
    {
      radii.push_back(begin + (end - begin) * std::sin(0.5 * palpate::Pi * i / count));
    }
    radii.push_back(end);
  }
  return radii;
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

  const double outer = outerRadius(*tool, this->MaximumRadius, this->Length);
  const double top = std::max(this->Length, tool->profile(outer) + 1e-3 * this->Length);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double r : drawnRadii(*tool, outer))
  {
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
  // The sweep ends beside its start and turns the axis into many points: merge them, or the shading
  // shows a seam.
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputConnection(triangles->GetOutputPort());
  merged->ToleranceIsAbsoluteOn();
  merged->SetAbsoluteTolerance(1e-6 * top);
  merged->ConvertPolysToLinesOff();
  merged->ConvertLinesToPointsOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(merged->GetOutputPort());
  normals->SetFeatureAngle(30.0);
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOn();
  normals->Update();
  if (!normals->GetOutput()->GetPointData()->GetNormals())
  {
    vtkErrorMacro(<< "A tool of Length " << this->Length << " mm and MaximumRadius "
                  << this->MaximumRadius << " mm has no surface: too far from its own size.");
    return 0;
  }
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
