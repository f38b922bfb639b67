// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyMaterial_h
#define palpate_BodyMaterial_h

#include "Laws/ContactSpot.h"
#include "Laws/MaterialRange.h"
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
class AxisymmetricTool;
class ResponseLaw;

/// Values of a body's points, and their name in errors. No values: the constant is used.
struct PointValues
{
  std::string name;
  std::vector<double> values;
};

/// The material of a body, point by point: constants, and values that override them.
class PALPATE_EXPORT BodyMaterial
{
public:
  /// The material of points without a value of their own.
  struct Constants
  {
    Constants(double modulus, double ratio, double layer, LayerBase layerBase, bool excludes,
      std::vector<StackLayer> below = {}, std::optional<StackLayer> endless = {})
      : youngsModulus(modulus)
      , poissonsRatio(ratio)
      , thickness(layer)
      , base(layerBase)
      , complianceExcludesLayer(excludes)
      , deeper(std::move(below))
      , halfSpace(endless)
    {
    }

    double youngsModulus; ///< MPa
    double poissonsRatio;
    double thickness; ///< mm, 0 for a half-space
    LayerBase base;
    bool complianceExcludesLayer;
    /// Layers below that one, from above. With them, or with a half-space as base, the body is a
    /// stack (LayerStack.h) everywhere, and Young's modulus and Poisson's ratio are constant.
    std::vector<StackLayer> deeper;
    std::optional<StackLayer> halfSpace; ///< in place of the rigid base

    bool isStack() const { return !this->deeper.empty() || this->halfSpace.has_value(); }
    /// The whole stack; without layers if the body is not one.
    LayerStack stack() const;
  };
  /// Values that override the constants, each at every point or nowhere.
  struct Values
  {
    PointValues youngsModulus; ///< MPa
    PointValues thickness;     ///< mm, 0 for a half-space
    PointValues compliance;    ///< in series, mm/N
    PointValues poissonsRatio;
    PointValues second;               ///< thickness of the second layer of a stack, mm
    PointValues complianceError = {}; ///< error of the compliance, mm/N
  };
  explicit BodyMaterial(const Constants& constants);

  /// What is wrong with the constants, or "".
  std::string checkConstants() const;
  /// Takes the values of `points` points, none or one for each. Returns what is wrong with them,
  /// naming point and value, or "".
  std::string take(Values values, std::size_t points);

  ContactSpots spots() const;
  const MaterialRange& range() const noexcept { return this->Range; }
  /// Sets the range of all pieces, if other processes have some.
  void setRange(const MaterialRange& range) { this->Range = range; }

  /// The tip's exponent or 1: the one with the smaller storage error where the body is softest,
  /// stiffest, thinnest and thickest.
  double bestExponent(const AxisymmetricTool& tool, const ResponseLaw& law) const;

  /// The largest relative error of storage with an exponent at the same four places, of those that
  /// can be stored.
  double storageError(const ResponseLaw& law, double exponent) const;

  /// The model in words, and as a sum of ModelPart.
  std::string describe() const;
  int modelParts() const;

private:
  std::string describeStack() const;
  std::string checkStackOf(const Values& values) const;
  std::string takeModulus(const Values& values, std::size_t points);

  Constants Given;
  std::vector<double> ReducedModulus; ///< empty vectors: the constant holds
  std::vector<double> PoissonsRatio;
  std::vector<double> Compliance;
  std::vector<double> Thickness;
  std::vector<double> Second;
  std::vector<double> ComplianceError;
  MaterialRange Range;
};
} // namespace palpate

#endif
