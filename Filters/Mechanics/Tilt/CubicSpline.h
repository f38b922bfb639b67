// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CubicSpline_h
#define palpate_CubicSpline_h

#include <cstddef>
#include <optional>
#include <vector>

namespace palpate
{
/// A function with its first two derivatives.
struct SplinePoint
{
  double value;
  double slope;
  double bend;
};

/// The cubic spline through samples at ascending places, four or more: with the slopes given at its
/// ends, or where none is given, one cubic over the last two cells. Beyond its ends straight.
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
