// SPDX-License-Identifier: BSD-3-Clause
#include "GradedBlock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace palpate::testing
{
namespace
{
/// Mirrors the coordinates: from -length/2 to length/2, with a node at 0.
std::vector<double> bothSides(const std::vector<double>& half)
{
  std::vector<double> all;
  for (std::size_t i = half.size(); i-- > 1;)
  {
    all.push_back(-half[i]);
  }
  all.insert(all.end(), half.begin(), half.end());
  return all;
}
} // namespace

std::vector<double> gradedSteps(const Grading& grading, double length)
{
  std::vector<double> at = { 0.0 };
  const auto uniform = std::lround(grading.fine / grading.spacing);
  for (long i = 1; i <= uniform; ++i)
  {
    at.push_back(static_cast<double>(i) * grading.spacing);
  }
  // Takes the number of growing steps whose sum is nearest to the rest, then scales them to fit.
  const double start = at.back();
  const double rest = length - start;
  std::vector<double> steps;
  double sum = 0.0;
  double step = std::min(grading.largest, grading.growth * grading.spacing);
  for (; sum + 0.5 * step < rest; step = std::min(grading.largest, grading.growth * step))
  {
    steps.push_back(step);
    sum += step;
  }
  if (steps.empty() && rest > 0.0)
  {
    steps.push_back(sum = rest);
  }
  double to = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    to += steps[i];
    at.push_back(i + 1 == steps.size() ? length : start + to * rest / sum);
  }
  return at;
}

ElasticBodyInput gradedBlock(const FiniteScene& scene, const FiniteMesh& mesh)
{
  const double cells = mesh.window / mesh.spacing;
  if (!(mesh.spacing > 0.0) || std::abs(cells - std::round(cells)) > 1e-9 || cells < 1.0)
  {
    throw std::runtime_error("the window must be a multiple of the element size");
  }
  if (!(mesh.window < 0.5 * std::min(scene.size.x(), scene.size.y())))
  {
    throw std::runtime_error("the window does not fit the top face of the " + scene.name);
  }
  // A plate bends as a whole, so its elements are limited; on a base the far region hardly moves.
  const double largest = scene.support == Support::Edges ? std::max(mesh.largest, mesh.spacing)
                                                         : std::numeric_limits<double>::infinity();
  const auto along = [&](int axis)
  {
    return bothSides(
      gradedSteps({ mesh.spacing, mesh.window, scene.growth, largest }, 0.5 * scene.size[axis]));
  };
  const std::vector<double> x = along(0);
  const std::vector<double> y = along(1);
  std::vector<double> z =
    gradedSteps({ mesh.spacing, mesh.spacing, scene.growth, largest }, scene.size.z());
  std::reverse(z.begin(), z.end()); // the layers are numbered from the bottom up
  const auto nx = static_cast<int>(x.size());
  const auto ny = static_cast<int>(y.size());
  const auto nz = static_cast<int>(z.size());

  ElasticBodyInput input;
  input.materials = { { scene.youngsModulus(), scene.poissonRatio } };
  input.mesh.nodes.resize(3, static_cast<Eigen::Index>(nx) * ny * nz);
  input.fixed.assign(static_cast<std::size_t>(input.mesh.nodes.cols()), 0);
  const auto id = [nx, ny](int i, int j, int k) { return (k * ny + j) * nx + i; };
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i)
      {
        input.mesh.nodes.col(id(i, j, k)) << x[static_cast<std::size_t>(i)],
          y[static_cast<std::size_t>(j)], -z[static_cast<std::size_t>(k)];
        unsigned char& fixed = input.fixed[static_cast<std::size_t>(id(i, j, k))];
        if (scene.support == Support::Base)
        {
          fixed = k == 0 ? FixedX | FixedY | FixedZ : 0;
        }
        else
        {
          fixed = i == 0 || i == nx - 1 ? FixedZ : 0;
        }
        if (i + 1 < nx && j + 1 < ny && k + 1 < nz)
        {
          VolumeElement element;
          element.nodes = { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
            id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1) };
          input.mesh.elements.push_back(element);
        }
      }
    }
  }
  if (scene.support == Support::Edges)
  {
    // The supports are statically determinate, so vertical forces put no load on them.
    input.fixed[static_cast<std::size_t>(id(nx / 2, ny / 2, 0))] |= FixedX | FixedY;
    input.fixed[static_cast<std::size_t>(id(nx - 1, ny / 2, 0))] |= FixedY;
  }
  return input;
}

} // namespace palpate::testing
