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

/// The shape of the own piece of a body, as a contact feels it; null: not asked for.
struct BodyShape
{
  std::unique_ptr<SurfaceCurvature> curvature;
  std::unique_ptr<EdgeDistance> edges; ///< of the whole body
  std::vector<std::int32_t> inWhole;   ///< its points that are the own ones; empty: all, in order

  const NearEdge& edgeAt(std::size_t i) const
  {
    return this->edges->at(this->inWhole.empty() ? i : static_cast<std::size_t>(this->inWhole[i]));
  }
};

/// Curvature for a law or an error, edges for an error alone, on the scale of a contact of radius
/// `a` (mm). `normals`: three floats a point. Collective; for edges each rank holds the whole body
/// for a while.
BodyShape findShape(
  vtkPolyData* body, const BodySeam& seam, const float* normals, double a, const LawTerms& terms);

/// The middle one of the three lengths of the whole body's box, mm: no circle much wider fits it.
/// Collective.
double widthOf(vtkPolyData* body, const Ranks& ranks);
} // namespace palpate

#endif
