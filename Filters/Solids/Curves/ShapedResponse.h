// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ShapedResponse_h
#define palpate_ShapedResponse_h

#include "Solids/Curves/CurvesOnEdges.h"
#include "Laws/ResponseFiller.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/MeshDifference.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace palpate
{
class StrainCorrection;

/// Settings for the response of a tool on finite elements.
struct ShapedTerms
{
  /// End of the curves, mm. A curve that ends earlier has its end as the range of the point.
  double range = 2.0;
  /// Validity is the largest depth at which the estimated error is within this. 0: the whole range
  /// of the curve.
  double errorTolerance = 0.05;
  const StrainCorrection* strain = nullptr; ///< for half-spaces; null: small strain
  /// Error of the elements from a second mesh; null: the expected error of the elements is used.
  const MeshDifference* meshes = nullptr;
  /// One value per point: relative change of the force at the end of the range that is possible due
  /// to the shape of the surface between its points, in 95 of 100 cases. It is an error of the
  /// surface, not of the contact on it, and is not part of the validity. Null: not stored.
  float* surfaceError = nullptr;
};

/**
 * The response of `tool` at all points of the surface of a body of finite elements (ShapedContact).
 * Fills the spans, one value per point of the surface; their status must be allocated.
 *
 * A point that cannot be pressed gets its PatchStatus as status. A point with an edge, a held point
 * or another material inside the smallest contact gets Edge. Points with Edge have curves from the
 * points around them (fillEdges). The exponent of storage is 1.
 *
 * The error of a sample is the root of the sum of the squares of these parts, each for the sample's
 * own contact:
 * - Strain: error of small strain or of its correction, by the local part of the compliance.
 * - Curvature: uncertainty of the surface's shape, and of the compliance along a leaning force.
 * - Edge: a fifth of the effect of the tilt next to an edge. Finite elements find that residual.
 * - Elements: elements, order of the kernel, and the error that both share near held points.
 * - Storage.
 *
 * `goOn(fraction)` receives the fraction done and stops the work by returning false. The bits do
 * not depend on the number of threads. Cost: 24 to 96 small fits per point, some milliseconds of
 * one thread.
 */
PALPATE_EXPORT MadeResponse shapedResponse(const AxisymmetricTool& tool, const RegularGreen& green,
  const ShapedTerms& terms, const ResponseSpans& spans,
  const std::function<bool(double)>& goOn = {});

/// A point of a surface that is finer than a body's elements, and the landmarks around it: indices
/// in LandmarkKernels::points(), nearest first.
struct LandmarkSpot
{
  SurfaceSpot surface;
  std::vector<std::size_t> around;
};

/// A surface on a body with coarser elements. Its functions are called from any number of threads.
struct LandmarkSurface
{
  std::function<LandmarkSpot(std::size_t)> spotAt;
  EdgedSurface edges; ///< also holds the number of points
};

/**
 * The same at the points of another surface of that body, between landmarks. The shape under the
 * contact comes from that surface (SurfaceGap, UnevenContact). The error of the interpolation of H
 * between landmarks is part of Elements. Cost: about 0.3 ms per point, 2 ms if the surface is
 * uneven under the tool.
 */
PALPATE_EXPORT MadeResponse shapedResponse(const AxisymmetricTool& tool,
  const LandmarkKernels& landmarks, const LandmarkSurface& surface, const ShapedTerms& terms,
  const ResponseSpans& spans, const std::function<bool(double)>& goOn = {});
} // namespace palpate

#endif
