// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/CubicSpline.h"

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace palpate
{
CubicSpline::CubicSpline(std::vector<double> places, std::vector<double> values,
  std::optional<double> firstSlope, std::optional<double> lastSlope)
  : Places(std::move(places))
  , Values(std::move(values))
{
  const auto n = static_cast<Eigen::Index>(this->Places.size());
  const auto width = [this](Eigen::Index i)
  {
    return this->Places[static_cast<std::size_t>(i) + 1] -
      this->Places[static_cast<std::size_t>(i)];
  };
  const auto secant = [&](Eigen::Index i)
  {
    return (this->Values[static_cast<std::size_t>(i) + 1] -
             this->Values[static_cast<std::size_t>(i)]) /
      width(i);
  };
  // The second derivative is continuous at each inner position.
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 1; i + 1 < n; ++i)
  {
    const double before = width(i - 1);
    const double after = width(i);
    system(i, i - 1) = after;
    system(i, i) = 2.0 * (before + after);
    system(i, i + 1) = before;
    right[i] = 3.0 * (after * secant(i - 1) + before * secant(i));
  }
  // At an end, either the slope is given, or the third derivative is continuous at the next
  // position.
  const auto end = [&](Eigen::Index at, Eigen::Index next, Eigen::Index cell, Eigen::Index cellNext,
                     const std::optional<double>& slope)
  {
    if (slope)
    {
      system(at, at) = 1.0;
      right[at] = *slope;
      return;
    }
    const double p = width(cell);
    const double q = width(cellNext);
    system(at, at) = q;
    system(at, next) = p + q;
    right[at] = ((p + 2.0 * (p + q)) * q * secant(cell) + p * p * secant(cellNext)) / (p + q);
  };
  end(0, 1, 0, 1, firstSlope);
  end(n - 1, n - 2, n - 2, n - 3, lastSlope);
  const Eigen::VectorXd slopes = system.partialPivLu().solve(right);
  this->Slopes.assign(slopes.data(), slopes.data() + n);
}

SplinePoint CubicSpline::at(double place) const
{
  if (place <= this->first())
  {
    return { this->Values.front() + this->Slopes.front() * (place - this->first()),
      this->Slopes.front(), 0.0 };
  }
  if (place >= this->last())
  {
    return { this->Values.back() + this->Slopes.back() * (place - this->last()),
      this->Slopes.back(), 0.0 };
  }
  const auto upper = std::upper_bound(this->Places.begin(), this->Places.end(), place);
  const auto i = static_cast<std::size_t>(upper - this->Places.begin()) - 1;
  const double width = this->Places[i + 1] - this->Places[i];
  const double t = (place - this->Places[i]) / width;
  const CubicCell cell(
    this->Values[i + 1] - this->Values[i], this->Slopes[i] * width, this->Slopes[i + 1] * width);
  return { this->Values[i] + cell.value(t), cell.slope(t) / width, cell.bend(t) / (width * width) };
}
} // namespace palpate
