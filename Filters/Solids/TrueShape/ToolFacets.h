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
/// Place of a press: a point of the surface (mm) and the direction of the press, a unit vector.
struct DirectPlace
{
  Eigen::Vector3d place;
  Eigen::Vector3d inward;
};

/// A facet of a body's surface in the tool's frame: the origin is the place, z points inwards.
struct ToolFacet
{
  int corners = 0;
  std::vector<std::int32_t> nodes; ///< the corners first
  Eigen::Matrix3Xd places;         ///< places of the nodes, mm
  Eigen::Vector3d area;            ///< outwards, mm²
};

/// The tool's frame: columns are two tangents, then inwards.
Eigen::Matrix3d toolFrame(const DirectPlace& at);

/**
 * Facets of a body's surface that may touch the tool. They face the tool, they are inside or near
 * the tool at the depth `deepest` (mm), and they are connected to the place of the press.
 */
PALPATE_EXPORT std::vector<ToolFacet> facetsUnder(
  const ElasticBody& body, const AxisymmetricTool& tool, const DirectPlace& at, double deepest);

/// Depth at which the tool reaches the first facet with only marked nodes, mm; +inf without such a
/// facet.
PALPATE_EXPORT double depthOfMarked(const std::vector<ToolFacet>& facets,
  const std::vector<unsigned char>& marked, const AxisymmetricTool& tool);

/// Radius beyond which the tool cannot touch from above, mm. It is slightly less than the radius of
/// the wall of a round tool, since the wall is vertical.
double reachedRadius(const AxisymmetricTool& tool);

/// Calls visit() with the middle of each of the FacetParts equal parts of a facet, in the
/// coordinates of faceShapes().
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
