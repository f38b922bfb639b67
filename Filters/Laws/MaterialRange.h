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
/// The range of the materials of a body's points, for which a law must be prepared.
class PALPATE_EXPORT MaterialRange
{
public:
  /// `stack`: the layers below every point, the first two of which may vary in thickness; default
  /// none.
  explicit MaterialRange(LayerBase base, LayerStack stack = {});

  void add(const ContactSpot& spot);
  /// Includes the points of another piece of the body.
  void join(const MaterialRange& other);

  bool hasLayers() const noexcept { return this->layers.thickest > 0.0; }
  bool hasStack() const noexcept { return !this->stack.layers.empty(); }
  /// The layers; of a stack with its kernels, which are made here (StackKernels.h).
  LayerTable::Layers prepared() const;
  /// The bodies for a correction by finite strain.
  StrainBodies strainBodies() const;

  LayerTable::Layers layers; ///< thinnest infinite and thickest 0 if there are none
  LayerStack stack;          ///< without layers: none
  ThicknessSpan second;      ///< of its second layer, mm; like `layers` if there is none
  bool stiffens = false;     ///< a compliance is negative somewhere
  bool hasHalfSpace = false; ///< a point has no layer
  double leastRatio = 0.5;   ///< Poisson's
  double mostRatio = 0.0;
  /// The spots that are softest, stiffest, thinnest and thickest; none without a point.
  std::vector<ContactSpot> extremes;

private:
  void addRatio(double poissonsRatio);
  void widen(const ContactSpot& spot);
};
} // namespace palpate

#endif
