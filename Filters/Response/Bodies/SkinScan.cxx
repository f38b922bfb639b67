// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SkinScan.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/**
 * The rows of a ball. runs[w] contains the indices (j, k) of the rows that extend from -w to w
 * along x.
 */
struct Ball
{
  std::array<int, 3> reach; // half the extent of the ball along x, y, z, in voxels
  std::vector<std::vector<std::pair<int, int>>> runs;

  Ball(double radius, const SkinScan& scan)
  {
    auto voxels = [&scan](double length, int axis)
    {
      return static_cast<int>(
        std::min(length / scan.spacing[axis] + 1e-9, static_cast<double>(scan.size[axis])));
    };
    this->reach = { voxels(radius, 0), voxels(radius, 1), voxels(radius, 2) };
    this->runs.resize(this->reach[0] + 1);
    for (int k = -this->reach[2]; k <= this->reach[2]; ++k)
    {
      for (int j = -this->reach[1]; j <= this->reach[1]; ++j)
      {
        const double aside = std::hypot(j * scan.spacing[1], k * scan.spacing[2]);
        if (aside <= radius)
        {
          const double along = std::sqrt((radius - aside) * (radius + aside));
          this->runs[voxels(along, 0)].emplace_back(j, k);
        }
      }
    }
  }
};

/**
 * Returns the scan with `margin` additional voxels on every side, filled with `air`. A negative
 * margin removes voxels.
 */
SkinScan widened(const SkinScan& scan, const std::array<int, 3>& margin, float air)
{
  SkinScan wide{ scan.size, scan.spacing, {} };
  for (int axis = 0; axis < 3; ++axis)
  {
    wide.size[axis] += 2 * margin[axis];
  }
  wide.values.assign(static_cast<std::size_t>(wide.size[0]) * wide.size[1] * wide.size[2], air);
  const int first = std::max(0, -margin[0]); // first voxel that is kept in each row of the scan
  const int count = std::min(scan.size[0], wide.size[0]);
  for (vtkIdType k = 0; k < scan.size[2]; ++k)
  {
    for (vtkIdType j = 0; j < scan.size[1]; ++j)
    {
      const vtkIdType toJ = j + margin[1];
      const vtkIdType toK = k + margin[2];
      if (toJ >= 0 && toJ < wide.size[1] && toK >= 0 && toK < wide.size[2])
      {
        const vtkIdType from = (k * scan.size[1] + j) * scan.size[0] + first;
        const vtkIdType to = (toK * wide.size[1] + toJ) * wide.size[0] + first + margin[0];
        std::copy_n(scan.values.data() + from, count, wide.values.data() + to);
      }
    }
  }
  return wide;
}

/**
 * Replaces each voxel by the extremum over the ball around the voxel. This is a flat grey-level
 * dilation (pick = max) or erosion (pick = min). Rows of the ball with equal length share their
 * extrema along x.
 */
template <typename Pick>
bool spreadOverBall(SkinScan& scan, const Ball& ball, Pick pick, const SkinScan::Progress& progress)
{
  const vtkIdType X = scan.size[0];
  const vtkIdType Y = scan.size[1];
  const vtkIdType Z = scan.size[2];
  std::vector<float> extrema = scan.values; // extrema over [-w, w] along x, for the current w
  auto lengthen = [&extrema, pick, X](vtkIdType row, vtkIdType end)
  {
    std::vector<float> shorter(X);
    for (; row < end; ++row)
    {
      float* longer = extrema.data() + row * X;
      std::copy_n(longer, X, shorter.begin());
      std::transform(longer + 1, longer + X, shorter.begin(), longer + 1, pick);
      std::transform(longer, longer + X - 1, shorter.begin() + 1, longer, pick);
    }
  };
  for (std::size_t w = 0; w < ball.runs.size(); ++w)
  {
    auto spread = [&scan, &extrema, &runs = ball.runs[w], pick, X, Y, Z](
                    vtkIdType row, vtkIdType end)
    {
      for (; row < end; ++row)
      {
        float* target = scan.values.data() + row * X;
        for (const auto& run : runs)
        {
          const vtkIdType j = row % Y + run.first;
          const vtkIdType k = row / Y + run.second;
          if (j >= 0 && j < Y && k >= 0 && k < Z)
          {
            std::transform(target, target + X, extrema.data() + (k * Y + j) * X, target, pick);
          }
        }
      }
    };
    if (w > 0)
    {
      vtkSMPTools::For(0, Y * Z, lengthen);
    }
    vtkSMPTools::For(0, Y * Z, spread);
    if (!progress((w + 1.0) / static_cast<double>(ball.runs.size())))
    {
      return false;
    }
  }
  return true;
}

/**
 * Returns the voxels that are marked in `below` and connected to `seed` through faces. Clears the
 * marks of these voxels.
 */
std::vector<vtkIdType> takeRegion(vtkIdType seed, std::vector<char>& below, const SkinScan& scan)
{
  std::vector<vtkIdType> region;
  auto take = [&below, &region](vtkIdType voxel)
  {
    if (below[voxel])
    {
      below[voxel] = 0;
      region.push_back(voxel);
    }
  };
  take(seed);
  for (std::size_t next = 0; next < region.size(); ++next)
  {
    const vtkIdType voxel = region[next];
    vtkIdType step = 1;
    for (const vtkIdType size : scan.size)
    {
      const vtkIdType index = voxel / step % size;
      if (index > 0)
      {
        take(voxel - step);
      }
      if (index + 1 < size)
      {
        take(voxel + step);
      }
      step *= size;
    }
  }
  return region;
}
} // namespace

//------------------------------------------------------------------------------
bool SkinScan::closeOpenings(double radius, const Progress& progress)
{
  const Ball ball(radius, *this);
  const float air = *std::min_element(this->values.begin(), this->values.end());
  SkinScan wide = widened(*this, ball.reach, air);
  auto larger = [](float a, float b) { return a < b ? b : a; };
  auto smaller = [](float a, float b) { return b < a ? b : a; };
  auto half = [&progress](double from)
  { return [&progress, from](double done) { return progress(from + 0.5 * done); }; };
  const bool done =
    spreadOverBall(wide, ball, larger, half(0.0)) && spreadOverBall(wide, ball, smaller, half(0.5));
  *this = widened(wide, { -ball.reach[0], -ball.reach[1], -ball.reach[2] }, air);
  return done;
}

//------------------------------------------------------------------------------
bool SkinScan::fillCavities(float contour, float tissue)
{
  std::vector<char> below(this->values.size());
  std::transform(this->values.begin(), this->values.end(), below.begin(),
    [contour](float value) { return value < contour; });
  std::vector<vtkIdType> air;
  const auto [X, Y, Z] = this->size;
  vtkIdType row = 0;
  for (int k = 0; k < Z; ++k)
  {
    for (int j = 0; j < Y; ++j, row += X)
    {
      const bool onFace = j == 0 || j + 1 == Y || k == 0 || k + 1 == Z;
      for (int i = 0; i < X; i += onFace ? 1 : X - 1)
      {
        std::vector<vtkIdType> region = takeRegion(row + i, below, *this);
        if (region.size() > air.size())
        {
          air.swap(region);
        }
      }
    }
  }
  std::fill(below.begin(), below.end(), static_cast<char>(1));
  for (const vtkIdType voxel : air)
  {
    below[voxel] = 0;
  }
  for (std::size_t voxel = 0; voxel < below.size(); ++voxel)
  {
    if (below[voxel] && this->values[voxel] < contour)
    {
      this->values[voxel] = tissue;
    }
  }
  return !air.empty();
}
} // namespace palpate
