// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrustedDepth_h
#define palpate_TrustedDepth_h

#include <cmath>
#include <cstddef>

namespace palpate
{
/// Finds the largest depth up to which the error of a curve is within a tolerance. The search
/// begins at the deepest sample. The samples are evenly spaced in √δ. Between samples the error is
/// assumed to be linear in √δ, like the strain under a sphere.
class TrustedDepth
{
public:
  /// `range` is the depth of the last of `samples` samples, mm.
  TrustedDepth(double range, std::size_t samples, double tolerance)
    : Range(range)
    , Samples(static_cast<double>(samples))
    , Tolerance(tolerance)
  {
  }

  /// Adds the error at sample k. To be called for k = n … 1, and finally for first contact, k = 0.
  /// Returns true as soon as the depth is known.
  bool add(std::size_t k, double error)
  {
    if (!this->Known && error <= this->Tolerance)
    {
      this->Known = true;
      const auto place = static_cast<double>(k);
      const double fraction =
        place == this->Samples ? 0.0 : (this->Tolerance - error) / (this->Below - error);
      const double root = (place + (std::isfinite(fraction) ? fraction : 0.0)) / this->Samples;
      this->Found = this->Range * root * root;
    }
    this->Below = error;
    return this->Known;
  }

  double depth() const noexcept { return this->Found; }

private:
  double Range;
  double Samples;
  double Tolerance;
  double Below = 0.0; // error at the preceding, deeper sample
  double Found = 0.0;
  bool Known = false;
};
} // namespace palpate

#endif
