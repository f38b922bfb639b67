// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltBody_h
#define palpate_TiltBody_h

#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"

#include <memory>
#include <string>

namespace palpate
{
class AxisymmetricTool;

/// A half-space or a layer, with a compliance in series. The modulus is not included, because it
/// only scales the result.
struct TiltBody
{
  /// Thickness of the layer, or of a stack's first layer, mm; 0 for a half-space.
  double thickness = 0.0;
  /// Kernel of the layer or stack; null for a half-space.
  std::shared_ptr<const LayerKernel> kernel;
  double yielding = 0.0; ///< compliance in series times E*, 1/mm

  bool hasLayer() const { return this->thickness > 0.0 && this->kernel != nullptr; }
  /// Returns a description in words.
  std::string describe() const;
};

/// Results for a tool pressed into a body, divided by E*.
struct TiltWork
{
  double force = 0.0;     ///< F, mm²
  double stiffness = 0.0; ///< dF/dD, mm
  double work = 0.0;      ///< ∫F dD, mm³
};

/// Computes the results for a tool pressed to the depth D > 0 (mm) into a body; NaN if the law of
/// the tool is not valid at this depth. The work is integrated to 1e-6 between the kinks of the
/// tool's profile.
PALPATE_EXPORT TiltWork pressedInto(
  const AxisymmetricTool& tool, const TiltBody& body, double depth);
} // namespace palpate

#endif
