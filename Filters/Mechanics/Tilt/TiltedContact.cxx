// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltedContact.h"

#include "Mechanics/Tilt/RectangleLoads.h"
#include "Mechanics/Tilt/TiltedSurface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
constexpr int CoarsePixels = 32; // number of pixels along each side for the search of the contact
constexpr int MostIterations = 400;
// Largest gap between tool and surface at loaded pixels, relative to the depth.
constexpr double Tolerance = 1e-5;

/// A grid of pixels on a box.
struct Grid
{
  SurfaceBox box;
  int pixels;

  double width() const { return (this->box.right - this->box.left) / this->pixels; }
  double height() const { return 2.0 * this->box.halfWidth / this->pixels; }
  std::size_t size() const { return static_cast<std::size_t>(this->pixels) * this->row(); }
  std::size_t row() const { return static_cast<std::size_t>(this->pixels); }
};

/// Returns the heights of the tool over the centres of the pixels.
std::vector<double> heightsOn(const TiltedSurface& surface, const Grid& grid, double limit)
{
  std::vector<double> heights(grid.size());
  const std::size_t n = grid.row();
  for (std::size_t j = 0; j < n / 2; ++j)
  {
    const double y = (static_cast<double>(j) + 0.5) * grid.height() - grid.box.halfWidth;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double x = grid.box.left + (static_cast<double>(i) + 0.5) * grid.width();
      heights[i + n * j] = surface.heightAt(x, y, limit);
      heights[i + n * (n - 1 - j)] = heights[i + n * j];
    }
  }
  return heights;
}

/// Returns the pressures >= 0 with which the surface conforms to the tool.
std::vector<double> pressuresOn(const Grid& grid, const std::vector<double>& heights, double depth)
{
  RectangleLoads loads(grid.pixels, grid.width(), grid.height());
  const std::size_t count = grid.size();
  std::vector<double> pressure(count, 0.0);
  std::vector<double> gap;
  std::vector<double> direction(count, 0.0);
  std::vector<double> change;
  const double width = std::max(grid.box.right - grid.box.left, 2.0 * grid.box.halfWidth);
  for (std::size_t i = 0; i < count; ++i)
  {
    pressure[i] = heights[i] < depth ? (depth - heights[i]) / width : 0.0;
  }
  double before = 1.0;
  bool goesOn = false;
  for (int iteration = 0; iteration < MostIterations; ++iteration)
  {
    loads.displace(pressure, gap);
    double square = 0.0;
    std::size_t touching = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      gap[i] += heights[i] - depth;
      if (pressure[i] > 0.0)
      {
        square += gap[i] * gap[i];
        ++touching;
      }
    }
    const double turn = goesOn ? square / before : 0.0;
    before = square;
    for (std::size_t i = 0; i < count; ++i)
    {
      direction[i] = pressure[i] > 0.0 ? gap[i] + turn * direction[i] : 0.0;
    }
    loads.displace(direction, change);
    double along = 0.0;
    double curved = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      along += pressure[i] > 0.0 ? gap[i] * direction[i] : 0.0;
      curved += change[i] * direction[i];
    }
    if (!(curved > 0.0))
    {
      break;
    }
    const double step = along / curved;
    bool isSettled = true;
    bool hasGrown = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (pressure[i] > 0.0)
      {
        pressure[i] = std::max(0.0, pressure[i] - step * direction[i]);
        isSettled = isSettled && pressure[i] > 0.0;
      }
      else if (gap[i] < 0.0)
      {
        pressure[i] = -step * gap[i];
        hasGrown = true;
      }
    }
    goesOn = !hasGrown;
    if (isSettled && !hasGrown &&
      square <= Tolerance * Tolerance * depth * depth * static_cast<double>(touching))
    {
      break;
    }
  }
  return pressure;
}

/// Returns the box around the loaded pixels, with two more pixels on each side.
SurfaceBox aroundContact(const Grid& grid, const std::vector<double>& pressures)
{
  const std::size_t n = grid.row();
  std::size_t left = n;
  std::size_t right = 0;
  std::size_t low = n / 2;
  for (std::size_t j = 0; j < n / 2; ++j)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      if (pressures[i + n * j] > 0.0)
      {
        left = std::min(left, i);
        right = std::max(right, i);
        low = std::min(low, j);
      }
    }
  }
  constexpr double Beside = 1.5;
  const double from = grid.box.left + (static_cast<double>(left) - Beside) * grid.width();
  const double to = grid.box.left + (static_cast<double>(right) + 1.0 + Beside) * grid.width();
  const double half = grid.box.halfWidth - (static_cast<double>(low) - Beside) * grid.height();
  return { std::max(from, grid.box.left), std::min(to, grid.box.right),
    std::min(half, grid.box.halfWidth) };
}
} // namespace

TiltedForce solveTilted(const AxisymmetricTool& tool, double angle, double depth, int pixels)
{
  const TiltedSurface surface(tool, angle);
  Grid grid{ surface.below(depth), CoarsePixels };
  for (int pass = 0; pass < 2; ++pass)
  {
    const SurfaceBox box =
      aroundContact(grid, pressuresOn(grid, heightsOn(surface, grid, depth), depth));
    const bool isNear = box.right - box.left > 0.6 * (grid.box.right - grid.box.left) &&
      box.halfWidth > 0.6 * grid.box.halfWidth;
    grid.box = box.right > box.left ? box : grid.box;
    if (isNear)
    {
      break;
    }
  }
  grid.pixels = pixels;
  const std::vector<double> heights = heightsOn(surface, grid, depth);
  const std::vector<double> pressures = pressuresOn(grid, heights, depth);
  const double pixel = grid.width() * grid.height();
  TiltedForce result;
  for (std::size_t i = 0; i < pressures.size(); ++i)
  {
    if (pressures[i] > 0.0)
    {
      result.perModulus += pressures[i] * pixel;
      result.work += 0.5 * pressures[i] * (depth - heights[i]) * pixel;
      result.area += pixel;
    }
  }
  return result;
}
} // namespace palpate
