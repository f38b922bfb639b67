// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerStack_h
#define palpate_LayerStack_h

#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"

#include <string>
#include <vector>

namespace palpate
{
/// One layer of a stack.
struct StackLayer
{
  double thickness = 1.0;     ///< mm
  double youngsModulus = 0.1; ///< MPa
  double poissonsRatio = 0.45;
  bool slips = false; ///< without friction on the layer above; ignored for the top one

  bool operator==(const StackLayer& other) const
  {
    return this->thickness == other.thickness && this->youngsModulus == other.youngsModulus &&
      this->poissonsRatio == other.poissonsRatio && this->slips == other.slips;
  }
};

/**
 * Elastic layers from the top down, on a rigid base or on a half-space. Their contact is that of
 * LayerKernel with another transform W, found layer by layer from below:
 *
 * In each layer the displacements û_r = A J₁, û_z = B J₀ are sums of fields that decay with the
 * depth, A = (a+bZ) e^(-Z), B = (a+κ₀b+bZ) e^(-Z), Z = kz, and of their mirror images from below,
 * which gives a symmetric stiffness K of four rows between the displacements and the tractions of
 * its two faces. S = K₁₁ - K₁₂ (K₂₂ + S_below)⁻¹ K₁₂ᵀ is that of the top of a layer including all
 * below; W = ½ E*₁ (S⁻¹)_zz. No exponential grows. A stack of equal layers is one layer, to 1e-12.
 */
struct LayerStack
{
  std::vector<StackLayer> layers;
  LayerBase base = LayerBase::Bonded; ///< of a rigid base
  bool hasHalfSpace = false;          ///< instead of the rigid base
  StackLayer halfSpace;               ///< its thickness is ignored

  static constexpr std::size_t MostLayers = 4;

  bool operator==(const LayerStack& other) const
  {
    return this->layers == other.layers && this->base == other.base &&
      this->hasHalfSpace == other.hasHalfSpace &&
      (!this->hasHalfSpace || this->halfSpace == other.halfSpace);
  }
};

/// What is wrong with a stack, naming layer and number, or "": 1 to MostLayers layers, thickness
/// and modulus positive and finite, 0 <= ν <= 0.5.
PALPATE_EXPORT std::string checkStack(const LayerStack& stack);

/// W - 1 and V - V(∞) of a stack at ω = k h, h the thickness of its top layer, E* that layer's; see
/// LayerKernel.h.
struct StackTransform
{
  double normal;
  double radial;
};
PALPATE_EXPORT StackTransform stackTransform(const LayerStack& stack, double omega);
} // namespace palpate

#endif
