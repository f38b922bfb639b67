// SPDX-License-Identifier: BSD-3-Clause
#ifndef InnerWalls_h
#define InnerWalls_h

#include "Response/Bodies/SurfaceTriangles.h"

#include <string>
#include <vector>

namespace palpate
{
class Ranks;

/// Where a volume is divided among ranks without ghost cells, each has a wall at the seam. These
/// are the polygons that two ranks have in the same block, with the same corners. Removes them; on
/// one rank does nothing. Collective; O(polygons) of the surfaces of all ranks.
void removeInnerWalls(
  std::vector<SurfaceTriangles>& made, const std::vector<std::string>& blocks, const Ranks& ranks);
} // namespace palpate

#endif
