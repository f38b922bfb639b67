// SPDX-License-Identifier: BSD-3-Clause
#include "Response/ContactArrays.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <initializer_list>

namespace palpate
{
namespace
{
void allocate(vtkDataArray* array, const char* name, int components, vtkIdType tips)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tips);
}
} // namespace

ContactArrays::ContactArrays(vtkIdType tips, bool relaxes, bool hasAxes)
{
  allocate(this->Force.Get(), "Force", 3, tips);
  allocate(this->NormalForce.Get(), "NormalForce", 1, tips);
  allocate(this->FrictionForce.Get(), "FrictionForce", 3, tips);
  allocate(this->Deflection.Get(), "Deflection", 1, tips);
  allocate(this->Normal.Get(), "Normal", 3, tips);
  allocate(this->ContactPoint.Get(), "ContactPoint", 3, tips);
  allocate(this->ContactCell.Get(), "ContactCell", 1, tips);
  allocate(this->ContactState.Get(), "ContactState", 1, tips);
  if (relaxes)
  {
    this->MemoryForce = vtkSmartPointer<vtkDoubleArray>::New();
    allocate(this->MemoryForce, "MemoryForce", 1, tips);
  }
  if (hasAxes)
  {
    this->Torque = vtkSmartPointer<vtkDoubleArray>::New();
    allocate(this->Torque, "Torque", 3, tips);
    this->Tilt = vtkSmartPointer<vtkDoubleArray>::New();
    allocate(this->Tilt, "Tilt", 1, tips);
  }
}

void ContactArrays::store(vtkIdType tip, const Contact& contact, vtkIdType firstPoly)
{
  this->Force->SetTypedTuple(tip, contact.force.data());
  this->NormalForce->SetValue(tip, contact.normalForce);
  this->FrictionForce->SetTypedTuple(tip, contact.friction.data());
  this->Deflection->SetValue(tip, contact.deflection);
  this->Normal->SetTypedTuple(tip, contact.normal.data());
  this->ContactPoint->SetTypedTuple(tip, contact.contactPoint.data());
  this->ContactCell->SetValue(
    tip, contact.triangle < 0 ? -1 : firstPoly + static_cast<vtkIdType>(contact.triangle));
  this->ContactState->SetValue(tip, static_cast<unsigned char>(contact.state));
  if (this->MemoryForce)
  {
    this->MemoryForce->SetValue(tip, contact.memory);
  }
  if (this->Torque)
  {
    this->Torque->SetTypedTuple(tip, contact.torque.data());
    this->Tilt->SetValue(tip, vtkMath::DegreesFromRadians(contact.tilt));
  }
}

void ContactArrays::attach(vtkPolyData* tips)
{
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ this->Force, this->NormalForce, this->FrictionForce,
      this->Deflection, this->Normal, this->ContactPoint, this->ContactCell, this->ContactState })
  {
    tips->GetPointData()->AddArray(array);
  }
  if (this->MemoryForce)
  {
    tips->GetPointData()->AddArray(this->MemoryForce);
  }
  if (this->Torque)
  {
    tips->GetPointData()->AddArray(this->Torque);
    tips->GetPointData()->AddArray(this->Tilt);
  }
}
} // namespace palpate
