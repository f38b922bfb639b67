// SPDX-License-Identifier: BSD-3-Clause
#include "BodyMaterial.h"

#include "AxisymmetricTool.h"
#include "Ranks.h"
#include "ReducedModulus.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace palpate
{
namespace
{
enum ArrayIndex
{
  YoungsModulusArray,
  LayerThicknessArray,
  GlobalComplianceArray,
  PoissonRatioArray
};

template <class... Parts>
std::string text(const Parts&... parts)
{
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

/// Array to process `index`, or null if it was never set; an error if it is not there or misshapen.
std::string fetch(vtkAlgorithm* filter, vtkPolyData* body, const BodyMaterial::Find& find,
  int index, vtkDataArray*& array)
{
  array = nullptr;
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
  array = find(index);
  if (!array)
  {
    return text("Array to process ", index, " ('", name, "') is not on the input's points");
  }
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != body->GetNumberOfPoints())
  {
    return text("Array '", array->GetName(), "' must have 1 component and ",
      body->GetNumberOfPoints(), " tuples, but has ", array->GetNumberOfComponents(), " and ",
      array->GetNumberOfTuples());
  }
  return {};
}

/// Copies an array of which each value must pass `check`; says which does not, and what it must be.
template <class Check>
std::string copy(vtkDataArray* array, const char* quantity, const char* must, Check&& check,
  std::vector<double>& to)
{
  to.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < to.size(); ++i)
  {
    to[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!check(to[i]))
    {
      return text("Array '", array->GetName(), "': ", quantity, " of point ", i, " must ", must,
        ", but is ", to[i]);
    }
  }
  return {};
}

bool isThickness(double value)
{
  return std::isfinite(value) && value >= 0.0;
}
} // namespace

BodyMaterial::BodyMaterial(const Constants& constants)
  : Given(constants)
{
}

std::string BodyMaterial::checkConstants() const
{
  if (!isYoungsModulus(this->Given.youngsModulus))
  {
    return text(
      "YoungsModulus must be positive and finite (MPa), but is ", this->Given.youngsModulus);
  }
  if (!isPoissonsRatio(this->Given.poissonsRatio))
  {
    return text("PoissonRatio must lie between 0 and 0.5, but is ", this->Given.poissonsRatio);
  }
  if (!isThickness(this->Given.thickness))
  {
    return text("LayerThickness must be finite and not negative (mm, 0 for a half-space), but is ",
      this->Given.thickness);
  }
  return {};
}

std::string BodyMaterial::read(vtkAlgorithm* filter, vtkPolyData* body, const Find& find)
{
  std::string wrong = this->checkConstants();
  vtkDataArray* young = nullptr;
  vtkDataArray* thickness = nullptr;
  vtkDataArray* compliance = nullptr;
  vtkDataArray* poisson = nullptr;
  const std::array<std::pair<int, vtkDataArray**>, 4> wanted = { { { YoungsModulusArray, &young },
    { LayerThicknessArray, &thickness }, { GlobalComplianceArray, &compliance },
    { PoissonRatioArray, &poisson } } };
  for (const auto& [index, array] : wanted)
  {
    wrong = wrong.empty() ? fetch(filter, body, find, index, *array) : wrong;
  }
  const vtkIdType points = body->GetNumberOfPoints();
  if (wrong.empty() && (young || poisson))
  {
    wrong = this->readModulus(young, poisson, points);
  }
  if (wrong.empty() && thickness)
  {
    wrong = copy(thickness, "layer thickness", "be finite and not negative (mm)", isThickness,
      this->Thickness);
  }
  if (wrong.empty() && compliance)
  {
    wrong = copy(
      compliance, "global compliance", "be finite (mm/N)",
      [](double value) { return std::isfinite(value); }, this->Compliance);
  }
  if (!wrong.empty())
  {
    return wrong;
  }
  this->findLayers(points);
  if (this->hasLayers() && compliance && !this->Given.complianceExcludesLayer)
  {
    return text("The body has layers on a rigid base (",
      thickness ? text("array '", thickness->GetName(), "'")
                : text("LayerThickness ", this->Given.thickness, " mm"),
      ") and a global compliance ('", compliance->GetName(),
      "'), which contains the base already if it was found on the body as it stands; if not, "
      "declare it by ComplianceExcludesLayer");
  }
  return {};
}

std::string BodyMaterial::readModulus(vtkDataArray* young, vtkDataArray* poisson, vtkIdType points)
{
  const auto youngAt = [&](vtkIdType i)
  { return young ? young->GetComponent(i, 0) : this->Given.youngsModulus; };
  const auto poissonAt = [&](vtkIdType i)
  { return poisson ? poisson->GetComponent(i, 0) : this->Given.poissonsRatio; };
  this->ReducedModulus.resize(static_cast<std::size_t>(points));
  double* modulus = this->ReducedModulus.data();
  vtkSMPTools::For(0, points,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        modulus[i] = reducedModulus(youngAt(i), poissonAt(i)); // NaN if one is wrong
      }
    });
  const vtkIdType wrong =
    std::find_if(modulus, modulus + points, [](double m) { return std::isnan(m); }) - modulus;
  if (wrong < points && !isYoungsModulus(youngAt(wrong)))
  {
    return text("Array '", young->GetName(), "': Young's modulus of point ", wrong,
      " must be positive and finite (MPa), but is ", youngAt(wrong));
  }
  if (wrong < points)
  {
    return text("Array '", poisson->GetName(), "': Poisson's ratio of point ", wrong,
      " must lie between 0 and 0.5, but is ", poissonAt(wrong));
  }
  if (poisson)
  {
    this->PoissonsRatio.resize(static_cast<std::size_t>(points));
    for (vtkIdType i = 0; i < points; ++i)
    {
      this->PoissonsRatio[static_cast<std::size_t>(i)] = poissonAt(i);
    }
  }
  return {};
}

/// The range of thickness and the values of Poisson's ratio among the points with a layer.
void BodyMaterial::findLayers(vtkIdType points)
{
  this->Layers = { this->Given.base, std::numeric_limits<double>::infinity(), 0.0, {} };
  const ResponseMaterial material = this->view();
  const bool constant = this->Thickness.empty() && this->PoissonsRatio.empty();
  for (vtkIdType i = 0; i < (constant ? 1 : points); ++i)
  {
    const ContactSpot spot = material.at(i);
    if (!(spot.thickness > 0.0))
    {
      continue;
    }
    this->Layers.thinnest = std::min(this->Layers.thinnest, spot.thickness);
    this->Layers.thickest = std::max(this->Layers.thickest, spot.thickness);
    this->addRatio(spot.poissonsRatio);
  }
}

void BodyMaterial::addRatio(double poissonsRatio)
{
  std::vector<double>& ratios = this->Layers.poissonsRatios;
  if (!ratios.empty() && ratios.back() == poissonsRatio)
  {
    return;
  }
  const auto place = std::lower_bound(ratios.begin(), ratios.end(), poissonsRatio);
  const bool known = place != ratios.end() && *place == poissonsRatio;
  if (!known && static_cast<int>(ratios.size()) <= LayerTable::DistinctRatios)
  {
    ratios.insert(place, poissonsRatio);
  }
  else if (!known) // too many to be listed: their range is what counts
  {
    ratios.front() = std::min(ratios.front(), poissonsRatio);
    ratios.back() = std::max(ratios.back(), poissonsRatio);
  }
}

ResponseMaterial BodyMaterial::view() const
{
  const auto data = [](const std::vector<double>& values)
  { return values.empty() ? nullptr : values.data(); };
  ResponseMaterial material;
  material.constant = { reducedModulus(this->Given.youngsModulus, this->Given.poissonsRatio),
    this->Given.poissonsRatio, 0.0, this->Given.thickness };
  material.reducedModulus = data(this->ReducedModulus);
  material.poissonsRatio = data(this->PoissonsRatio);
  material.compliance = data(this->Compliance);
  material.thickness = data(this->Thickness);
  return material;
}

void BodyMaterial::agree(const Ranks& ranks, bool hasPiece)
{
  this->findExtremes();
  this->Stiffens = ranks.any(std::any_of(
    this->Compliance.begin(), this->Compliance.end(), [](double c) { return c < 0.0; }));
  if (ranks.areAlone())
  {
    return;
  }
  if (!hasPiece)
  {
    this->Layers = { this->Given.base, std::numeric_limits<double>::infinity(), 0.0, {} };
  }
  this->Layers.thinnest = ranks.smallest(this->Layers.thinnest);
  this->Layers.thickest = ranks.largest(this->Layers.thickest);
  const auto ratios = ranks.gather(this->Layers.poissonsRatios);
  this->Layers.poissonsRatios.clear();
  for (const std::vector<double>& each : ratios)
  {
    for (const double ratio : each)
    {
      this->addRatio(ratio);
    }
  }
  const auto extremes =
    ranks.gather(hasPiece ? std::vector<Extremes>{ this->Extreme } : std::vector<Extremes>{});
  bool isFirst = true;
  for (const std::vector<Extremes>& each : extremes)
  {
    for (const Extremes& other : each)
    {
      if (isFirst)
      {
        this->Extreme = other;
        isFirst = false;
      }
      for (const ContactSpot& spot : other)
      {
        widen(this->Extreme, spot);
      }
    }
  }
}

void BodyMaterial::widen(Extremes& extreme, const ContactSpot& spot)
{
  const auto softness = [](const ContactSpot& at) { return at.reducedModulus * at.compliance; };
  const auto thinness = [](const ContactSpot& at) // 0 for a half-space
  { return at.thickness > 0.0 ? 1.0 / at.thickness : 0.0; };
  extreme[0] = softness(spot) < softness(extreme[0]) ? spot : extreme[0];
  extreme[1] = softness(spot) > softness(extreme[1]) ? spot : extreme[1];
  extreme[2] = thinness(spot) > thinness(extreme[2]) ? spot : extreme[2];
  extreme[3] = thinness(spot) < thinness(extreme[3]) ? spot : extreme[3];
}

void BodyMaterial::findExtremes()
{
  const ResponseMaterial material = this->view();
  const std::size_t points = std::max(this->Compliance.size(), this->Thickness.size());
  this->Extreme.fill(material.at(0));
  for (std::size_t i = 1; i < points; ++i)
  {
    widen(this->Extreme, material.at(static_cast<vtkIdType>(i)));
  }
}

double BodyMaterial::bestExponent(const AxisymmetricTool& tool, const ResponseLaw& law) const
{
  const double tip = tool.forceExponent();
  if ((this->Compliance.empty() && !this->hasLayers()) || tip == 1.0)
  {
    return tip;
  }
  const auto worst = [&](double exponent)
  {
    double largest = 0.0;
    for (const ContactSpot& spot : this->Extreme)
    {
      const double error = law.storageError(exponent, spot);
      largest = std::isfinite(error) ? std::max(largest, error) : largest;
    }
    return largest;
  };
  return worst(1.0) < worst(tip) ? 1.0 : tip;
}

std::string BodyMaterial::describe() const
{
  std::string model = "half-space";
  if (this->hasLayers())
  {
    model = this->Given.base == LayerBase::Slip ? "layer slipping on a rigid base"
                                                : "layer bonded to a rigid base";
    model += this->Thickness.empty() ? text(", ", this->Given.thickness, " mm thick")
                                     : std::string(" of varying thickness");
  }
  return this->Compliance.empty() ? model : model + " in series with global compliance";
}

void BodyMaterial::attachLayers(vtkPolyData* output, const std::string& name) const
{
  if (!this->hasLayers())
  {
    return;
  }
  const ResponseMaterial material = this->view();
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName((name + "LayerThickness").c_str());
  thickness->SetNumberOfTuples(output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    thickness->SetValue(i, static_cast<float>(material.at(i).thickness));
  }
  output->GetPointData()->AddArray(thickness);
  vtkNew<vtkUnsignedCharArray> base;
  base->SetName((name + "LayerBase").c_str());
  base->InsertNextValue(static_cast<unsigned char>(this->Given.base));
  output->GetFieldData()->AddArray(base);
}
} // namespace palpate
