// SPDX-License-Identifier: BSD-3-Clause
#include "vtkForceMap.h"

#include "Contact/ResponseField.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/StoredError.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

namespace
{
/// Adds a point array with NaN at all points.
vtkFloatArray* addUnknown(const char* name, vtkPolyData* body)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfValues(body->GetNumberOfPoints());
  array->FillValue(std::numeric_limits<float>::quiet_NaN());
  body->GetPointData()->AddArray(array);
  return array;
}
} // namespace

vtkStandardNewMacro(vtkForceMap);

int vtkForceMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  if (!(this->Depth > 0.0 && std::isfinite(this->Depth)))
  {
    vtkErrorMacro(<< "Depth must be positive and finite (mm), but is " << this->Depth << ".");
    return 0;
  }
  std::string fault;
  const auto field = palpate::makeResponseField(body, this->ResponseName, fault);
  if (!field)
  {
    vtkErrorMacro(<< "Wrong body: " << fault << ".");
    return 0;
  }
  const palpate::StoredError errors(body, this->ResponseName);
  // The range is stored as a float. The depth is also rounded to float, so that a depth equal to
  // the range counts as within the range.
  const auto depth = static_cast<double>(static_cast<float>(this->Depth));
  output->ShallowCopy(body);
  vtkFloatArray* force = addUnknown("ForceAtDepth", output);
  vtkFloatArray* stiffness = addUnknown("StiffnessAtDepth", output);
  vtkFloatArray* error = errors.isKept() ? addUnknown("ErrorAtDepth", output) : nullptr;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    if (field->range(point) > 0.0 && depth <= field->range(point))
    {
      const palpate::ResponseValue value = field->evaluate(point, this->Depth);
      force->SetValue(i, static_cast<float>(value.force));
      stiffness->SetValue(i, static_cast<float>(value.stiffness));
      if (error)
      {
        error->SetValue(i, static_cast<float>(errors.at(i, this->Depth)));
      }
    }
  }
  output->GetPointData()->SetActiveScalars(force->GetName());
  return 1;
}

void vtkForceMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Depth: " << this->Depth << " mm\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}
