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
/// Place of a press: a point of the surface (mm), and the direction of the press as a unit vector.
struct DirectPlace
{
  Eigen::Vector3d place;
  Eigen::Vector3d inward;
};

/// A facet of a body's surface in the tool's frame. The origin is the place of the press, and z
/// points inwards.
struct ToolFacet
{
  int corners = 0;
  std::vector<std::int32_t> nodes; ///< nodes of the facet, the corners first
  Eigen::Matrix3Xd places;         ///< positions of the nodes, mm
  Eigen::Vector3d area;            ///< outward area vector, mm²
};

/// Returns the tool's frame. Its columns are two tangents and the inward direction.
Eigen::Matrix3d toolFrame(const DirectPlace& at);

/**
 * Returns the facets of a body's surface that may touch the tool. These facets face the tool, are
 * inside or near the tool at the depth `deepest` (mm), and are connected to the place of the press.
 */
PALPATE_EXPORT std::vector<ToolFacet> facetsUnder(
  const ElasticBody& body, const AxisymmetricTool& tool, const DirectPlace& at, double deepest);

/// Returns the depth at which the tool reaches the first facet that has only marked nodes, mm; +inf
/// if there is no such facet.
PALPATE_EXPORT double depthOfMarked(const std::vector<ToolFacet>& facets,
  const std::vector<unsigned char>& marked, const AxisymmetricTool& tool);

/// Returns the radius beyond which the tool cannot touch from above, mm. It is slightly less than
/// the radius of the wall of a round tool, because the wall is vertical.
double reachedRadius(const AxisymmetricTool& tool);

/// Calls visit() for each of the FacetParts equal parts of a facet. The argument is the middle of
/// the part, in the coordinates of faceShapes().
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
