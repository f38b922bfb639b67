// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvesOnEdges_h
#define palpate_CurvesOnEdges_h

#include "Contact/ResponseSampling.h"
#include "Laws/ResponseFiller.h"
#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/FiniteElements/NearestAlong.h"

#include <functional>
#include <vector>

namespace palpate
{
/// The points whose curves are averaged for the curve of a point on an edge.
struct EdgeSurroundings
{
  std::vector<AlongSurface> found; ///< points with a curve, and their distances
  double turn = 0.0;               ///< angle by which the surface bends away at the edge, rad
};

/// A surface on which points at edges get their curves from other points. Thread-safe.
struct EdgedSurface
{
  std::size_t points = 0;
  std::function<ElasticMaterial(std::int32_t)> materialAt;
  /// Returns at most six points around a point for which `isValid` returns true.
  std::function<EdgeSurroundings(std::int32_t, const std::function<bool(std::int32_t)>& isValid)>
    around;
};

/// Returns the outer surface of a body. Its function `around` finds the nearest points along the
/// surface. The body must outlive the result.
EdgedSurface edgesOf(const ElasticBody& body);

/**
 * Fills the curves of the points with the status Edge, where a contact has no law. A curve is the
 * mean of the curves of the valid points around the point, weighted by 1/distance², so that the
 * force is continuous across an edge. Each of these curves is first softened by the factor of the
 * edge, Φ(0)/Φ(d/a) (edgeFactor), where d is the distance of its point and a = K/2E* its contact
 * radius. The range is the mean of the ranges, the error is 1, and the validity is 0.
 *
 * Near a right-angled edge the force differs by at most about 15 % from that of a tool that presses
 * along the face's normal. Points without a valid point around them keep the range 0 and have no
 * curve. `sampling` is the sampling of the curves in `spans`.
 */
void fillEdges(
  const EdgedSurface& surface, const ResponseSampling& sampling, const ResponseSpans& spans);
} // namespace palpate

#endif
