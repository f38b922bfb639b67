// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainWindow_h
#define palpate_StrainWindow_h

#include "Identification/BodyFit.h"

#include <memory>

namespace palpate
{
/// The local depth (without a compliance in series), mm, up to which a linear law is valid. There
/// the contact radius reaches `strain` times the tip radius or, on a layer, the depth reaches half
/// of `strain` times the thickness, whichever comes first. +inf if the law is valid at every depth.
double smallStrainDepth(const AxisymmetricTool& tool, const BodyParameters& body,
  const std::shared_ptr<const LayerKernel>& kernel, double strain);

/**
 * The readings of a curve for which a linear law is valid on the assumed body: those up to
 * smallStrainDepth.
 *
 * Tools that exceed the strain from first contact on, such as a cone, keep all their readings,
 * since no reading is better than the others.
 */
IndentationCurve readingsWithin(const IndentationCurve& curve, const BodyParameters& body,
  double contactOffset, const ForceBaseline& baseline,
  const std::shared_ptr<const LayerKernel>& kernel, double strain);
} // namespace palpate

#endif
