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

/// The shape of this rank's piece of a body, as it affects a contact; null: not requested.
struct BodyShape
{
  std::unique_ptr<SurfaceCurvature> curvature; ///< of the whole body, as are the edges
  std::unique_ptr<EdgeDistance> edges;
  std::vector<std::int32_t> inWhole; ///< its points that are the own ones; empty: all, in order

  SpotCurvature curvatureAt(std::size_t i) const { return this->curvature->at(this->place(i)); }
  const NearEdge& edgeAt(std::size_t i) const { return this->edges->at(this->place(i)); }
  std::size_t place(std::size_t i) const
  {
    return this->inWhole.empty() ? i : static_cast<std::size_t>(this->inWhole[i]);
  }
};

/// Curvature for a law or an error, edges for an error alone, on the scale of a contact of radius
/// `a` (mm). `normals`: three floats a point. Never null. Collective; each rank holds the whole
/// body for a while.
///
/// A shape does not depend on the material, which changes more often: the last ones are cached in
/// the process, by content, 28 bytes a point, up to 128 MB and 16 of them. Thread-safe.
std::shared_ptr<const BodyShape> findShape(
  vtkPolyData* body, const BodySeam& seam, const float* normals, double a, const LawTerms& terms);

/// Of the three lengths of the whole body's box, mm.
struct BodyLengths
{
  double least;  ///< the body is nowhere deeper
  double middle; ///< no circle much wider fits it
};
/// Collective.
BodyLengths lengthsOf(vtkPolyData* body, const Ranks& ranks);
} // namespace palpate

#endif
