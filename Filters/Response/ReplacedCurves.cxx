// SPDX-License-Identifier: BSD-3-Clause
#include "Response/ReplacedCurves.h"

#include "Response/BodyConversion.h"

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
  // Own list, because ShallowCopy shares the field data of the original.
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(from->GetFieldData());
  to->SetFieldData(fields);
}

void removeCurves(vtkPolyData* body, const std::string& name)
{
  removeArrays(body, name, ContractArray::Use::PerPoint);
  removeArrays(body, name, ContractArray::Use::Compact);
}

void addFloats(vtkPolyData* body, const std::string& name, ResponseArray which, int components,
  const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(arrayName(name, which).c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  placeOf(contractOf(which), body)->AddArray(array);
}

void addText(
  vtkPolyData* body, const std::string& name, ResponseArray which, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(arrayName(name, which).c_str());
  array->InsertNextValue(text);
  body->GetFieldData()->AddArray(array);
}
} // namespace palpate
