// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/FilledCells.h"

#include "vtkCell.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
bool isWithin(const BodyBall& ball, const std::array<double, 3>& x)
{
  double square = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    square += (x[k] - ball.middle[k]) * (x[k] - ball.middle[k]);
  }
  return square < ball.radius * ball.radius;
}
} // namespace

FilledCells::FilledCells(std::vector<BodyBall> balls, int subdivisions)
  : Balls(std::move(balls))
  , Places(subdivisions)
{
}

void FilledCells::findNear(const double* bounds)
{
  this->Near.clear();
  for (std::size_t i = 0; i < this->Balls.size(); ++i)
  {
    std::array<double, 3> nearest{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      nearest[k] = std::clamp(this->Balls[i].middle[k], bounds[2 * k], bounds[2 * k + 1]);
    }
    if (isWithin(this->Balls[i], nearest))
    {
      this->Near.push_back(i);
    }
  }
}

bool FilledCells::hasWithin(const double* bounds, std::size_t ball) const
{
  std::array<double, 3> farthest{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double middle = this->Balls[ball].middle[k];
    const double low = bounds[2 * k];
    const double high = bounds[2 * k + 1];
    farthest[k] = middle - low > high - middle ? low : high;
  }
  return isWithin(this->Balls[ball], farthest);
}

const std::vector<double>* FilledCells::fractions(vtkUnstructuredGrid* grid, vtkIdType id)
{
  std::array<double, 6> bounds{};
  grid->GetCellBounds(id, bounds.data());
  this->findNear(bounds.data());
  if (this->Near.empty())
  {
    return nullptr;
  }
  this->Fractions.assign(this->Balls.size(), 0.0);
  if (this->hasWithin(bounds.data(), this->Near.back()))
  {
    this->Fractions[this->Near.back()] = 1.0; // where balls overlap, the last of them counts
    return &this->Fractions;
  }
  this->count(grid->GetCell(id));
  const bool isEmpty =
    std::all_of(this->Fractions.begin(), this->Fractions.end(), [](double f) { return f <= 0.0; });
  return isEmpty ? nullptr : &this->Fractions;
}

void FilledCells::count(vtkCell* cell)
{
  double all = 0.0;
  this->Places.visit(cell,
    [&](const std::array<double, 3>& x, double volume)
    {
      all += volume;
      const auto holder = std::find_if(this->Near.rbegin(), this->Near.rend(),
        [&](std::size_t i) { return isWithin(this->Balls[i], x); });
      if (holder != this->Near.rend())
      {
        this->Fractions[*holder] += volume;
      }
    });
  for (double& fraction : this->Fractions)
  {
    fraction /= all > 0.0 ? all : 1.0;
  }
}
} // namespace palpate
