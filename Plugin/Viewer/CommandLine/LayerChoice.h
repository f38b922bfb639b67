// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerChoice_h
#define palpate_LayerChoice_h

#include "Mechanics/Layers/LayerStack.h"

#include <cstddef>

namespace palpate
{
/// The layers under the surface. They are either one layer on a rigid base or a stack of layers.
/// The thickness of a single layer is that of the scan or constant; a constant thickness of 0 means
/// a half-space.
struct LayerChoice
{
  bool scanned = false;
  double thickness = 0.0; ///< thickness of the layer if it is not scanned, mm
  LayerStack stack = {};  ///< empty if there is no stack
  /// For a scanned stack of two layers, the index of the layer whose thickness is the remainder of
  /// the soft tissue.
  std::size_t scannedLayer = 0;
  bool usual = false; ///< whether the layers are skin over fat, with values from the literature

  bool isStack() const { return !this->stack.layers.empty(); }
  bool operator==(const LayerChoice& other) const
  {
    return this->scanned == other.scanned && this->thickness == other.thickness &&
      this->stack == other.stack && this->scannedLayer == other.scannedLayer;
  }
};
} // namespace palpate

#endif
