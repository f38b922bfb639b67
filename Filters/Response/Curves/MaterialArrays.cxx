// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/MaterialArrays.h"

#include "Mechanics/JoinedText.h"
#include "Response/Pieces/Ranks.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace palpate
{
BodyMaterial::Constants layeredMaterial(BodyMaterial::Constants first,
  const std::vector<std::array<double, 4>>& added, bool isElasticBase, double baseModulus,
  double baseRatio)
{
  for (const auto& [thickness, modulus, ratio, slips] : added)
  {
    first.deeper.push_back({ thickness, modulus, ratio, slips != 0.0 });
  }
  if (isElasticBase)
  {
    first.halfSpace = StackLayer{ 1.0, baseModulus, baseRatio };
  }
  return first;
}

MaterialArray arrayToProcess(
  vtkAlgorithm* filter, int index, const std::function<vtkDataArray*(int)>& find)
{
  vtkInformationVector* wanted =
    filter->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* which = wanted && index < wanted->GetNumberOfInformationObjects()
    ? wanted->GetInformationObject(index)
    : nullptr;
  if (!which || !which->Has(vtkAlgorithm::INPUT_PORT()))
  {
    return {}; // no array was set, so the constant property is used
  }
  const std::string name = which->Has(vtkDataObject::FIELD_NAME())
    ? which->Get(vtkDataObject::FIELD_NAME())
    : "active attribute";
  return name.empty() ? MaterialArray{} // an empty name means that no array is requested
                      : MaterialArray{ name, find(index) };
}

MaterialArrays arraysToProcess(vtkAlgorithm* filter, const std::function<vtkDataArray*(int)>& find)
{
  MaterialArrays arrays;
  for (std::size_t index = 0; index < arrays.size(); ++index)
  {
    arrays[index] = arrayToProcess(filter, static_cast<int>(index), find);
  }
  return arrays;
}

MaterialArrays materialArrays(vtkPolyData* body, const std::array<std::string, 5>& names)
{
  MaterialArrays arrays;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    arrays[i] = { names[i],
      names[i].empty() ? nullptr : body->GetPointData()->GetArray(names[i].c_str()) };
  }
  return arrays;
}

namespace
{
/// Reads one value per point from an array that has passed checkPointArray.
void readValues(const std::string& name, vtkDataArray* array, PointValues& given)
{
  given.name = array->GetName() ? array->GetName() : name;
  given.values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < given.values.size(); ++i)
  {
    given.values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
}
} // namespace

std::string missingArray(const std::string& name, std::size_t index)
{
  static constexpr std::array<const char*, 7> Labels = { "Young's Modulus Array",
    "Layer Thickness Array", "Global Compliance Array", "Poisson's Ratio Array",
    "Second Layer Thickness Array", "Relaxation Array", "Pressed Points Array" };
  return joined(
    Labels[index], " '", name, "' (array to process ", index, ") is not on the input's points");
}

std::string checkPointArray(const MaterialArray& given, std::size_t index, vtkIdType points)
{
  const auto& [name, array] = given;
  if (name.empty())
  {
    return {};
  }
  if (!array)
  {
    return missingArray(name, index);
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != points)
  {
    return joined("Array '", array->GetName(), "' must have 1 component and ", points,
      " tuples, but has ", array->GetNumberOfComponents(), " and ", array->GetNumberOfTuples());
  }
  return {};
}

std::string readMaterial(vtkPolyData* body, const MaterialArrays& arrays, BodyMaterial& material)
{
  std::string wrong = material.checkConstants();
  BodyMaterial::Values values;
  const std::array<PointValues*, 5> wanted = { &values.youngsModulus, &values.thickness,
    &values.compliance, &values.poissonRatio, &values.second };
  const vtkIdType points = body->GetNumberOfPoints();
  for (std::size_t index = 0; index < wanted.size() && wrong.empty(); ++index)
  {
    wrong = checkPointArray(arrays[index], index, points);
    if (wrong.empty() && arrays[index].array)
    {
      readValues(arrays[index].name, arrays[index].array, *wanted[index]);
    }
  }
  const std::array<std::pair<const PointValues*, PointValues*>, 3> errors = { {
    { &values.compliance, &values.complianceError },
    { &values.thickness, &values.thicknessError },
    { &values.second, &values.secondError },
  } };
  for (const auto& [given, errorOf] : errors)
  {
    const std::string name = given->name + "Error";
    vtkDataArray* error =
      given->values.empty() ? nullptr : body->GetPointData()->GetArray(name.c_str());
    if (wrong.empty() && error)
    {
      wrong = checkPointArray({ name, error }, 0, points);
      if (wrong.empty())
      {
        readValues(name, error, *errorOf);
      }
    }
  }
  return wrong.empty() ? material.take(std::move(values), static_cast<std::size_t>(points)) : wrong;
}

void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material)
{
  if (ranks.areAlone())
  {
    return;
  }
  const MaterialRange own = hasPiece
    ? material.range()
    : MaterialRange(material.range().layers.base, material.range().stack);
  MaterialRange whole(own.layers.base, own.stack);
  const auto ratios = ranks.gather(own.layers.poissonRatios);
  const auto uncertainRatios = ranks.gather(own.uncertain.poissonRatios);
  const auto extremes = ranks.gather(own.extremes);
  for (std::size_t rank = 0; rank < ratios.size(); ++rank)
  {
    MaterialRange piece(own.layers.base);
    piece.layers.poissonRatios = ratios[rank];
    piece.uncertain.poissonRatios = uncertainRatios[rank];
    piece.extremes = extremes[rank];
    whole.join(piece);
  }
  const auto agree = [&ranks](const auto& piece, auto& all)
  {
    all.thinnest = ranks.smallest(piece.thinnest);
    all.thickest = ranks.largest(piece.thickest);
  };
  agree(own.layers, whole.layers);
  agree(own.second, whole.second);
  agree(own.uncertain, whole.uncertain);
  agree(own.uncertainSecond, whole.uncertainSecond);
  whole.stiffens = ranks.any(own.stiffens);
  whole.hasHalfSpace = ranks.any(own.hasHalfSpace);
  whole.leastRatio = ranks.smallest(own.leastRatio);
  whole.mostRatio = ranks.largest(own.mostRatio);
  material.setRange(whole);
}
} // namespace palpate
