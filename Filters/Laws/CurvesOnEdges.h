// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvesOnEdges_h
#define palpate_CurvesOnEdges_h

#include "Contact/ResponseSampling.h"
#include "Laws/ResponseFiller.h"
#include "Mechanics/FiniteElements/ElasticBody.h"

namespace palpate
{
/**
 * Gives the points of a body's surface whose status is Edge, where a contact has no law, curves
 * from the six nearest valid points along the surface, by 1/distance², so that the force goes on
 * across an edge: each as much softer as the edge makes it there, Φ(0)/Φ(d/a) (edgeFactor), with d
 * its distance and a = K/2E* its contact radius. Their range is the mean of those, their error 1,
 * their validity 0.
 *
 * Beside a right-angled edge the curve is that of a tool along the face's normal within some 15 %.
 * Points with no valid one on their part of the surface stay without a curve, their range 0.
 * `sampling` is that of the spans.
 */
void fillEdges(
  const ElasticBody& body, const ResponseSampling& sampling, const ResponseSpans& spans);
} // namespace palpate

#endif
