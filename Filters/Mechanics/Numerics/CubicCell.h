// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CubicCell_h
#define palpate_CubicCell_h

namespace palpate
{
/// A cubic over [0, 1] that begins at 0, from its rise to the end and the slopes at both ends
/// (Hermite).
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
} // namespace palpate

#endif
