// SPDX-License-Identifier: BSD-3-Clause
// For the sources that include CGAL alone.
#ifndef palpate_FollowedEdges_h
#define palpate_FollowedEdges_h

#include "SolidResponse/Mesher/Cgal/CgalSurface.h"

#include <vector>

namespace palpate
{
/// Lines of a surface that the edges of its cells are to follow.
struct FollowedEdges
{
  bool areDetected = false; ///< all edges sharper than wanted, as the mesher finds them itself
  std::vector<std::vector<CgalPoint>> lines; ///< from corner to corner, or closed
};

/**
 * The rims, and the sharp edges where those are the body's own: lines several spacings long, and
 * not the many short ones that a scan's noise has.
 */
FollowedEdges followedEdges(const CgalSurface& surface, const MeshedSurface& wanted);
} // namespace palpate

#endif
