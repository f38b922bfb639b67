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

/// Values of a body's points, and what they are called where an error names them. No values: the
/// constant holds.
struct PointValues
{
  std::string name;
  std::vector<double> values;
};

/// What a body is made of, point by point: constants, and values that override them.
class PALPATE_EXPORT BodyMaterial
{
public:
  /// What holds at every point without a value of its own.
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
    /// Below that layer, from above: with them, or on a half-space, the body is a stack
    /// (LayerStack.h), everywhere, and Young's modulus and Poisson's ratio are constant.
    std::vector<StackLayer> deeper;
    std::optional<StackLayer> halfSpace; ///< in place of the rigid base

    bool isStack() const { return !this->deeper.empty() || this->halfSpace.has_value(); }
    /// The whole of it; without layers where it is none.
    LayerStack stack() const;
  };
  /// What overrides the constants, each point by point or not at all.
  struct Values
  {
    PointValues youngsModulus; ///< MPa
    PointValues thickness;     ///< mm, 0 for a half-space
    PointValues compliance;    ///< in series, mm/N
    PointValues poissonsRatio;
    PointValues second;               ///< thickness of the second layer of a stack, mm
    PointValues complianceError = {}; ///< how far the compliance may be off, mm/N
  };
  explicit BodyMaterial(const Constants& constants);

  /// What is wrong with the constants, or "".
  std::string checkConstants() const;
  /// Takes the values of `points` points, none or one for each. Returns what is wrong with them,
  /// naming point and value, or "".
  std::string take(Values values, std::size_t points);

  ContactSpots spots() const;
  const MaterialRange& range() const noexcept { return this->Range; }
  /// Of a body whose other pieces are elsewhere: the range of all of them.
  void setRange(const MaterialRange& range) { this->Range = range; }

  /// The exponent with the smaller storage error where the body is softest, stiffest, thinnest and
  /// thickest: the tip's, or 1.
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
