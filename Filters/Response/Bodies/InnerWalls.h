// SPDX-License-Identifier: BSD-3-Clause
#ifndef InnerWalls_h
#define InnerWalls_h

#include "Response/Bodies/SurfaceTriangles.h"

#include <string>
#include <vector>

namespace palpate
{
class Ranks;

/// Removes inner walls. If a volume is divided among ranks without ghost cells, each piece has a
/// wall at the seam. The walls are the polygons that two ranks have in the same block with the same
/// corners. Has no effect on one rank. Collective; O(polygons) of the surfaces of all ranks.
void removeInnerWalls(
  std::vector<SurfaceTriangles>& made, const std::vector<std::string>& blocks, const Ranks& ranks);
} // namespace palpate

#endif
