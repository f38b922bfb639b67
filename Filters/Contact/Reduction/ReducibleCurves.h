// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReducibleCurves_h
#define palpate_ReducibleCurves_h

#include "Contact/ParallelRanges.h"
#include "Contact/ResponseField.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace palpate
{
/// The curves of the points that have a response, read from either stored form. A curve has n
/// forces, followed by n stiffnesses.
class ReducibleCurves
{
public:
  explicit ReducibleCurves(const ResponseArrays& arrays);

  std::size_t count() const { return this->Points.size(); }
  std::size_t point(std::size_t i) const { return this->Points[i]; }
  double range(std::size_t i) const { return this->Arrays.range[this->Points[i]]; }
  const ResponseSampling& sampling() const { return this->Sampling; }
  Eigen::VectorXd curve(std::size_t i) const;

  /// Calls add(sum, i) for every `step`-th curve and returns the total. Blocks of curves are summed
  /// separately, and their sums are added in a fixed order, so that the result does not depend on
  /// the number of threads.
  template <class Sum, class Add>
  Sum sum(const Sum& zero, const Add& add, std::size_t step = 1) const;

private:
  ResponseArrays Arrays;
  ResponseSampling Sampling;
  std::vector<std::size_t> Points;
};

template <class Sum, class Add>
Sum ReducibleCurves::sum(const Sum& zero, const Add& add, std::size_t step) const
{
  // Smallest size of a range that forRanges() assigns to one thread.
  constexpr std::size_t BlockSize = 8192;
  const std::size_t items = (this->count() + step - 1) / step;
  const std::size_t blocks = (items + BlockSize - 1) / BlockSize;
  std::vector<Sum> sums(blocks, zero);
  forRanges(blocks * BlockSize,
    [&](std::size_t first, std::size_t last)
    {
      // A block is processed in the range that contains its first item.
      for (std::size_t b = (first + BlockSize - 1) / BlockSize; b * BlockSize < last; ++b)
      {
        for (std::size_t i = b * BlockSize; i < std::min(items, (b + 1) * BlockSize); ++i)
        {
          add(sums[b], i * step);
        }
      }
    });
  Sum total = zero;
  for (const Sum& part : sums)
  {
    total += part;
  }
  return total;
}
} // namespace palpate

#endif
