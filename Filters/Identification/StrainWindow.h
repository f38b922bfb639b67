// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainWindow_h
#define palpate_StrainWindow_h

#include "Identification/BodyFit.h"

#include <memory>

namespace palpate
{
/// The local depth (without a compliance in series), mm, up to which a linear law is valid: where
/// the contact radius reaches `strain` times the tip radius and, on a layer, half of `strain` times
/// its thickness. +inf if it is valid at every depth.
double smallStrainDepth(const AxisymmetricTool& tool, const BodyParameters& body,
  const std::shared_ptr<const LayerKernel>& kernel, double strain);

/**
 * The readings of a curve within a linear law for the assumed body: those up to smallStrainDepth.
 *
 * Tools that exceed the strain from first contact on, as a cone does, keep all their readings, as
 * none is better.
 */
IndentationCurve readingsWithin(const IndentationCurve& curve, const BodyParameters& body,
  double contactOffset, const ForceBaseline& baseline,
  const std::shared_ptr<const LayerKernel>& kernel, double strain);
} // namespace palpate

#endif
