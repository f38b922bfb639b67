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

/// The shape of this rank's piece of a body, as it affects a contact. Null members: not requested.
struct BodyShape
{
  std::unique_ptr<SurfaceCurvature> curvature; ///< of the whole body, like the edges
  std::unique_ptr<EdgeDistance> edges;
  /// Indices of the piece's points in the whole body; empty: all points, in order.
  std::vector<std::int32_t> inWhole;

  SpotCurvature curvatureAt(std::size_t i) const { return this->curvature->at(this->place(i)); }
  const NearEdge& edgeAt(std::size_t i) const { return this->edges->at(this->place(i)); }
  std::size_t place(std::size_t i) const
  {
    return this->inWhole.empty() ? i : static_cast<std::size_t>(this->inWhole[i]);
  }
};

/// Finds the curvature, for a law or an error, and the edges, for an error only, on the scale of a
/// contact of radius `a` (mm). `normals`: three floats per point. Never null. Collective; each rank
/// temporarily stores the whole body.
///
/// A shape does not depend on the material, which changes more often. So the process caches the
/// last shapes by content: 28 bytes per point, up to 128 MB and 16 shapes. Thread-safe.
std::shared_ptr<const BodyShape> findShape(
  vtkPolyData* body, const BodySeam& seam, const float* normals, double a, const LawTerms& terms);

/// Lengths of the sides of the whole body's box, mm.
struct BodyLengths
{
  double least;  ///< smallest side: the body is nowhere deeper
  double middle; ///< middle side: a circle much wider does not fit on the body
};
/// Collective.
BodyLengths lengthsOf(vtkPolyData* body, const Ranks& ranks);
} // namespace palpate

#endif
