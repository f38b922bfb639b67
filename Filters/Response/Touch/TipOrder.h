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
 * A block of tips, sorted so that each is near the previous one: along Morton's curve of a 1024³
 * grid of cells around them. The search for a contact then begins where the last contact was found,
 * and the memory that it reads is in the cache, for any order of the tips.
 */
class TipOrder
{
public:
  /// Largest number of tips of one block: enough for several tips in each part of a large body, and
  /// few enough for their data to fit in a large cache.
  static constexpr vtkIdType BlockSize = 1 << 18;

  struct Tip
  {
    vtkIdType id;
    Vector3 position;
  };

  /// Sorts the tips first..last-1, at most BlockSize, except those marked in `leftOut`.
  void sort(vtkPolyData* tips, vtkIdType first, vtkIdType last, const char* leftOut);

  /// The tips in their given order.
  const std::vector<Tip>& tips() const { return this->Given; }

  /// Calls visit(k, next) for each of tips() in the sorted order. `next` comes a little later, so
  /// that its memory can be prefetched.
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
    std::uint32_t place; ///< index in Given
  };

  std::vector<Tip> Given;
  std::vector<Item> Items;
  std::vector<Item> Spare;
};
} // namespace palpate

#endif
