// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PatchSite_h
#define palpate_PatchSite_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/FiniteElements/PatchCut.h"

namespace palpate
{
/// Automatic radius of the smaller patch, in spacings of the surface points.
constexpr double PatchSpacings = 0.75;

/// The radius (mm) of the smaller patch at a surface point: `radius`, or, if that is 0,
/// PatchSpacings times the spacing at the point.
double patchRadiusAt(const ElasticBody& body, std::int32_t point, double radius);

/// The loads of the patch of patchRadiusAt() and of the patch with twice that radius.
std::array<PatchLoad, 2> patchLoadsAt(const ElasticBody& body, std::int32_t point, double radius);

/// The elements around the point, cut out for its self-term. `loads`: result of patchLoadsAt().
LocalPatch patchCutAt(const ElasticBody& body, std::int32_t point, double radius,
  const std::array<PatchLoad, 2>& loads);
} // namespace palpate

#endif
