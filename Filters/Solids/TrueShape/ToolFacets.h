// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolFacets_h
#define palpate_ToolFacets_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace palpate
{
/// Where a tool is pressed: a point of the surface, mm, and the way there, a unit vector.
struct DirectPlace
{
  Eigen::Vector3d place;
  Eigen::Vector3d inward;
};

/// A facet of a body's surface, in the tool's frame: the place its origin, z inwards.
struct ToolFacet
{
  int corners = 0;
  std::vector<std::int32_t> nodes; ///< the corners first
  Eigen::Matrix3Xd places;         ///< of them, mm
  Eigen::Vector3d area;            ///< outwards, mm²
};

/// The tool's frame: columns, two across and one inwards.
Eigen::Matrix3d toolFrame(const DirectPlace& at);

/**
 * Of a body's surface: facets that face the tool, that it reaches into where it is pressed
 * `deepest` (mm) deep, or nearly, and that hang together with the place where it is pressed.
 */
PALPATE_EXPORT std::vector<ToolFacet> facetsUnder(
  const ElasticBody& body, const AxisymmetricTool& tool, const DirectPlace& at, double deepest);

/// How deep the tool comes upon such of them as have marked nodes alone, mm; +inf where it does
/// not.
PALPATE_EXPORT double depthOfMarked(const std::vector<ToolFacet>& facets,
  const std::vector<unsigned char>& marked, const AxisymmetricTool& tool);

/// Radius beyond which nothing of a tool is reached from below, mm: short of a round tool's wall,
/// which is vertical there.
double reachedRadius(const AxisymmetricTool& tool);

/// Calls visit() with places in the middle of equal parts of a facet, in the coordinates of
/// faceShapes(); how many parts there are.
constexpr int FacetDivisions = 5;
constexpr int FacetParts = FacetDivisions * FacetDivisions;
template <class Visit>
void visitParts(int corners, const Visit& visit)
{
  constexpr double step = 1.0 / FacetDivisions;
  for (int i = 0; i < FacetDivisions; ++i)
  {
    for (int j = 0; j < FacetDivisions; ++j)
    {
      const Eigen::Vector2d at = step * Eigen::Vector2d(i, j);
      if (corners == 4)
      {
        visit(Eigen::Vector2d(2.0 * at.array() + step - 1.0));
        continue;
      }
      if (i + j < FacetDivisions)
      {
        visit(Eigen::Vector2d(at.array() + step / 3.0));
      }
      if (i + j < FacetDivisions - 1)
      {
        visit(Eigen::Vector2d(at.array() + 2.0 * step / 3.0));
      }
    }
  }
}
} // namespace palpate

#endif
