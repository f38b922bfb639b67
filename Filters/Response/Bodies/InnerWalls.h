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
/// wall at the seam. A wall consists of polygons that two ranks have in the same block with the
/// same corners. With one rank, the function has no effect. Collective. The cost is proportional to
/// the number of polygons on all ranks.
void removeInnerWalls(
  std::vector<SurfaceTriangles>& made, const std::vector<std::string>& blocks, const Ranks& ranks);
} // namespace palpate

#endif
