// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CutOutPart_h
#define palpate_CutOutPart_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "SolidResponse/Mesher/PreparedSurface.h"

#include <string>
#include <vector>

namespace palpate
{
/// The part of a surface in a box around a place.
struct CutOutSurface
{
  PreparedSurface surface;
  std::vector<CutPlane> sides; ///< the sides of the box that cut off a part of the surface
};

/// The part of a CutOutSurface, filled with cells that are fine at the place.
struct CutOutPart
{
  VolumeMesh mesh;
  std::vector<unsigned char> onCut; ///< per node: 1 if it is on the cut and not held
  std::vector<unsigned char> held;  ///< per node: 1 if it is held
};

/// Lengths of a part's cells.
struct PartCells
{
  double spacing = 0.0; ///< spacing at the surface outside the balls, mm
  std::vector<FineBall> balls;
};

/**
 * Cuts out the part of a mended and cut surface that is inside a box with half side `half` (mm)
 * around a place. Returns "", or a message about the fault. This function and fillPart() are safe
 * from any number of threads. Cost: a few tenths of a second for 100 thousand triangles.
 */
std::string cutOutAround(
  const PreparedSurface& body, const Eigen::Vector3d& place, double half, CutOutSurface& part);

/// Fills the part with quadratic tetrahedra. Elements that are not connected, face by face, to a
/// face that is held or on the cut are left out. Returns "", or a message about the fault. Cost: 60
/// µs per cell.
std::string fillPart(const CutOutSurface& part, const PartCells& cells, CutOutPart& filled);
} // namespace palpate

#endif
