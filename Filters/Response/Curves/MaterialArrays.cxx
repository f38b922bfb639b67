// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/MaterialArrays.h"

#include "Mechanics/JoinedText.h"
#include "Response/Pieces/Ranks.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
/// The values of array to process `index`, none if it was never set; an error if it is not there or
/// misshapen.
std::string fetch(vtkAlgorithm* filter, vtkPolyData* body,
  const std::function<vtkDataArray*(int)>& find, int index, PointValues& given)
{
  vtkInformationVector* wanted =
    filter->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  if (!wanted || index >= wanted->GetNumberOfInformationObjects() ||
    !wanted->GetInformationObject(index)->Has(vtkAlgorithm::INPUT_PORT()))
  {
    return {}; // never set: the constant property holds
  }
  vtkInformation* which = wanted->GetInformationObject(index);
  const char* name = which->Has(vtkDataObject::FIELD_NAME())
    ? which->Get(vtkDataObject::FIELD_NAME())
    : "active attribute";
  if (!*name)
  {
    return {}; // an empty name takes the setting back
  }
  vtkDataArray* array = find(index);
  if (!array)
  {
    return joined("Array to process ", index, " ('", name, "') is not on the input's points");
  }
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != body->GetNumberOfPoints())
  {
    return joined("Array '", array->GetName(), "' must have 1 component and ",
      body->GetNumberOfPoints(), " tuples, but has ", array->GetNumberOfComponents(), " and ",
      array->GetNumberOfTuples());
  }
  given.name = array->GetName() ? array->GetName() : name;
  given.values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < given.values.size(); ++i)
  {
    given.values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return {};
}
} // namespace

std::string readMaterial(vtkAlgorithm* filter, vtkPolyData* body,
  const std::function<vtkDataArray*(int)>& find, BodyMaterial& material)
{
  std::string wrong = material.checkConstants();
  BodyMaterial::Values values;
  const std::array<PointValues*, 4> wanted = { &values.youngsModulus, &values.thickness,
    &values.compliance, &values.poissonsRatio };
  for (std::size_t index = 0; index < wanted.size() && wrong.empty(); ++index)
  {
    wrong = fetch(filter, body, find, static_cast<int>(index), *wanted[index]);
  }
  return wrong.empty()
    ? material.take(std::move(values), static_cast<std::size_t>(body->GetNumberOfPoints()))
    : wrong;
}

void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material)
{
  if (ranks.areAlone())
  {
    return;
  }
  const MaterialRange own =
    hasPiece ? material.range() : MaterialRange(material.range().layers.base);
  MaterialRange whole(own.layers.base);
  const auto ratios = ranks.gather(own.layers.poissonsRatios);
  const auto extremes = ranks.gather(own.extremes);
  for (std::size_t rank = 0; rank < ratios.size(); ++rank)
  {
    MaterialRange piece(own.layers.base);
    piece.layers.poissonsRatios = ratios[rank];
    piece.extremes = extremes[rank];
    whole.join(piece);
  }
  whole.layers.thinnest = ranks.smallest(own.layers.thinnest);
  whole.layers.thickest = ranks.largest(own.layers.thickest);
  whole.stiffens = ranks.any(own.stiffens);
  material.setRange(whole);
}

void attachLayers(const BodyMaterial& material, const std::string& name, vtkPolyData* output)
{
  if (!material.range().hasLayers())
  {
    return;
  }
  const ContactSpots spots = material.spots();
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName((name + "LayerThickness").c_str());
  thickness->SetNumberOfTuples(output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const ContactSpot spot = spots.at(static_cast<std::size_t>(i));
    thickness->SetValue(i, static_cast<float>(spot.thickness));
  }
  output->GetPointData()->AddArray(thickness);
  vtkNew<vtkUnsignedCharArray> base;
  base->SetName((name + "LayerBase").c_str());
  base->InsertNextValue(static_cast<unsigned char>(material.range().layers.base));
  output->GetFieldData()->AddArray(base);
}
} // namespace palpate
