// SPDX-License-Identifier: BSD-3-Clause
#ifndef TipOrder_h
#define TipOrder_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * A block of tips, sorted so that consecutive tips are close. The order follows Morton's curve
 * through a grid of 1024³ cells around the tips. In this order, the search for a contact begins
 * where the last contact was found, and reads memory that is in the cache. This holds for any order
 * of the input.
 */
class TipOrder
{
public:
  /// Largest number of tips of one block. It is large enough for several tips in each part of a
  /// large body, and small enough for the data of the tips to fit in a large cache.
  static constexpr vtkIdType BlockSize = 1 << 18;

  struct Tip
  {
    vtkIdType id;
    Vector3 position;
  };

  /// Sorts the tips `first` to `last` - 1, which are at most BlockSize tips. Leaves out the tips
  /// that are marked in `leftOut`.
  void sort(vtkPolyData* tips, vtkIdType first, vtkIdType last, const char* leftOut);

  /// Returns the tips of the block in the input order.
  const std::vector<Tip>& tips() const { return this->Given; }

  /// Calls visit(k, next) for each of tips() in the sorted order. `next` is a tip that follows a
  /// few calls later. It allows `visit` to prefetch the memory of that tip.
  template <class Visit>
  void forEach(const Visit& visit) const
  {
    constexpr std::size_t ahead = 4;
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      const std::size_t next = std::min(i + ahead, this->Items.size() - 1);
      visit(std::size_t{ this->Items[i].place }, std::size_t{ this->Items[next].place });
    }
  }

private:
  struct Item
  {
    std::uint32_t key;
    std::uint32_t place; ///< index of the tip in Given
  };

  std::vector<Tip> Given;
  std::vector<Item> Items;
  std::vector<Item> Spare;
};
} // namespace palpate

#endif
