// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/BaseNeighbours.h"

#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
// Cosine of 60°; at larger angles the surface counts as differently oriented.
constexpr double LargestTurn = 0.5;
} // namespace

float BaseNeighbours::median(
  vtkIdType i, const std::vector<float>& depths, vtkIdList* near, std::vector<float>& found) const
{
  double point[3];
  this->Surface.points->GetPoint(i, point);
  this->Surface.locator->FindPointsWithinRadius(this->Radius, point, near);
  found.clear();
  for (const vtkIdType j : *near)
  {
    if (this->Surface.cosine(i, j) > LargestTurn)
    {
      found.push_back(depths[static_cast<std::size_t>(j)]);
    }
  }
  if (found.empty())
  {
    return std::numeric_limits<float>::infinity(); // point `i` has no normal
  }
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
  std::nth_element(found.begin(), middle, found.end());
  return *middle;
}

InverseDepth BaseNeighbours::mean(vtkIdType i, const std::vector<float>& depths,
  const std::vector<float>& medians, double deepest, double depthError, vtkIdList* near) const
{
  double point[3];
  this->Surface.points->GetPoint(i, point);
  this->Surface.locator->FindPointsWithinRadius(this->Radius, point, near);
  const auto inverse = [depthError](const std::vector<float>& of, vtkIdType j)
  { return 1.0 / std::max(static_cast<double>(of[static_cast<std::size_t>(j)]), depthError); };
  const double own = inverse(medians, i);
  double weights = 0.0;
  double sum = 0.0;     // sum of the differences of the medians from the median of the point
  double squares = 0.0; // sum of the squares of these differences
  double raw = 0.0;
  for (const vtkIdType j : *near)
  {
    double other[3];
    this->Surface.points->GetPoint(j, other);
    const double weight =
      1.0 - vtkMath::Distance2BetweenPoints(point, other) / (this->Radius * this->Radius);
    if (weight > 0.0 && this->Surface.cosine(i, j) > LargestTurn)
    {
      const double difference = inverse(medians, j) - own;
      weights += weight;
      sum += weight * difference;
      squares += weight * difference * difference;
      raw += weight * inverse(depths, j);
    }
  }
  const double shift = weights > 0.0 ? sum / weights : 0.0;
  const double mean = own + shift;
  const double measured = weights > 0.0 ? raw / weights : inverse(depths, i);
  const double spread =
    weights > 0.0 ? std::sqrt(std::max(0.0, squares / weights - shift * shift)) : 0.0;
  const double least = 1.0 / deepest;
  const double read = std::max(mean, least);
  const double error = spread + std::abs(mean - measured) + depthError * read * read;
  return mean < least ? InverseDepth{ 0.0, std::max(mean + error, least) }
                      : InverseDepth{ mean, error };
}
} // namespace palpate
