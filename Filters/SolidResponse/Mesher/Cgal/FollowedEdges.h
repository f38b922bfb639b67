// SPDX-License-Identifier: BSD-3-Clause
// Only for sources that include CGAL.
#ifndef palpate_FollowedEdges_h
#define palpate_FollowedEdges_h

#include "SolidResponse/Mesher/Cgal/CgalSurface.h"

#include <vector>

namespace palpate
{
/// Lines of a surface that the edges of the cells must follow.
struct FollowedEdges
{
  /// Whether all edges sharper than the limit are followed. The mesher then finds them itself.
  bool areDetected = false;
  std::vector<std::vector<CgalPoint>> lines; ///< lines from corner to corner, or closed lines
};

/**
 * Returns the rims, and the sharp edges if they are edges of the body. Such edges form lines
 * several spacings long, whereas the noise of a scan gives many short ones.
 */
FollowedEdges followedEdges(const CgalSurface& surface, const MeshedSurface& wanted);
} // namespace palpate

#endif
