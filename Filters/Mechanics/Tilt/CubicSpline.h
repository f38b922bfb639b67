// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CubicSpline_h
#define palpate_CubicSpline_h

#include <cstddef>
#include <optional>
#include <vector>

namespace palpate
{
/// The cubic Hermite polynomial over [0, 1] with the value 0 at the start, a given value at the
/// end, and given slopes at both ends.
class CubicCell
{
public:
  CubicCell(double rise, double first, double last) noexcept
    : A(first)
    , B(3.0 * rise - 2.0 * first - last)
    , C(first + last - 2.0 * rise)
  {
  }

  double value(double t) const noexcept { return t * (this->A + t * (this->B + t * this->C)); }
  double slope(double t) const noexcept
  {
    return this->A + t * (2.0 * this->B + 3.0 * t * this->C);
  }
  double bend(double t) const noexcept { return 2.0 * this->B + 6.0 * t * this->C; }

private:
  double A;
  double B;
  double C;
};

/// A function with its first two derivatives.
struct SplinePoint
{
  double value;
  double slope;
  double bend;
};

/// The cubic spline through samples at four or more ascending positions. The slope at an end may be
/// given. Otherwise the two cells at that end have a common cubic. The spline is linear beyond the
/// ends.
class CubicSpline
{
public:
  CubicSpline(std::vector<double> places, std::vector<double> values,
    std::optional<double> firstSlope = {}, std::optional<double> lastSlope = {});

  SplinePoint at(double place) const;
  double first() const { return this->Places.front(); }
  double last() const { return this->Places.back(); }

private:
  std::vector<double> Places;
  std::vector<double> Values;
  std::vector<double> Slopes;
};
} // namespace palpate

#endif
