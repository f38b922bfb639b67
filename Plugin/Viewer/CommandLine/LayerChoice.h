// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerChoice_h
#define palpate_LayerChoice_h

#include "Mechanics/Layers/LayerStack.h"

#include <cstddef>

namespace palpate
{
/// The layers under the surface. Either one layer on a rigid base, with the thickness of the scan
/// or a constant thickness (0: a half-space), or a stack of layers.
struct LayerChoice
{
  bool scanned = false;
  double thickness = 0.0; ///< thickness of the layer unless it is scanned, mm
  LayerStack stack = {};  ///< empty: no stack
  /// For a scanned stack of two layers: the layer whose thickness is the rest of the soft tissue.
  std::size_t scannedLayer = 0;
  bool usual = false; ///< whether the layers are skin over fat, with numbers from the literature

  bool isStack() const { return !this->stack.layers.empty(); }
  bool operator==(const LayerChoice& other) const
  {
    return this->scanned == other.scanned && this->thickness == other.thickness &&
      this->stack == other.stack && this->scannedLayer == other.scannedLayer;
  }
};
} // namespace palpate

#endif
