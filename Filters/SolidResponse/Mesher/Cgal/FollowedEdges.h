// SPDX-License-Identifier: BSD-3-Clause
// Include this header only in sources that use CGAL.
#ifndef palpate_FollowedEdges_h
#define palpate_FollowedEdges_h

#include "SolidResponse/Mesher/Cgal/CgalSurface.h"

#include <vector>

namespace palpate
{
/// Lines of a surface that the edges of the cells must follow.
struct FollowedEdges
{
  /// Whether all edges that are sharper than the limit are followed. The mesher then detects these
  /// edges itself.
  bool areDetected = false;
  std::vector<std::vector<CgalPoint>> lines; ///< lines from corner to corner, or closed lines
};

/**
 * Returns the rims. Also returns the sharp edges if they are edges of the body and not noise. Edges
 * of a body form lines that are several spacings long, whereas the noise of a scan gives many short
 * lines.
 */
FollowedEdges followedEdges(const CgalSurface& surface, const MeshedSurface& wanted);
} // namespace palpate

#endif
