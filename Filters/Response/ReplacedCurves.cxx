// SPDX-License-Identifier: BSD-3-Clause
#include "Response/ReplacedCurves.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>

namespace palpate
{
void copyWithOwnFields(vtkPolyData* from, vtkPolyData* to)
{
  to->ShallowCopy(from);
  vtkNew<vtkFieldData> fields; // ShallowCopy shares the other's
  fields->ShallowCopy(from->GetFieldData());
  to->SetFieldData(fields);
}

void removeCurves(vtkPolyData* body, const std::string& name)
{
  for (const char* array : { "Force", "Stiffness", "Coefficient" })
  {
    body->GetPointData()->RemoveArray((name + array).c_str());
  }
  body->GetFieldData()->RemoveArray((name + "Basis").c_str());
}

void addFloats(
  vtkFieldData* data, const std::string& name, int components, const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

void addText(vtkFieldData* data, const std::string& name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(text);
  data->AddArray(array);
}
} // namespace palpate
