// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PatchSite_h
#define palpate_PatchSite_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/FiniteElements/PatchCut.h"

namespace palpate
{
/// Default radius of the smaller patch, in spacings of the surface points.
constexpr double PatchSpacings = 0.75;

/// Returns the radius (mm) of the smaller patch at a surface point. It is `radius` or, if `radius`
/// is 0, PatchSpacings times the spacing at the point.
double patchRadiusAt(const ElasticBody& body, std::int32_t point, double radius);

/// Returns the loads of the patch with the radius patchRadiusAt() and of the patch with twice this
/// radius.
std::array<PatchLoad, 2> patchLoadsAt(const ElasticBody& body, std::int32_t point, double radius);

/// Returns the elements around the point, cut out for the self-term of the point. `loads` is the
/// result of patchLoadsAt().
LocalPatch patchCutAt(const ElasticBody& body, std::int32_t point, double radius,
  const std::array<PatchLoad, 2>& loads);
} // namespace palpate

#endif
