// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/ResponseStorage.h"

#include "Contact/ResponseContract.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <initializer_list>

namespace palpate
{
namespace
{
void allocate(vtkDataArray* array, const std::string& name, int components, vtkIdType tuples)
{
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
}
} // namespace

ResponseStorage::ResponseStorage(
  const std::string& name, vtkIdType points, int samples, bool keepsError)
{
  allocate(this->Force.Get(), arrayName(name, ResponseArray::Force), samples, points);
  allocate(this->Stiffness.Get(), arrayName(name, ResponseArray::Stiffness), samples, points);
  allocate(this->Normal.Get(), arrayName(name, ResponseArray::Normal), 3, points);
  allocate(this->Range.Get(), arrayName(name, ResponseArray::Range), 1, points);
  allocate(this->Validity.Get(), arrayName(name, ResponseArray::Validity), 1, points);
  allocate(this->Status.Get(), arrayName(name, ResponseArray::Status), 1, points);
  allocate(this->LimitReached.Get(), arrayName(name, ResponseArray::Limit), 1, points);
  if (keepsError)
  {
    this->Error = vtkSmartPointer<vtkFloatArray>::New();
    allocate(this->Error, arrayName(name, ResponseArray::Error), samples, points);
  }
}

void ResponseStorage::setNormals(
  const std::vector<float>& normals, const std::vector<unsigned char>& status)
{
  std::copy(normals.begin(), normals.end(), this->Normal->GetPointer(0));
  std::copy(status.begin(), status.end(), this->Status->GetPointer(0));
}

ResponseSpans ResponseStorage::spans()
{
  return { this->Force->GetNumberOfComponents(), this->Force->GetPointer(0),
    this->Stiffness->GetPointer(0), this->Range->GetPointer(0), this->Validity->GetPointer(0),
    this->Status->GetPointer(0), this->LimitReached->GetPointer(0),
    this->Error ? this->Error->GetPointer(0) : nullptr };
}

void ResponseStorage::attach(vtkPolyData* output)
{
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ this->Force, this->Stiffness,
         this->Normal, this->Range, this->Validity, this->Status, this->LimitReached })
  {
    output->GetPointData()->AddArray(array);
  }
  if (this->Error)
  {
    output->GetPointData()->AddArray(this->Error);
  }
}
} // namespace palpate
