// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/BodyMaterial.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Contact/ResponseContract.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/ReducedModulus.h"
#include "Laws/ResponseLaw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// Finds the first value that fails `check`. Returns a message with the required range, or "" if
/// all values pass.
template <class Check>
std::string checkEach(
  const PointValues& given, const char* quantity, const char* must, Check&& check)
{
  const auto wrong = std::find_if_not(given.values.begin(), given.values.end(), check);
  return wrong == given.values.end()
    ? std::string()
    : joined("Array '", given.name, "': ", quantity, " of point ", wrong - given.values.begin(),
        " must ", must, ", but is ", *wrong);
}

bool isNotNegative(double value)
{
  return std::isfinite(value) && value >= 0.0;
}
} // namespace

LayerStack BodyMaterial::Constants::stack() const
{
  LayerStack whole;
  if (this->isStack())
  {
    whole.layers.push_back({ this->thickness, this->youngsModulus, this->poissonRatio });
    whole.layers.insert(whole.layers.end(), this->deeper.begin(), this->deeper.end());
    whole.base = this->base;
    whole.hasHalfSpace = this->halfSpace.has_value();
    whole.halfSpace = this->halfSpace.value_or(StackLayer());
  }
  return whole;
}

BodyMaterial::BodyMaterial(const Constants& constants)
  : Given(constants)
  , Range(constants.base, constants.stack())
{
}

std::string BodyMaterial::checkConstants() const
{
  if (!isYoungsModulus(this->Given.youngsModulus))
  {
    return joined(
      "Young's Modulus must be positive and finite (MPa), but is ", this->Given.youngsModulus);
  }
  if (!isPoissonsRatio(this->Given.poissonRatio))
  {
    return joined("Poisson's Ratio must lie between 0 and 0.5, but is ", this->Given.poissonRatio);
  }
  if (!isNotNegative(this->Given.thickness))
  {
    return joined(
      "Layer Thickness must be finite and not negative (mm, 0 for a half-space), but is ",
      this->Given.thickness);
  }
  return {};
}

std::string BodyMaterial::take(Values values, std::size_t points)
{
  std::string wrong = this->checkStackOf(values);
  if (wrong.empty())
  {
    wrong = this->takeModulus(values, points);
  }
  if (wrong.empty())
  {
    wrong = checkEach(
      values.thickness, "layer thickness", "be finite and not negative (mm)", isNotNegative);
  }
  if (wrong.empty())
  {
    wrong = checkEach(values.compliance, "global compliance", "be finite (mm/N)",
      [](double value) { return std::isfinite(value); });
  }
  if (wrong.empty())
  {
    wrong = checkEach(values.complianceError, "error of the global compliance",
      "be finite and not negative (mm/N)", isNotNegative);
  }
  for (const PointValues* each : { &values.thicknessError, &values.secondError })
  {
    if (wrong.empty())
    {
      wrong = checkEach(*each, "error of the inverse layer thickness",
        "be finite and not negative (1/mm)", isNotNegative);
    }
  }
  if (!wrong.empty())
  {
    return wrong;
  }
  this->PoissonsRatio = std::move(values.poissonRatio.values);
  this->Thickness = std::move(values.thickness.values);
  this->Compliance = std::move(values.compliance.values);
  this->Second = std::move(values.second.values);
  this->ComplianceError = std::move(values.complianceError.values);
  this->ThicknessError = std::move(values.thicknessError.values);
  this->SecondError = std::move(values.secondError.values);

  const std::size_t distinct =
    std::max({ this->PoissonsRatio.size(), this->Thickness.size(), this->Compliance.size(),
      this->Second.size(), this->ThicknessError.size(), this->SecondError.size() });
  const ContactSpots spots = this->spots();
  this->Range = MaterialRange(this->Given.base, this->Given.stack());
  for (std::size_t i = 0; i < std::max<std::size_t>(distinct, 1); ++i)
  {
    this->Range.add(spots.at(i));
  }
  if (this->Range.hasLayers() && !this->Compliance.empty() && !this->Given.complianceExcludesLayer)
  {
    return joined("The body has layers on a rigid base (",
      this->Thickness.empty() ? joined("Layer Thickness ", this->Given.thickness, " mm")
                              : joined("array '", values.thickness.name, "'"),
      ") and a global compliance ('", values.compliance.name,
      "'). A compliance that was found on the whole body already contains the base; otherwise "
      "switch on Compliance Excludes Layer");
  }
  return {};
}

/// Checks the values for the layers of a stack. If the body is not a stack, values for a second
/// layer are also an error.
std::string BodyMaterial::checkStackOf(const Values& values) const
{
  if (!this->Given.isStack())
  {
    return values.second.values.empty() ? std::string()
                                        : joined("Array '", values.second.name,
                                            "' is the thickness of a second layer, but the body "
                                            "has none: add it to Layers Below (AddLayer)");
  }
  for (const PointValues* each : { &values.youngsModulus, &values.poissonRatio })
  {
    if (!each->values.empty())
    {
      return joined("Array '", each->name,
        "': each layer of a stack has one material, but this array has a value per point");
    }
  }
  if (!values.second.values.empty() && this->Given.deeper.empty())
  {
    return joined("Array '", values.second.name,
      "' is the thickness of a second layer, but the body has only one layer");
  }
  LayerStack stack = this->Given.stack();
  const auto isThick = [](double value) { return value > 0.0 && std::isfinite(value); };
  const std::array<const PointValues*, 2> varying = { &values.thickness, &values.second };
  for (std::size_t i = 0; i < varying.size(); ++i)
  {
    if (varying[i]->values.empty())
    {
      continue;
    }
    std::string wrong = checkEach(
      *varying[i], "layer thickness", "be positive and finite (mm) in a stack of layers", isThick);
    if (!wrong.empty())
    {
      return wrong;
    }
    stack.layers[i].thickness = varying[i]->values.front();
  }
  return checkStack(stack);
}

std::string BodyMaterial::takeModulus(const Values& values, std::size_t points)
{
  const std::vector<double>& young = values.youngsModulus.values;
  const std::vector<double>& poisson = values.poissonRatio.values;
  if (young.empty() && poisson.empty())
  {
    return {};
  }
  const auto youngAt = [&](std::size_t i)
  { return young.empty() ? this->Given.youngsModulus : young[i]; };
  const auto poissonAt = [&](std::size_t i)
  { return poisson.empty() ? this->Given.poissonRatio : poisson[i]; };
  this->ReducedModulus.resize(points);
  for (std::size_t i = 0; i < points; ++i)
  {
    this->ReducedModulus[i] = reducedModulus(youngAt(i), poissonAt(i)); // NaN if a value is invalid
  }
  const auto wrong =
    static_cast<std::size_t>(std::find_if(this->ReducedModulus.begin(), this->ReducedModulus.end(),
                               [](double modulus) { return std::isnan(modulus); }) -
      this->ReducedModulus.begin());
  if (wrong < points && !isYoungsModulus(youngAt(wrong)))
  {
    return joined("Array '", values.youngsModulus.name, "': Young's modulus of point ", wrong,
      " must be positive and finite (MPa), but is ", youngAt(wrong));
  }
  if (wrong < points)
  {
    return joined("Array '", values.poissonRatio.name, "': Poisson's ratio of point ", wrong,
      " must lie between 0 and 0.5, but is ", poissonAt(wrong));
  }
  return {};
}

ContactSpots BodyMaterial::spots() const
{
  const auto data = [](const std::vector<double>& values)
  { return values.empty() ? nullptr : values.data(); };
  ContactSpots spots{ { reducedModulus(this->Given.youngsModulus, this->Given.poissonRatio),
                        this->Given.poissonRatio, 0.0, this->Given.thickness },
    data(this->ReducedModulus), data(this->PoissonsRatio), data(this->Compliance),
    data(this->Thickness), data(this->Second), 0.0, data(this->ComplianceError),
    data(this->ThicknessError), data(this->SecondError) };
  if (this->Given.isStack())
  {
    const std::vector<StackLayer>& deeper = this->Given.deeper;
    spots.constant.second = deeper.empty() ? 0.0 : deeper.front().thickness;
    spots.deeperThinnest = Infinity;
    for (std::size_t i = 1; i < deeper.size(); ++i)
    {
      spots.deeperThinnest = std::min(spots.deeperThinnest, deeper[i].thickness);
    }
  }
  return spots;
}

double BodyMaterial::bestExponent(const AxisymmetricTool& tool, const ResponseLaw& law) const
{
  const double tip = tool.forceExponent();
  if ((this->Compliance.empty() && !this->Range.hasLayers()) || tip == 1.0)
  {
    return tip;
  }
  return this->storageError(law, 1.0) < this->storageError(law, tip) ? 1.0 : tip;
}

double BodyMaterial::storageError(const ResponseLaw& law, double exponent) const
{
  double largest = 0.0;
  for (const ContactSpot& spot : this->Range.extremes)
  {
    const double error = law.storageError(exponent, spot);
    largest = std::isfinite(error) ? std::max(largest, error) : largest;
  }
  return largest;
}

std::string BodyMaterial::describe() const
{
  std::string model = "half-space";
  if (this->Given.isStack())
  {
    model = this->describeStack();
  }
  else if (this->Range.hasLayers())
  {
    model = this->Given.base == LayerBase::Slip ? "layer slipping on a rigid base"
                                                : "layer bonded to a rigid base";
    model += this->Thickness.empty() ? joined(", ", this->Given.thickness, " mm thick")
                                     : std::string(" of varying thickness");
  }
  return this->Compliance.empty() ? model : model + " in series with global compliance";
}

std::string BodyMaterial::describeStack() const
{
  const auto material = [](const StackLayer& layer)
  { return joined(layer.youngsModulus, " MPa, nu ", layer.poissonRatio); };
  const LayerStack stack = this->Given.stack();
  std::string model = joined("stack of ", stack.layers.size(),
    stack.layers.size() == 1 ? " layer" : " layers", ", from the top");
  for (std::size_t i = 0; i < stack.layers.size(); ++i)
  {
    const StackLayer& layer = stack.layers[i];
    const bool varies = (i == 0 && !this->Thickness.empty()) || (i == 1 && !this->Second.empty());
    model += i > 0 && layer.slips ? "; slipping, " : i > 0 ? "; " : " ";
    model += varies ? std::string("varying thickness") : joined(layer.thickness, " mm");
    model += " of " + material(layer);
  }
  if (stack.hasHalfSpace)
  {
    return model + (stack.halfSpace.slips ? "; slipping on" : "; on") + " a half-space of " +
      material(stack.halfSpace);
  }
  return model +
    (stack.base == LayerBase::Slip ? "; slipping on a rigid base" : "; bonded to a rigid base");
}

int BodyMaterial::modelParts() const
{
  return (this->Range.hasLayers() ? LayerPart : HalfSpacePart) |
    (this->Given.isStack() ? StackPart : 0) | (this->Compliance.empty() ? 0 : GlobalCompliancePart);
}
} // namespace palpate
