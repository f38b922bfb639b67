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

/// How the response of a tool on finite elements is made.
struct ShapedTerms
{
  double range = 2.0; ///< mm; a point whose curve ends before has that for its own
  /// Validity is the largest depth at which the estimated error is within this; 0: as deep as the
  /// curve is known.
  double errorTolerance = 0.05;
  const StrainCorrection* strain = nullptr; ///< of half-spaces; null: small strain
  /// What the elements miss, by a second mesh; null: by what they let expect.
  const MeshDifference* meshes = nullptr;
  /// One value per point, what lies between the points of the surface may change of the force at
  /// the end of its range: relative, in 95 of 100 cases. It is the surface's error, not one of the
  /// contact on it, and no part of validity. Null: not kept.
  float* surfaceError = nullptr;
};

/**
 * The response of `tool` at all points of the surface of a body of finite elements (ShapedContact):
 * fills the spans, one value per point of the surface, whose status must be set.
 *
 * A point that cannot be pressed has its PatchStatus for a status, one with an edge, a held point
 * or another material inside the smallest contact Edge; these have curves from those around them
 * (fillEdges). The exponent of storage is 1.
 *
 * The error of a sample, the root of the squares of: what small strain, or its correction, lacks
 * (Strain, by the part of the compliance that is local), what is open of the surface's own shape
 * and of how a force yields that leans with it (Curvature), a fifth of what the tilt next to an
 * edge does (Edge; that fifth is what finite elements find left), elements, order of the kernel and
 * what both miss beside what is held (Elements), storage, each found at the sample's own contact.
 *
 * `goOn(fraction)` is told how much is done, and stops it by false. The same bits for any number of
 * threads. Cost: 24 to 96 small fits a point, some milliseconds of one thread.
 */
PALPATE_EXPORT MadeResponse shapedResponse(const AxisymmetricTool& tool, const RegularGreen& green,
  const ShapedTerms& terms, const ResponseSpans& spans,
  const std::function<bool(double)>& goOn = {});

/// A point of a surface that is finer than a body's elements, and the landmarks it is felt from,
/// places in LandmarkKernels::points(), nearest first.
struct LandmarkSpot
{
  SurfaceSpot surface;
  std::vector<std::size_t> around;
};

/// A surface on a body whose elements are coarser. Asked from any number of threads.
struct LandmarkSurface
{
  std::function<LandmarkSpot(std::size_t)> spotAt;
  EdgedSurface edges; ///< and how many points it has
};

/**
 * The same at the points of another surface of that body, between landmarks. The shape under the
 * contact is that surface's own (SurfaceGap, UnevenContact); what H does between landmarks is in
 * Elements. Cost: some 0.3 ms a point, 2 ms where the surface is uneven under the tool.
 */
PALPATE_EXPORT MadeResponse shapedResponse(const AxisymmetricTool& tool,
  const LandmarkKernels& landmarks, const LandmarkSurface& surface, const ShapedTerms& terms,
  const ResponseSpans& spans, const std::function<bool(double)>& goOn = {});
} // namespace palpate

#endif
