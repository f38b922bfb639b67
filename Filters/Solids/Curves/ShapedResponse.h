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
  /// Largest depth of the curves, mm. If a curve ends earlier, the end of the curve is the range of
  /// the point.
  double range = 2.0;
  /// Validity is the largest depth at which the estimated error is within this tolerance. If the
  /// tolerance is 0, validity is the whole range of the curve.
  double errorTolerance = 0.05;
  /// The correction for half-spaces; null for small strain.
  const StrainCorrection* strain = nullptr;
  /// Error of the elements from a second mesh. If it is null, the expected error of the elements is
  /// used.
  const MeshDifference* meshes = nullptr;
  /// If not null, receives one value per point: a bound of the relative change of the force at the
  /// end of the range due to the unknown shape of the surface between its points. The bound holds
  /// in 95 of 100 cases. It is an error of the surface, not of the contact on the surface, and is
  /// not part of the validity.
  float* surfaceError = nullptr;
};

/**
 * Computes the response of `tool` at all surface points of a body of finite elements
 * (ShapedContact) and fills the spans. The spans have one entry per surface point. The memory of
 * their status must be allocated.
 *
 * The status of a point that cannot be pressed is its PatchStatus. The status is Edge if there is
 * an edge, a held point or another material inside the smallest contact. Points with the status
 * Edge get curves from the points around them (fillEdges). The exponent of storage is 1.
 *
 * The error of a sample is the root of the sum of the squares of these parts, each for the sample's
 * own contact:
 * - Strain: error of small strain or of its correction, weighted by the local part of the
 *   compliance.
 * - Curvature: uncertainty of the surface's shape, and of the compliance along a force that is not
 *   normal to the surface.
 * - Edge: a fifth of the effect of the tilt next to an edge. This residual was found by finite
 *   elements.
 * - Elements: the error of the elements, the error due to the order of the kernel, and the error
 *   near held points. A second mesh does not show the latter if it has the same error.
 * - Storage: the error of interpolation between the stored samples.
 *
 * `goOn(fraction)` receives the completed fraction of the work, and stops the work by returning
 * false. The result is bit-identical for any number of threads. Cost: 24 to 96 small fits per
 * point, a few milliseconds of one thread.
 */
PALPATE_EXPORT MadeResponse shapedResponse(const AxisymmetricTool& tool, const RegularGreen& green,
  const ShapedTerms& terms, const ResponseSpans& spans,
  const std::function<bool(double)>& goOn = {});

/// A point of a surface that is finer than a body's elements, and the landmarks around the point.
/// The landmarks are indices in LandmarkKernels::points(), nearest first.
struct LandmarkSpot
{
  SurfaceSpot surface;
  std::vector<std::size_t> around;
};

/// A surface on a body with coarser elements. Its functions are called from several threads.
struct LandmarkSurface
{
  std::function<LandmarkSpot(std::size_t)> spotAt;
  EdgedSurface edges; ///< the edges; they also contain the number of points
};

/**
 * Computes the response at the points of another surface of the body. The points are between
 * landmarks. The shape under the contact is that of the other surface (SurfaceGap, UnevenContact).
 * The error of the interpolation of H between landmarks is part of the error Elements. Cost: about
 * 0.3 ms per point, 2 ms if the surface is uneven under the tool.
 */
PALPATE_EXPORT MadeResponse shapedResponse(const AxisymmetricTool& tool,
  const LandmarkKernels& landmarks, const LandmarkSurface& surface, const ShapedTerms& terms,
  const ResponseSpans& spans, const std::function<bool(double)>& goOn = {});
} // namespace palpate

#endif
