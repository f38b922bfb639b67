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
  double poissonRatio = 0.45;
  /// Whether the layer slips on the layer above without friction; ignored for the top layer.
  bool slips = false;

  bool operator==(const StackLayer& other) const
  {
    return this->thickness == other.thickness && this->youngsModulus == other.youngsModulus &&
      this->poissonRatio == other.poissonRatio && this->slips == other.slips;
  }
};

/**
 * Elastic layers from top to bottom, on a rigid base or on a half-space. The contact is solved as
 * in LayerKernel, with a different transform W. W is computed layer by layer, starting from the
 * lowest layer.
 *
 * In each layer the displacements û_r = A J₁, û_z = B J₀ are sums of two kinds of fields: fields
 * that decay with the depth, A = (a+bZ) e^(-Z), B = (a+κ₀b+bZ) e^(-Z), Z = kz, and the mirror
 * images of such fields at the lower face. The fields determine a symmetric 4 x 4 stiffness matrix
 * K between the displacements and the tractions of the two faces. The stiffness at the top of a
 * layer, with all layers below it, is S = K₁₁ - K₁₂ (K₂₂ + S_below)⁻¹ K₁₂ᵀ, and W = ½ E*₁ (S⁻¹)_zz.
 * There are no growing exponentials. A stack of equal layers agrees with one layer to 1e-12.
 */
struct LayerStack
{
  std::vector<StackLayer> layers;
  LayerBase base = LayerBase::Bonded; ///< kind of the rigid base
  bool hasHalfSpace = false;          ///< whether the base is a half-space instead of rigid
  StackLayer halfSpace;               ///< material of the half-space; its thickness is ignored

  static constexpr std::size_t MostLayers = 4;

  bool operator==(const LayerStack& other) const
  {
    return this->layers == other.layers && this->base == other.base &&
      this->hasHalfSpace == other.hasHalfSpace &&
      (!this->hasHalfSpace || this->halfSpace == other.halfSpace);
  }
};

/// Returns the fault of a stack with the layer and the value, or "". A valid stack has 1 to
/// MostLayers layers, positive and finite thicknesses and moduli, and 0 <= ν <= 0.5.
PALPATE_EXPORT std::string checkStack(const LayerStack& stack);

/// W - 1 and V - V(∞) of a stack at ω = k h; h is the thickness and E* the reduced modulus of its
/// top layer. See LayerKernel.h.
struct StackTransform
{
  double normal;
  double radial;
};
PALPATE_EXPORT StackTransform stackTransform(const LayerStack& stack, double omega);
} // namespace palpate

#endif
