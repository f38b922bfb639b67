// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/PatchSite.h"

#include <algorithm>

namespace palpate
{
double patchRadiusAt(const ElasticBody& body, std::int32_t point, double radius)
{
  return radius > 0.0 ? radius : PatchSpacings * body.surface().spacing(point);
}

std::array<PatchLoad, 2> patchLoadsAt(const ElasticBody& body, std::int32_t point, double radius)
{
  const double smaller = patchRadiusAt(body, point, radius);
  return { makePatchLoad(body.mesh(), body.surface(), point, smaller),
    makePatchLoad(body.mesh(), body.surface(), point, 2.0 * smaller) };
}

LocalPatch patchCutAt(
  const ElasticBody& body, std::int32_t point, double radius, const std::array<PatchLoad, 2>& loads)
{
  const BodySurface& surface = body.surface();
  // A patch that is wider than the default needs a wider cut.
  const double unit =
    std::max(surface.spacing(point), patchRadiusAt(body, point, radius) / PatchSpacings);
  return cutOut(body.mesh(), body.topology(), surface, point, loads,
    { CutReach[0] * unit, CutReach[1] * unit }, body.materialAt(surface.node(point)).poissonRatio);
}
} // namespace palpate
