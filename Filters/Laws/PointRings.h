// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PointRings_h
#define palpate_PointRings_h

#include "Laws/LinkedSurface.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// The triangles and neighbours of each point of a surface.
class PointRings
{
public:
  /// The arrays that `surface` points to must outlive this.
  explicit PointRings(const TriangleSpans& surface)
    : Surface(surface)
    , Begin(surface.pointCount + 1, 0)
    , Corner(3 * surface.triangleCount)
  {
    for (std::size_t i = 0; i < this->Corner.size(); ++i)
    {
      ++this->Begin[static_cast<std::size_t>(surface.triangles[i]) + 1];
    }
    for (std::size_t i = 0; i < surface.pointCount; ++i)
    {
      this->Begin[i + 1] += this->Begin[i];
    }
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    for (std::size_t i = 0; i < this->Corner.size(); ++i)
    {
      this->Corner[next[static_cast<std::size_t>(surface.triangles[i])]++] = i;
    }
  }

  /// Visits the two other corners of each triangle at a point, triangles in ascending order: a
  /// neighbour that two triangles share is visited twice.
  template <class Visit>
  void forNeighbours(std::size_t point, const Visit& visit) const
  {
    for (std::size_t i = this->Begin[point]; i < this->Begin[point + 1]; ++i)
    {
      const std::size_t corner = this->Corner[i];
      for (std::size_t step = 1; step < 3; ++step)
      {
        visit(static_cast<std::size_t>(
          this->Surface.triangles[corner - corner % 3 + (corner % 3 + step) % 3]));
      }
    }
  }

private:
  TriangleSpans Surface;
  std::vector<std::size_t> Begin;
  std::vector<std::size_t> Corner; ///< index in the list of corners
};
} // namespace palpate

#endif
