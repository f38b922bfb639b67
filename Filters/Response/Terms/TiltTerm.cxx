// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Laws/BodyMaterial.h"
#include "Laws/MaterialTilts.h"
#include "Laws/TiltValidity.h"
#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltNodes.h"
#include "Response/ArrayFetch.h"
#include "Response/BodyConversion.h"
#include "Response/ReplacedCurves.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

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

/// Converts stored numbers to terms. A count that is not a whole number is converted to 0, which is
/// invalid.
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

/// Returns the values of a field array of doubles with `tuples` tuples. Returns null and an error
/// if type or size differs.
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

double radians(const LawRequest& request)
{
  return request.terms.tilt * Pi / 180.0;
}

/// Attaches the numbers of a table as arrays. `weights` contains the weight of each law at each
/// point. It is empty if the table has one law.
void addTable(vtkPolyData* body, const std::string& name, const TiltTable& table,
  const std::vector<float>& weights)
{
  addNumbers(body, name, ResponseArray::Tilt, numbersOf(table.terms()));
  addNumbers(body, name, ResponseArray::TiltDrop, table.drops());
  addNumbers(body, name, ResponseArray::TiltNode, table.nodes());
  if (!weights.empty())
  {
    addFloats(body, name, ResponseArray::TiltWeight, table.terms().laws, weights);
  }
}

MaterialTilts tiltsIn(const TermBody& response, std::size_t points)
{
  const double range = response.request.deflection;
  if (response.material)
  {
    return tiltsOf(response.tool, range, radians(response.request), response.material->range(),
      response.material->spots(), points);
  }
  MadeTilt made = makeTiltTable(response.tool, range, radians(response.request), { TiltBody{} });
  MaterialTilts tilts;
  tilts.table = std::move(made.table);
  tilts.fault = std::move(made.fault);
  return tilts;
}

/// The effect of the tool's tilt on the force. The arrays Tilt, TiltDrop, TiltNode and TiltWeight
/// contain the numbers of a TiltTable. Without these arrays, the tool counts as upright for any
/// direction of its axis. For a response of the true shape, the table is that of a half-space, and
/// the term does not change the validity.
class TiltTerm : public LawTerm
{
public:
  bool isAsked(const LawRequest& request) const override;
  std::string check(const TermBody& response, vtkPolyData* piece) const override;
  std::string make(const TermBody& response, vtkPolyData* output) const override;
  std::string limit(const TermBody& response, vtkPolyData* output) const override;
  bool view(vtkPolyData* body, const std::string& name, ResponseArrays& arrays,
    std::string& error) const override;
  void describe(
    vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const override;
};
} // namespace

bool TiltTerm::isAsked(const LawRequest& request) const
{
  return request.terms.tilt > 0.0;
}

std::string TiltTerm::check(const TermBody& response, vtkPolyData*) const
{
  const double degrees = response.request.terms.tilt;
  if (!(degrees >= 0.0 && std::isfinite(degrees)))
  {
    return joined("Maximum Tilt must be finite and not negative (degrees), but is ", degrees);
  }
  return degrees > 0.0
    ? prefixed("Maximum Tilt: ", checkTilt(response.tool, radians(response.request)))
    : std::string();
}

std::string TiltTerm::make(const TermBody& response, vtkPolyData* output) const
{
  const MaterialTilts tilts =
    tiltsIn(response, static_cast<std::size_t>(output->GetNumberOfPoints()));
  if (tilts.fault.empty())
  {
    addTable(output, response.request.responseName, tilts.table, tilts.weights);
  }
  return prefixed("Maximum Tilt: ", tilts.fault);
}

std::string TiltTerm::limit(const TermBody& response, vtkPolyData* output) const
{
  const double tolerance = response.request.terms.errorTolerance;
  const std::string& name = response.request.responseName;
  ResponseArrays arrays;
  std::string fault;
  if (!response.material || tolerance == 0.0 || !viewResponse(output, name, arrays, fault))
  {
    return fault;
  }
  vtkPointData* data = output->GetPointData();
  const auto floats = [&](ResponseArray which) -> float*
  {
    auto* array = vtkFloatArray::SafeDownCast(data->GetArray(arrayName(name, which).c_str()));
    return array ? array->GetPointer(0) : nullptr;
  };
  auto* limits = vtkUnsignedCharArray::SafeDownCast(
    data->GetArray(arrayName(name, ResponseArray::Limit).c_str()));
  limitByTilts(response.tool, response.material->spots(), arrays, tolerance,
    { floats(ResponseArray::Validity), limits->GetPointer(0), floats(ResponseArray::Error) });
  return {};
}

void TiltTerm::describe(
  vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const
{
  const TiltViews& tilt = arrays.tilt;
  if (tilt.areFelt())
  {
    const std::size_t count =
      tilt.weight ? arrays.points * static_cast<std::size_t>(tilt.terms.laws) : 0;
    addTable(body, name, TiltTable(tilt.terms, tilt.drops, tilt.nodes),
      std::vector<float>(tilt.weight, tilt.weight + count));
  }
}

bool TiltTerm::view(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error) const
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

const LawTerm& tiltTerm()
{
  static const TiltTerm term;
  return term;
}
} // namespace palpate
