// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ProbedTips_h
#define palpate_testing_ProbedTips_h

#include "TestBodies.h"

#include "vtkContactDeflection.h"
#include "vtkIdTypeArray.h"

#include <array>
#include <vector>

namespace palpate::testing
{
constexpr double Poisson = 0.3;

/// A contact for makeTips(), which gives tips in the form of the probe's output.
struct GivenContact
{
  vtkIdType cell;
  double depth;
  double point[3];
  double normal[3];
};

inline Body makeTips(const std::vector<GivenContact>& contacts)
{
  Body tips = Body::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> cells;
  vtkNew<vtkDoubleArray> depths;
  vtkNew<vtkDoubleArray> where;
  vtkNew<vtkDoubleArray> normals;
  cells->SetName("ContactCell");
  depths->SetName("Deflection");
  where->SetName("ContactPoint");
  where->SetNumberOfComponents(3);
  normals->SetName("Normal");
  normals->SetNumberOfComponents(3);
  for (const GivenContact& contact : contacts)
  {
    points->InsertNextPoint(contact.point);
    cells->InsertNextValue(contact.cell);
    depths->InsertNextValue(contact.depth);
    where->InsertNextTuple(contact.point);
    normals->InsertNextTuple(contact.normal);
  }
  tips->SetPoints(points);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ cells, depths, where, normals })
  {
    tips->GetPointData()->AddArray(array);
  }
  return tips;
}

inline vtkSmartPointer<vtkContactDeflection> makeFilter(
  vtkPolyData* body, vtkPolyData* tips, vtkContactTool* tool)
{
  auto filter = vtkSmartPointer<vtkContactDeflection>::New();
  filter->SetInputData(body);
  filter->SetTipData(tips);
  filter->SetTool(tool);
  filter->SetPoissonRatio(Poisson);
  return filter;
}

inline std::array<double, 3> displacement(vtkContactDeflection* filter, vtkIdType point)
{
  std::array<double, 3> u{};
  filter->GetOutput()->GetPointData()->GetArray("ContactDisplacement")->GetTuple(point, u.data());
  return u;
}

inline bool isZero(const std::array<double, 3>& u)
{
  return u[0] == 0.0 && u[1] == 0.0 && u[2] == 0.0;
}
} // namespace palpate::testing

#endif
