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
 * The seam of a body on several ranks: the points where its pieces meet.
 *
 * Points of different ranks are one seam point under three conditions: both are on an open border
 * of their piece; their positions agree to within four units in the last place of a float
 * coordinate, because each piece may have computed the coordinate separately; and, if the body has
 * point normals, the normals are equal. Points of one piece are never merged.
 *
 * All ranks use the same numbers for the seam points. With a single rank there is no seam and no
 * cost. Otherwise the cost is O(n) per rank for n points, and each rank stores the seam points of
 * all ranks.
 */
class BodySeam
{
public:
  /// A point of this rank's piece on the seam.
  struct Place
  {
    std::int32_t point;
    std::int32_t seam;
  };

  /// The seam points of all ranks. The module Pieces finds them.
  struct Points
  {
    std::size_t size = 0;
    /// Points of this rank on the seam, in ascending order of the points.
    std::vector<Place> places;
    /// For each rank, the numbers of its points in the numbering of the seam.
    std::vector<std::vector<std::int32_t>> seams;
    /// Number of border edges that coincide with an edge of another piece in the opposite
    /// direction.
    std::size_t joinedEdges = 0;
  };

  /// `body` is this rank's piece. It has only triangles and may be empty. With several ranks, call
  /// missingPieces first. Collective.
  BodySeam(const Ranks& ranks, vtkPolyData* body);

  const Ranks& ranks() const noexcept { return this->Among; }
  /// Returns the points of this rank on the seam, in ascending order of the points.
  const std::vector<Place>& places() const noexcept { return this->Found.places; }
  /// Returns the number of border edges of all ranks that coincide with an edge of another piece in
  /// the opposite direction.
  std::size_t joinedEdges() const noexcept { return this->Found.joinedEdges; }

  /**
   * Combines values of the seam points over all ranks. `own` and the result have one value for each
   * of places(). The result is combine(...combine(start, first)..., last) over the values of all
   * ranks, in the order of the ranks. Therefore the results are bitwise equal on all ranks.
   * Collective.
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
