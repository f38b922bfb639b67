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
/// The points from which a point on an edge takes its curve.
struct EdgeSurroundings
{
  std::vector<AlongSurface> found; ///< points with a curve, and their distances
  double turn = 0.0;               ///< by which the surface turns away at the edge, rad
};

/// A surface whose edges have no curves of their own. Thread-safe.
struct EdgedSurface
{
  std::size_t points = 0;
  std::function<ElasticMaterial(std::int32_t)> materialAt;
  /// The valid points around a point, at most six.
  std::function<EdgeSurroundings(std::int32_t, const std::function<bool(std::int32_t)>& isValid)>
    around;
};

/// The outer surface of a body, which must outlive the result: the nearest points along it.
EdgedSurface edgesOf(const ElasticBody& body);

/**
 * Gives the points of a surface whose status is Edge, where a contact has no law, curves from the
 * valid points around, by 1/distance², so that the force is continuous across an edge. Each curve
 * is softened by the edge's factor there, Φ(0)/Φ(d/a) (edgeFactor), with d its distance and
 * a = K/2E* its contact radius. Their range is the mean of those, their error 1, their validity 0.
 *
 * Beside a right-angled edge the curve is that of a tool along the face's normal within some 15 %.
 * Points with no valid one around stay without a curve, their range 0. `sampling` is that of the
 * spans.
 */
void fillEdges(
  const EdgedSurface& surface, const ResponseSampling& sampling, const ResponseSpans& spans);
} // namespace palpate

#endif
