// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/TiltConversion.h"

#include "Response/ArrayFetch.h"
#include "Response/BodyConversion.h"
#include "Response/ReplacedCurves.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
using TiltNumbers = std::array<double, 7>;

TiltNumbers numbersOf(const TiltTerms& terms)
{
  return { terms.range, terms.largest, terms.dropScale, static_cast<double>(terms.depths),
    static_cast<double>(terms.angles), static_cast<double>(terms.drops),
    static_cast<double>(terms.laws) };
}

/// Converts the numbers. Counts that are not whole numbers become 0, which is invalid.
TiltTerms termsOf(const TiltNumbers& numbers)
{
  const auto count = [&numbers](std::size_t which)
  {
    const double value = numbers[which];
    return value > 0.0 && value <= TiltTerms::MostNodes && value == std::floor(value)
      ? static_cast<int>(value)
      : 0;
  };
  return { numbers[0], numbers[1], numbers[2], count(3), count(4), count(5), count(6) };
}

template <class Values>
void addNumbers(
  vtkPolyData* body, const std::string& name, ResponseArray which, const Values& values)
{
  const int components = componentsOf(contractOf(which), 0, 0);
  vtkNew<vtkDoubleArray> array;
  array->SetName(arrayName(name, which).c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  body->GetFieldData()->AddArray(array);
}

/// The values of a field array of doubles with `tuples` tuples. Returns null and an error if type
/// or size is different.
const double* viewNumbers(vtkPolyData* body, const std::string& name, ResponseArray which,
  std::size_t tuples, std::string& error)
{
  const std::string full = arrayName(name, which);
  const int components = componentsOf(contractOf(which), 0, 0);
  vtkAbstractArray* found = body->GetFieldData()->GetAbstractArray(full.c_str());
  auto* array = vtkDoubleArray::SafeDownCast(found);
  if (array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == static_cast<vtkIdType>(tuples))
  {
    return array->GetPointer(0);
  }
  error = joined("field array '", full, "' must be double with ", components, " components and ",
    tuples, " tuples, but is ", found ? shapeOf(found) : "missing");
  return nullptr;
}
} // namespace

void describeTilts(vtkPolyData* body, const std::string& name, const TiltTable& table,
  const std::vector<float>& weights)
{
  removeArrays(body, name, ContractArray::Use::Tilt);
  addNumbers(body, name, ResponseArray::Tilt, numbersOf(table.terms()));
  addNumbers(body, name, ResponseArray::TiltDrop, table.drops());
  addNumbers(body, name, ResponseArray::TiltNode, table.nodes());
  if (!weights.empty())
  {
    addFloats(body, name, ResponseArray::TiltWeight, table.terms().laws, weights);
  }
}

bool viewTilts(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error)
{
  const std::string full = arrayName(name, ResponseArray::Tilt);
  if (!body->GetFieldData()->HasArray(full.c_str()))
  {
    return true;
  }
  const double* numbers = viewNumbers(body, name, ResponseArray::Tilt, 1, error);
  if (!numbers)
  {
    return false;
  }
  TiltNumbers copy{};
  std::copy_n(numbers, copy.size(), copy.begin());
  TiltViews& tilt = arrays.tilt;
  tilt.terms = termsOf(copy);
  error = faultOfTilts(tilt.terms);
  if (!error.empty())
  {
    error = "field array '" + full + "': " + error;
    return false;
  }
  tilt.drops = viewNumbers(
    body, name, ResponseArray::TiltDrop, static_cast<std::size_t>(tilt.terms.drops), error);
  tilt.nodes = tilt.drops
    ? viewNumbers(body, name, ResponseArray::TiltNode, TiltTable::nodeCount(tilt.terms) / 4, error)
    : nullptr;
  if (!tilt.nodes)
  {
    return false;
  }
  if (tilt.terms.laws > 1)
  {
    tilt.weight = fetchArray<vtkFloatArray>(body, name, ResponseArray::TiltWeight, arrays, error);
    if (!tilt.weight)
    {
      return false;
    }
  }
  error = faultOfTiltViews(tilt, arrays.points);
  if (!error.empty())
  {
    error = "tilts of '" + name + "': " + error;
  }
  return error.empty();
}
} // namespace palpate
