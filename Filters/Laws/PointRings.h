// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PointRings_h
#define palpate_PointRings_h

#include "Laws/LinkedSurface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// The neighbours of each point of a surface. Memory: 24 bytes per triangle and 40 per point.
class PointRings
{
public:
  /// The arrays that `surface` points to are used only during construction.
  explicit PointRings(const TriangleSpans& surface)
    : VisitBegin(surface.pointCount + 1, 0)
    , NeighbourBegin(surface.pointCount + 1, 0)
    , Visits(6 * surface.triangleCount)
  {
    const std::vector<std::size_t> corners = this->sortCorners(surface);
    // Position in the list of neighbours of the point stored in `seenAt`.
    std::vector<std::uint32_t> placeOf(surface.pointCount, 0);
    // Index plus one of the last point that has this neighbour.
    std::vector<std::uint32_t> seenAt(surface.pointCount, 0);
    this->Neighbours.reserve(6 * surface.pointCount);
    std::size_t visit = 0;
    for (std::size_t point = 0; point < surface.pointCount; ++point)
    {
      const auto self = static_cast<std::uint32_t>(point) + 1;
      for (std::size_t i = this->VisitBegin[point] / 2; i < this->VisitBegin[point + 1] / 2; ++i)
      {
        const std::size_t corner = corners[i];
        for (std::size_t step = 1; step < 3; ++step)
        {
          const auto other = static_cast<std::uint32_t>(
            surface.triangles[corner - corner % 3 + (corner % 3 + step) % 3]);
          if (seenAt[other] != self)
          {
            seenAt[other] = self;
            placeOf[other] =
              static_cast<std::uint32_t>(this->Neighbours.size() - this->NeighbourBegin[point]);
            this->Neighbours.push_back(other);
          }
          this->Visits[visit++] = placeOf[other];
        }
      }
      this->NeighbourBegin[point + 1] = this->Neighbours.size();
    }
  }

  /// Visits the two other corners of each triangle at a point, with the triangles in ascending
  /// order. A neighbour that belongs to two triangles is visited twice. Calls visit(neighbour,
  /// place), where `place` is the position of the neighbour in the order of forEachNeighbour().
  template <class Visit>
  void forCorners(std::size_t point, const Visit& visit) const
  {
    const std::uint32_t* neighbours = this->Neighbours.data() + this->NeighbourBegin[point];
    for (std::size_t i = this->VisitBegin[point]; i < this->VisitBegin[point + 1]; ++i)
    {
      const std::uint32_t place = this->Visits[i];
      visit(static_cast<std::size_t>(neighbours[place]), static_cast<std::size_t>(place));
    }
  }

  /// Visits each neighbour of a point once, in the order in which forCorners() first visits it.
  template <class Visit>
  void forEachNeighbour(std::size_t point, const Visit& visit) const
  {
    const std::uint32_t* end = this->Neighbours.data() + this->NeighbourBegin[point + 1];
    for (const std::uint32_t* other = this->Neighbours.data() + this->NeighbourBegin[point];
         other != end; ++other)
    {
      visit(static_cast<std::size_t>(*other));
    }
  }

private:
  /// Returns the corners of all triangles, sorted by their points. The index of a corner is three
  /// times the index of its triangle, plus 0 to 2. Also sets VisitBegin.
  std::vector<std::size_t> sortCorners(const TriangleSpans& surface)
  {
    std::vector<std::size_t> begin(surface.pointCount + 1, 0);
    std::vector<std::size_t> corners(3 * surface.triangleCount);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      ++begin[static_cast<std::size_t>(surface.triangles[i]) + 1];
    }
    for (std::size_t i = 0; i < surface.pointCount; ++i)
    {
      begin[i + 1] += begin[i];
      this->VisitBegin[i + 1] = 2 * begin[i + 1];
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      corners[begin[static_cast<std::size_t>(surface.triangles[i])]++] = i;
    }
    return corners;
  }

  std::vector<std::size_t> VisitBegin;
  std::vector<std::size_t> NeighbourBegin;
  /// For each visit, the position of the neighbour in the list of neighbours.
  std::vector<std::uint32_t> Visits;
  std::vector<std::uint32_t> Neighbours;
};
} // namespace palpate

#endif
