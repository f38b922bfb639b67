// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CutOutPart_h
#define palpate_CutOutPart_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "SolidResponse/Mesher/PreparedSurface.h"

#include <string>
#include <vector>

namespace palpate
{
/// The part of a surface in a box around a position.
struct CutOutSurface
{
  PreparedSurface surface;
  std::vector<CutPlane> sides; ///< the sides of the box at which the surface was cut
};

/// The part of a CutOutSurface, filled with cells that are fine near the centre of the box.
struct CutOutPart
{
  VolumeMesh mesh;
  /// For each node: 1 if the node is on the cut and not held, else 0.
  std::vector<unsigned char> onCut;
  std::vector<unsigned char> held; ///< for each node: 1 if the node is held, else 0
};

/// Edge lengths of the cells of a part.
struct PartCells
{
  double spacing = 0.0; ///< spacing at the surface outside the balls, mm
  std::vector<FineBall> balls;
};

/**
 * Cuts out the part of a mended and cut surface that is inside a box around `place`. `half` is half
 * the side length of the box, mm. Returns "" or an error message. This function and fillPart() are
 * thread-safe. Cost: a few tenths of a second for 100 thousand triangles.
 */
std::string cutOutAround(
  const PreparedSurface& body, const Eigen::Vector3d& place, double half, CutOutSurface& part);

/// Fills the part with quadratic tetrahedra. Elements that are not connected, face by face, to a
/// face that is held or on the cut are left out. Returns "" or an error message. Cost: 60 µs per
/// cell.
std::string fillPart(const CutOutSurface& part, const PartCells& cells, CutOutPart& filled);
} // namespace palpate

#endif
