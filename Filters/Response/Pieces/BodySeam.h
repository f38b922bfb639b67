// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodySeam_h
#define BodySeam_h

#include "Response/Pieces/Ranks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * Where the pieces of a body on several ranks meet.
 *
 * Points of different ranks are one seam point if both lie on an open border of their piece, at the
 * same place to four units in the last place of a float coordinate (each piece may have computed it
 * by itself), and, where the body has point normals, with the same normal. Points of one piece are
 * never merged.
 *
 * Seam points are numbered alike on all ranks. Collective to build; one rank has no seam, at no
 * cost. O(n) locally; each rank holds the seam points of all.
 */
class BodySeam
{
public:
  /// A point of the own piece on the seam.
  struct Place
  {
    std::int32_t point;
    std::int32_t seam;
  };

  /// The seam points of all ranks, as the module Pieces finds them.
  struct Points
  {
    std::size_t size = 0;
    std::vector<Place> places;                    ///< own, in rising order of the points
    std::vector<std::vector<std::int32_t>> seams; ///< of the places of each rank
    /// Border edges that coincide with one of another piece in the opposite direction.
    std::size_t joinedEdges = 0;
  };

  /// `body` is the own piece, of triangles alone; may be empty. Of several ranks missingPieces has
  /// been asked before.
  BodySeam(const Ranks& ranks, vtkPolyData* body);

  const Ranks& ranks() const noexcept { return this->Among; }
  /// In rising order of the points.
  const std::vector<Place>& places() const noexcept { return this->Found.places; }
  /// Border edges, of all ranks, that coincide with one of another piece in the opposite direction.
  std::size_t joinedEdges() const noexcept { return this->Found.joinedEdges; }

  /**
   * Combines values of the seam points over all ranks: `own` has a value for each of places(), and
   * so has the result, combine(...combine(start, first)..., last) over the values of all ranks in
   * the order of the ranks: the same bits everywhere. Collective.
   */
  template <class T, class Combine>
  std::vector<T> combined(const std::vector<T>& own, const T& start, const Combine& combine) const
  {
    const std::vector<std::vector<T>> all = this->Among.gather(own);
    std::vector<T> bySeam(this->Found.size, start);
    for (std::size_t rank = 0; rank < all.size(); ++rank)
    {
      for (std::size_t i = 0; i < all[rank].size(); ++i)
      {
        T& value = bySeam[static_cast<std::size_t>(this->Found.seams[rank][i])];
        value = combine(value, all[rank][i]);
      }
    }
    std::vector<T> result;
    result.reserve(this->Found.places.size());
    for (const Place& place : this->Found.places)
    {
      result.push_back(bySeam[static_cast<std::size_t>(place.seam)]);
    }
    return result;
  }

private:
  Ranks Among;
  Points Found;
};
} // namespace palpate

#endif
