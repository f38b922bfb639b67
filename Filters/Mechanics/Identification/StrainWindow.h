// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainWindow_h
#define palpate_StrainWindow_h

#include "Mechanics/Identification/BodyFit.h"

#include <memory>

namespace palpate
{
/// The local depth (without a compliance in series), mm, up to which a linear law is trusted: where
/// the contact radius reaches `strain` times the tip radius and, on a layer, half of `strain` times
/// its thickness. +inf if at every depth.
double smallStrainDepth(const AxisymmetricTool& tool, const BodyParameters& body,
  const std::shared_ptr<const LayerKernel>& kernel, double strain);

/**
 * The readings of a curve that a linear law may explain, if the body is as it is taken to be: those
 * up to smallStrainDepth.
 *
 * Tools that exceed the strain from first touch on, as a cone does, keep all their readings: they
 * have none that is better.
 */
IndentationCurve readingsWithin(const IndentationCurve& curve, const BodyParameters& body,
  double contactOffset, const std::shared_ptr<const LayerKernel>& kernel, double strain);
} // namespace palpate

#endif
