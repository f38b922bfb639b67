// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TipOrder.h"

#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double LastCell = 1023.0;

/// Moves each bit k of the lowest ten bits of x to the bit 3k.
std::uint32_t spread(std::uint32_t x)
{
  x = (x | (x << 16)) & 0x030000FFU;
  x = (x | (x << 8)) & 0x0300F00FU;
  x = (x | (x << 4)) & 0x030C30C3U;
  x = (x | (x << 2)) & 0x09249249U;
  return x;
}

/// Returns the position of a tip along Morton's curve; 0 for a tip that is not finite.
std::uint32_t keyOf(const Vector3& tip, const Vector3& corner, double scale)
{
  std::uint32_t key = 0;
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    const double cell = scale * (tip[k] - corner[k]);
    key = key << 1 | spread(cell > 0.0 ? static_cast<std::uint32_t>(std::min(cell, LastCell)) : 0U);
  }
  return key;
}
} // namespace

void TipOrder::sort(vtkPolyData* tips, vtkIdType first, vtkIdType last, const char* leftOut)
{
  this->Given.clear();
  Eigen::AlignedBox3d box;
  for (vtkIdType id = first; id < last; ++id)
  {
    if (!leftOut[id])
    {
      Tip tip{ id, {} };
      tips->GetPoint(id, tip.position.data());
      if (tip.position.allFinite())
      {
        box.extend(tip.position);
      }
      this->Given.push_back(tip);
    }
  }
  const double size = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  const double scale = size > 0.0 && std::isfinite(size) ? LastCell / size : 0.0;
  this->Items.clear();
  for (const Tip& tip : this->Given)
  {
    this->Items.push_back(
      { keyOf(tip.position, box.min(), scale), static_cast<std::uint32_t>(this->Items.size()) });
  }

  // This is a radix sort by ten bits at a time, beginning with the lowest bits.
  constexpr unsigned digit = 10;
  this->Spare.resize(this->Items.size());
  for (unsigned shift = 0; shift < 3 * digit; shift += digit)
  {
    const auto digitOf = [shift](const Item& item)
    { return (item.key >> shift) & ((1U << digit) - 1); };
    std::array<std::uint32_t, (1U << digit) + 1> start{};
    for (const Item& item : this->Items)
    {
      ++start[digitOf(item) + 1];
    }
    for (std::size_t i = 1; i < start.size(); ++i)
    {
      start[i] += start[i - 1];
    }
    for (const Item& item : this->Items)
    {
      this->Spare[start[digitOf(item)]++] = item;
    }
    this->Items.swap(this->Spare);
  }
}
} // namespace palpate
