// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_RelaxingPlane_h
#define palpate_testing_RelaxingPlane_h

#include "TestBodies.h"

#include "vtkFieldData.h"

namespace palpate::testing
{
using Filter = vtkSmartPointer<vtkToolContactResponse>;

constexpr int Strengths = 5; ///< index of the array to process

inline void addValues(
  vtkPolyData* body, const char* name, int components, double first, double step)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(body->GetNumberOfPoints());
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, first + step * static_cast<double>(i));
  }
  body->GetPointData()->AddArray(array);
}

/// A plane with the arrays GlobalCompliance and Strengths (two components).
inline Body bodyWithArrays()
{
  Body body = planeBody(20.0, 8);
  addValues(body, "GlobalCompliance", 1, 0.1, 0.01);
  addValues(body, "Strengths", 2, 0.25, 0.125);
  return body;
}

inline Filter relaxing(vtkPolyData* body, const char* tool = "sphere:5", double first = 0.5)
{
  Filter filter = filterOf(body, tool, 1.0);
  filter->AddRelaxation(first, 0.1);
  filter->AddRelaxation(0.6 * first, 2.0);
  return filter;
}

inline Filter everything(vtkPolyData* body)
{
  Filter filter = relaxing(body);
  filter->SetInputArrayToProcess(2, 0, 0, 0, "GlobalCompliance");
  filter->SetInputArrayToProcess(Strengths, 0, 0, 0, "Strengths");
  filter->ComplianceRelaxesOff();
  return filter;
}

inline vtkDataArray* fieldOf(vtkPolyData* body, const char* name)
{
  return body->GetFieldData()->GetArray(name);
}
} // namespace palpate::testing

#endif
