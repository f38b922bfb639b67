// SPDX-License-Identifier: BSD-3-Clause
#ifndef ArrayFetch_h
#define ArrayFetch_h

#include "Contact/ResponseField.h"
#include "Mechanics/JoinedText.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace palpate
{
/// Returns the type and the shape of an array as text, for example "float with 3 components and 20
/// tuples".
inline std::string shapeOf(vtkAbstractArray* array)
{
  return joined(array->GetDataTypeAsString(), " with ", array->GetNumberOfComponents(),
    " components and ", array->GetNumberOfTuples(), " tuples");
}

/// Returns a pointer to the values of a response array. Returns null and an error unless the array
/// has exactly the type and shape of the contract.
template <class Array>
const typename Array::ValueType* fetchArray(vtkPolyData* body, const std::string& name,
  ResponseArray which, const ResponseArrays& arrays, std::string& error)
{
  const ContractArray& contract = contractOf(which);
  const std::string full = contract.named(name);
  const int components = componentsOf(contract, arrays.samples, arrays.laws,
    static_cast<int>(arrays.relaxation.series.count), arrays.coupling.modeCount,
    arrays.tilt.terms.laws);
  const vtkIdType tuples = which == ResponseArray::Basis ? arrays.laws : body->GetNumberOfPoints();
  vtkFieldData* data =
    contract.place == ContractArray::Place::Points ? body->GetPointData() : body->GetFieldData();
  vtkAbstractArray* found = data->GetAbstractArray(full.c_str());
  if (!found)
  {
    error = "array '" + full + "' is missing";
    return nullptr;
  }
  Array* array = Array::FastDownCast(found);
  if (!array || array->GetNumberOfComponents() != components ||
    array->GetNumberOfTuples() != tuples)
  {
    const char* type = contract.type == ContractArray::Type::Float ? "float" : "unsigned char";
    error = joined("array '", full, "' must be ", type, " with ", components, " components and ",
      tuples, " tuples, but is ", shapeOf(found));
    return nullptr;
  }
  return array->GetPointer(0);
}
} // namespace palpate

#endif
