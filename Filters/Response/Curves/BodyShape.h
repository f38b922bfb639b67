// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyShape_h
#define BodyShape_h

#include "Laws/EdgeDistance.h"
#include "Laws/LawTerms.h"
#include "Laws/SurfaceCurvature.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class vtkPolyData;

namespace palpate
{
class BodySeam;
class Ranks;
struct BodyContent;

/// Curvature and edges of this rank's piece of a body. A member that was not requested is null.
struct BodyShape
{
  std::unique_ptr<SurfaceCurvature> curvature; ///< curvature of the whole body
  std::unique_ptr<EdgeDistance> edges;
  /// For each point of the piece, its index in the whole body. The list is empty if the piece has
  /// all points, in order.
  std::vector<std::int32_t> inWhole;

  SpotCurvature curvatureAt(std::size_t i) const { return this->curvature->at(this->place(i)); }
  const NearEdge& edgeAt(std::size_t i) const { return this->edges->at(this->place(i)); }
  std::size_t place(std::size_t i) const
  {
    return this->inWhole.empty() ? i : static_cast<std::size_t>(this->inWhole[i]);
  }
};

/// Finds the curvature (needed by a law or its error) and the edges (needed by the error only) on
/// the scale of a contact of radius `a` (mm). `piece` is the content of this rank's piece.
/// `normals`: three floats per point. Never returns null. Collective; each rank temporarily stores
/// the whole body.
///
/// A shape does not depend on the material, which changes more often. So the process caches the
/// last shapes by content: 28 bytes per point, up to 128 MB and 16 shapes. Of the last two whole
/// bodies it also caches what the shapes for all radii share: some 500 bytes per point, up to 512
/// MB. Thread-safe.
std::shared_ptr<const BodyShape> findShape(const std::shared_ptr<const BodyContent>& piece,
  const BodySeam& seam, const float* normals, double a, const LawTerms& terms);

/// Lengths of the sides of the bounding box of the whole body, mm.
struct BodyLengths
{
  double least;  ///< smallest side, an upper limit of the depth of the body
  double middle; ///< middle side; a much wider circle does not fit on the body
};
/// Returns the lengths of the bounding box of the whole body. Collective.
BodyLengths lengthsOf(vtkPolyData* body, const Ranks& ranks);
} // namespace palpate

#endif
