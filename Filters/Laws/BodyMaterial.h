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

/// Values at the points of a body, and the name of the quantity for error messages. If `values` is
/// empty, the constant applies to all points.
struct PointValues
{
  std::string name;
  std::vector<double> values;
};

/// The material of a body at each point, given by constants and by values that override the
/// constants.
class PALPATE_EXPORT BodyMaterial
{
public:
  /// The material of points for which no values are given.
  struct Constants
  {
    Constants(double modulus, double ratio, double layer, LayerBase layerBase, bool excludes,
      std::vector<StackLayer> below = {}, std::optional<StackLayer> endless = {})
      : youngsModulus(modulus)
      , poissonRatio(ratio)
      , thickness(layer)
      , base(layerBase)
      , complianceExcludesLayer(excludes)
      , deeper(std::move(below))
      , halfSpace(endless)
    {
    }

    double youngsModulus; ///< MPa
    double poissonRatio;
    double thickness; ///< mm, 0 for a half-space
    LayerBase base;
    bool complianceExcludesLayer;
    /// Layers below the first one, from top to bottom. The whole body is a stack (LayerStack.h) if
    /// there are deeper layers or if the base is a half-space. Young's modulus and Poisson's ratio
    /// are then constant.
    std::vector<StackLayer> deeper;
    std::optional<StackLayer> halfSpace; ///< replaces the rigid base

    bool isStack() const { return !this->deeper.empty() || this->halfSpace.has_value(); }
    /// Returns the whole stack; it has no layers if the body is not a stack.
    LayerStack stack() const;
  };
  /// Values that override the constants. Each array has one value for every point, or is empty.
  struct Values
  {
    PointValues youngsModulus; ///< MPa
    PointValues thickness;     ///< mm, 0 for a half-space
    PointValues compliance;    ///< global compliance in series with the local contact, mm/N
    PointValues poissonRatio;
    PointValues second;               ///< thickness of the second layer of a stack, mm
    PointValues complianceError = {}; ///< error of the compliance, mm/N
    PointValues thicknessError = {};  ///< error of 1/thickness, 1/mm
    PointValues secondError = {};     ///< error of 1/second, 1/mm
  };
  explicit BodyMaterial(const Constants& constants);

  /// Checks the constants. Returns "" if they are valid, else an error message.
  std::string checkConstants() const;
  /// Sets the values of `points` points. Each array has one value per point or none. Returns "" if
  /// the values are valid, else a message that names the point and the value.
  std::string take(Values values, std::size_t points);

  ContactSpots spots() const;
  const MaterialRange& range() const noexcept { return this->Range; }
  /// Sets the range that is common to all pieces, if the body is divided among several processes.
  void setRange(const MaterialRange& range) { this->Range = range; }

  /// Returns the exponent for the storage of curves: either the exponent of the tool's own law
  /// or 1. The one with the smaller storage error at the softest, stiffest, thinnest and thickest
  /// spot of the body is chosen.
  double bestExponent(const AxisymmetricTool& tool, const ResponseLaw& law) const;

  /// Returns the largest relative storage error with `exponent` at the softest, stiffest, thinnest
  /// and thickest spot. Spots that cannot be stored are ignored.
  double storageError(const ResponseLaw& law, double exponent) const;

  /// Returns a description of the model in words.
  std::string describe() const;
  int modelParts() const;

private:
  std::string describeStack() const;
  std::string checkStackOf(const Values& values) const;
  std::string takeModulus(const Values& values, std::size_t points);

  Constants Given;
  /// The vectors are empty if the constant applies to all points.
  std::vector<double> ReducedModulus;
  std::vector<double> PoissonsRatio;
  std::vector<double> Compliance;
  std::vector<double> Thickness;
  std::vector<double> Second;
  std::vector<double> ComplianceError;
  std::vector<double> ThicknessError;
  std::vector<double> SecondError;
  MaterialRange Range;
};
} // namespace palpate

#endif
