// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MaterialRange_h
#define palpate_MaterialRange_h

#include "Laws/ContactSpot.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Layers/LayerTable.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/// The range of the materials at a body's points. A law is prepared for this range.
class PALPATE_EXPORT MaterialRange
{
public:
  /// `stack` contains the layers below every point; the thicknesses of the first two layers may
  /// vary. By default the body is not a stack.
  explicit MaterialRange(LayerBase base, LayerStack stack = {});

  void add(const ContactSpot& spot);
  /// Includes the points of another piece of the body.
  void join(const MaterialRange& other);

  bool hasLayers() const noexcept { return this->layers.thickest > 0.0; }
  bool hasStack() const noexcept { return !this->stack.layers.empty(); }
  /// Returns the layers. For a stack, this function also computes the kernels (StackKernels.h) and
  /// includes them.
  LayerTable::Layers prepared() const;
  /// Whether the thickness of at least one layer has an error.
  bool isUncertain() const noexcept { return this->uncertain.thickest > 0.0; }
  /// Returns the layers that are possible within the errors of their thicknesses, prepared as by
  /// prepared().
  LayerTable::Layers preparedUncertain() const;
  /// Returns the range of bodies for the correction of finite strain.
  StrainBodies strainBodies() const;

  LayerTable::Layers layers; ///< without layers, `thinnest` is infinite and `thickest` is 0
  LayerStack stack;          ///< it has no layers if the body is not a stack
  /// Thickness of the second layer of the stack, mm. If there is none, `thinnest` is infinite
  /// and `thickest` is 0.
  ThicknessSpan second;
  /// The thinnest layers within the errors of their thicknesses (ContactSpot::thinnestPlace), for
  /// the spots that have such errors.
  LayerTable::Layers uncertain;
  ThicknessSpan uncertainSecond;
  bool stiffens = false;     ///< whether at least one compliance is negative
  bool hasHalfSpace = false; ///< whether at least one point has no layer
  double leastRatio = 0.5;   ///< smallest Poisson's ratio
  double mostRatio = 0.0;
  /// The softest, stiffest, thinnest and thickest spots; empty if there are no points.
  std::vector<ContactSpot> extremes;

private:
  void widen(const ContactSpot& spot);
};
} // namespace palpate

#endif
