// SPDX-License-Identifier: BSD-3-Clause
#ifndef TipOrder_h
#define TipOrder_h

#include "TriangleProjection.h" // For palpate::Vector3

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * A block of tips in such an order that each is near the one before: along Morton's curve of a
 * 1024³ grid of cells around them. The search for one contact then begins where the last was found,
 * and what it reads is in the cache, however the tips were given.
 */
class TipOrder
{
public:
  /// Tips of one block: a few for each triangle of a large body; what is written for them stays in
  /// the second cache.
  static constexpr vtkIdType BlockSize = 1 << 16;

  struct Tip
  {
    vtkIdType id;
    Vector3 position;
  };

  /// Takes the tips first..last-1, at most BlockSize, without those marked in `leftOut`.
  void sort(vtkPolyData* tips, vtkIdType first, vtkIdType last, const char* leftOut);

  std::vector<Tip>::const_iterator begin() const { return this->Sorted.begin(); }
  std::vector<Tip>::const_iterator end() const { return this->Sorted.end(); }

private:
  struct Item
  {
    std::uint32_t key;
    std::uint32_t place; ///< in Given
  };

  std::vector<Tip> Given;
  std::vector<Tip> Sorted;
  std::vector<Item> Items;
  std::vector<Item> Spare;
};
} // namespace palpate

#endif
