// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/SpacingGrid.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double MostGridNodes = 2e6;
constexpr double StepsPerSpacing = 3.0;
} // namespace

SpacingGrid::SpacingGrid(const MeshedSurface& surface)
{
  const Eigen::Vector3d lowest = surface.points.rowwise().minCoeff();
  const Eigen::Vector3d length = surface.points.rowwise().maxCoeff() - lowest;
  double finest = *std::min_element(surface.spacing.begin(), surface.spacing.end());
  for (const FineBall& ball : surface.balls)
  {
    finest = std::min(finest, ball.spacing);
  }
  this->Step =
    std::max(finest / StepsPerSpacing, std::cbrt((length.array() + finest).prod() / MostGridNodes));
  // A plate has a large number of nodes relative to its volume. Therefore the loop counts the
  // nodes.
  while (((length.array() / this->Step).ceil() + 3.0).prod() > MostGridNodes)
  {
    this->Step *= 1.1;
  }
  this->Origin = lowest.array() - this->Step;
  this->Size = ((length.array() / this->Step).ceil() + 3.0).cast<int>();
  this->Values.assign(static_cast<std::size_t>(this->Size[0]) *
      static_cast<std::size_t>(this->Size[1]) * static_cast<std::size_t>(this->Size[2]),
    surface.interiorSpacing);
  this->mark(surface, surface.growth);
  this->sweep(surface.growth);
  for (const FineBall& ball : surface.balls)
  {
    this->refine(ball, surface.growth);
  }
}

void SpacingGrid::refine(const FineBall& ball, double growth)
{
  std::size_t node = 0;
  for (int k = 0; k < this->Size[2]; ++k)
  {
    for (int j = 0; j < this->Size[1]; ++j)
    {
      for (int i = 0; i < this->Size[0]; ++i, ++node)
      {
        const Eigen::Vector3d place = this->Origin + this->Step * Eigen::Vector3d(i, j, k);
        const double beyond = std::max(0.0, (place - ball.middle).norm() - ball.radius);
        this->Values[node] = std::min(this->Values[node], ball.spacing + growth * beyond);
      }
    }
  }
}

/// Sets the nodes around sample points of the triangles from the spacing at the sample points. The
/// sample points are less than a step of the grid apart.
void SpacingGrid::mark(const MeshedSurface& surface, double growth)
{
  for (const auto& corners : surface.triangles)
  {
    const Eigen::Vector3d from = surface.points.col(corners[0]);
    const Eigen::Vector3d first = surface.points.col(corners[1]) - from;
    const Eigen::Vector3d second = surface.points.col(corners[2]) - from;
    const double longest = std::max({ first.norm(), second.norm(), (second - first).norm() });
    const int parts = std::max(1, static_cast<int>(std::ceil(longest / this->Step)));
    for (int i = 0; i <= parts; ++i)
    {
      for (int j = 0; i + j <= parts; ++j)
      {
        const double u = static_cast<double>(i) / parts;
        const double v = static_cast<double>(j) / parts;
        const Eigen::Vector3d place = from + u * first + v * second;
        const double spacing =
          (1.0 - u - v) * surface.spacing[static_cast<std::size_t>(corners[0])] +
          u * surface.spacing[static_cast<std::size_t>(corners[1])] +
          v * surface.spacing[static_cast<std::size_t>(corners[2])];
        const Eigen::Array3d in = (place - this->Origin) / this->Step;
        const Eigen::Array3i low = in.floor().cast<int>();
        for (int corner = 0; corner < 8; ++corner)
        {
          const Eigen::Array3i at =
            low + Eigen::Array3i(corner & 1, (corner >> 1) & 1, corner >> 2);
          const double distance = this->Step * (at.cast<double>() - in).matrix().norm();
          double& value = this->Values[this->node(at)];
          value = std::min(value, spacing + growth * std::max(0.0, distance - this->Step));
        }
      }
    }
  }
}

/// Computes chamfer distances from the marked nodes in two sweeps, forwards and backwards
/// (Borgefors 1986).
void SpacingGrid::sweep(double growth)
{
  const auto total = static_cast<std::int64_t>(this->Values.size());
  for (const int direction : { 1, -1 })
  {
    for (std::int64_t k = 0; k < total; ++k)
    {
      const std::int64_t flat = direction > 0 ? k : total - 1 - k;
      const Eigen::Array3i at(static_cast<int>(flat % this->Size[0]),
        static_cast<int>(flat / this->Size[0] % this->Size[1]),
        static_cast<int>(flat / this->Size[0] / this->Size[1]));
      double& value = this->Values[static_cast<std::size_t>(flat)];
      // These are the 13 of the 26 neighbours that the sweep has already visited.
      for (int n = 0; n < 13; ++n)
      {
        const Eigen::Array3i beside =
          at + direction * Eigen::Array3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        if ((beside >= 0).all() && (beside < this->Size).all())
        {
          const double way = std::sqrt(static_cast<double>((beside - at).square().sum()));
          value = std::min(value, this->Values[this->node(beside)] + growth * this->Step * way);
        }
      }
    }
  }
}

double SpacingGrid::at(const Eigen::Vector3d& place) const
{
  const Eigen::Array3d in =
    ((place - this->Origin) / this->Step).array().max(0.0).min(this->Size.cast<double>() - 1.001);
  const Eigen::Array3i low = in.floor().cast<int>();
  const Eigen::Array3d t = in - low.cast<double>();
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Eigen::Array3i to(corner & 1, (corner >> 1) & 1, corner >> 2);
    const Eigen::Array3d weight = (to == 1).select(t, 1.0 - t);
    sum += weight.prod() * this->Values[this->node(low + to)];
  }
  return sum;
}
} // namespace palpate
