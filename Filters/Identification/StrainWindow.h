// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainWindow_h
#define palpate_StrainWindow_h

#include "Identification/BodyFit.h"

#include <memory>

namespace palpate
{
/// Returns the local depth (without a compliance in series), mm, up to which a linear law is valid.
/// At this depth the contact radius is `strain` times the tip radius; on a layer the depth is also
/// at most half of `strain` times the thickness. +inf if the law is valid at every depth.
double smallStrainDepth(const AxisymmetricTool& tool, const BodyParameters& body,
  const std::shared_ptr<const LayerKernel>& kernel, double strain);

/**
 * Returns the readings of a curve for which a linear law is valid on the assumed body, that is, up
 * to smallStrainDepth().
 *
 * If a tool exceeds the strain at any depth, such as a cone, all readings are kept, because no
 * reading is more suitable than another.
 */
IndentationCurve readingsWithin(const IndentationCurve& curve, const BodyParameters& body,
  double contactOffset, const ForceBaseline& baseline,
  const std::shared_ptr<const LayerKernel>& kernel, double strain);
} // namespace palpate

#endif
