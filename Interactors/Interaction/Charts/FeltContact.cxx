// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/FeltContact.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>

namespace palpate
{
FeltContact::FeltContact(const ServoTick& tick)
  : time(tick.time)
  , ideal(tick.idealForce.norm())
  , applied(tick.appliedForce.norm())
  , friction(tick.contact.friction.norm())
  , normalForce(tick.contact.normalForce)
  , deflection(tick.contact.deflection)
  , triangle(tick.contact.triangle)
  , contactPoint(tick.contact.contactPoint)
{
}

FeltTips::FeltTips(vtkPolyData* probed)
  : Data(probed->GetPointData())
{
}

bool FeltTips::isComplete() const
{
  const char* const needed[] = { "Force", "NormalForce", "Deflection", "ContactPoint",
    "ContactCell" };
  return std::all_of(std::begin(needed), std::end(needed),
    [this](const char* name) { return this->Data->GetArray(name) != nullptr; });
}

FeltContact FeltTips::at(vtkIdType index, vtkIdType firstPoly) const
{
  FeltContact felt;
  felt.time = this->number("Time", index, FeltContact::None);
  felt.ideal = this->length("Force", index, 0.0);
  felt.applied = this->length("AppliedForce", index, FeltContact::None);
  felt.friction = this->length("FrictionForce", index, 0.0);
  felt.normalForce = this->number("NormalForce", index, 0.0);
  felt.deflection = this->number("Deflection", index, 0.0);
  felt.triangle = static_cast<vtkIdType>(this->number("ContactCell", index, -1.0)) - firstPoly;
  this->Data->GetArray("ContactPoint")->GetTuple(index, felt.contactPoint.data());
  return felt;
}

double FeltTips::number(const char* name, vtkIdType index, double otherwise) const
{
  vtkDataArray* array = this->Data->GetArray(name);
  return array ? array->GetTuple1(index) : otherwise;
}

double FeltTips::length(const char* name, vtkIdType index, double otherwise) const
{
  vtkDataArray* array = this->Data->GetArray(name);
  return array ? vtkMath::Norm(array->GetTuple3(index)) : otherwise;
}
} // namespace palpate
