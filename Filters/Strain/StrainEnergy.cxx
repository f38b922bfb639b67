// SPDX-License-Identifier: BSD-3-Clause
#include "Strain/StrainEnergy.h"

#include <cmath>

namespace palpate
{
namespace
{
/// Returns log(1 + x).
template <class Number>
Number logOnePlus(const Number& x)
{
  const double v = valueOf(x);
  const double inverse = 1.0 / (1.0 + v);
  return compose(x, std::log1p(v), inverse, -inverse * inverse);
}

template <class Number>
Number exponential(const Number& x)
{
  const double e = std::exp(valueOf(x));
  return compose(x, e, e, e);
}

/// Returns exp(x) - 1 - x, which is of second order in x.
template <class Number>
Number beyondLinear(const Number& x)
{
  const double v = valueOf(x);
  const double grown = std::expm1(v);
  const double value =
    std::abs(v) < 1e-3 ? v * v * (0.5 + v * (1.0 / 6.0 + v * (1.0 / 24.0 + v / 120.0))) : grown - v;
  return compose(x, value, grown, 1.0 + grown);
}

/// Returns (3 + 2j)(1+j)^(-2/3) - 3, the part of Ī₁-3 due to the volume change j. Its derivative is
/// exactly (2/3) j (1+j)^(-5/3).
template <class Number>
Number volumetricPart(const Number& j)
{
  const double v = valueOf(j);
  const double power = std::exp(-5.0 / 3.0 * std::log1p(v));
  const double value = std::abs(v) < 1e-3
    ? v * v * (1.0 / 3.0 + v * (-10.0 / 27.0 + v * (10.0 / 27.0 - v * 88.0 / 243.0)))
    : (3.0 + 2.0 * v) * std::expm1(-2.0 / 3.0 * std::log1p(v)) + 2.0 * v;
  return compose(
    j, value, 2.0 / 3.0 * v * power, 2.0 / 3.0 * power * (1.0 - 5.0 / 3.0 * v / (1.0 + v)));
}

/// Returns atanh(√w)², which is analytic at 0.
template <class Number>
Number squaredLogRatio(const Number& w)
{
  const double v = valueOf(w);
  if (std::abs(v) < 1e-3)
  {
    // w + 2/3 w² + 23/45 w³ + 44/105 w⁴ + …
    return compose(w, v * (1.0 + v * (2.0 / 3.0 + v * (23.0 / 45.0 + v * 44.0 / 105.0))),
      1.0 + v * (4.0 / 3.0 + v * (23.0 / 15.0 + v * 176.0 / 105.0)),
      4.0 / 3.0 + v * (46.0 / 15.0 + v * 176.0 / 35.0));
  }
  const double root = std::sqrt(v);
  const double a = std::atanh(root);
  const double slope = 1.0 / (2.0 * root * (1.0 - v));              // derivative of atanh(√w)
  const double bend = slope * (-1.0 / (2.0 * v) + 1.0 / (1.0 - v)); // derivative of `slope`
  return compose(w, a * a, 2.0 * a * slope, 2.0 * (slope * slope + a * bend));
}

/// Returns cosh(β√x) - 1, which is analytic at 0.
template <class Number>
Number coshOfRoot(const Number& x, double beta)
{
  const double y = beta * beta * valueOf(x);
  const double b2 = beta * beta;
  if (y < 1e-2)
  {
    const double first = 0.5 + y * (1.0 / 12.0 + y * (1.0 / 240.0 + y / 10080.0));
    const double second = 1.0 / 12.0 + y * (1.0 / 120.0 + y / 3360.0);
    const double value = y * (0.5 + y * (1.0 / 24.0 + y * (1.0 / 720.0 + y / 40320.0)));
    return compose(x, value, b2 * first, b2 * b2 * second);
  }
  const double root = std::sqrt(y);
  const double half = std::sinh(0.5 * root);
  const double first = std::sinh(root) / (2.0 * root);
  const double second = (std::cosh(root) - std::sinh(root) / root) / (4.0 * y);
  return compose(x, 2.0 * half * half, b2 * first, b2 * b2 * second);
}

/// Returns Ī₁ - 3.
template <class Number>
Number isochoricStretch(const StrainEnergy::Gradient<Number>& h, const Number& j)
{
  const auto& [a, b, c, d, e] = h;
  // s is I₁-3 - 2(J-1), in which the linear terms cancel analytically.
  const Number plane = a * d - b * c;
  const Number s = a * a + b * b + c * c + d * d + e * e - 2.0 * (plane + e * (a + d) + e * plane);
  return s * exponential(-2.0 / 3.0 * logOnePlus(j)) + volumetricPart(j);
}

/// Returns Σ λ̄^α - 3, computed from logarithmic strains. The linear terms cancel, because the sum
/// of the strains is 0.
template <class Number>
Number ogdenSum(const StrainEnergy::Gradient<Number>& h, const Number& j, double alpha)
{
  const auto& [a, b, c, d, e] = h;
  // C in the (r, z) plane minus the identity. The eigenvalues of C in this plane are m ± √q.
  const Number rr = 2.0 * a + a * a + c * c;
  const Number zz = 2.0 * d + d * d + b * b;
  const Number rz = b + c + a * b + c * d;
  const Number m = 1.0 + 0.5 * (rr + zz);
  const Number difference = 0.5 * (rr - zz);
  const Number q = difference * difference + rz * rz;
  const double mv = valueOf(m);
  const Number inverse = compose(m, 1.0 / mv, -1.0 / (mv * mv), 2.0 / (mv * mv * mv));
  const Number ratio = squaredLogRatio(q * inverse * inverse); // (ln λ₁ - ln λ₂)²
  const Number around = logOnePlus(e) - 1.0 / 3.0 * logOnePlus(j);
  const Number mean = -0.5 * around; // mean of the two strains in the plane
  return beyondLinear(alpha * around) + 2.0 * beyondLinear(alpha * mean) +
    2.0 * exponential(alpha * mean) * coshOfRoot(ratio, 0.5 * alpha);
}
} // namespace

template <class Number>
Number StrainEnergy::volumeChange(const Gradient<Number>& h) const
{
  const auto& [a, b, c, d, e] = h;
  if (this->isLinear())
  {
    return a + d + e;
  }
  const Number plane = a + d + a * d - b * c;
  return plane + e + e * plane;
}

template <class Number>
Number StrainEnergy::isochoric(const Gradient<Number>& h, const Number& volumeChange) const
{
  const double mu = this->ShearModulus;
  const double parameter = this->Parameter;
  switch (this->Model)
  {
    case StrainModel::NeoHooke:
      return 0.5 * mu * isochoricStretch(h, volumeChange);
    case StrainModel::Ogden:
      return 2.0 * mu / (parameter * parameter) * ogdenSum(h, volumeChange, parameter);
    case StrainModel::Demiray:
    {
      const Number x = parameter * isochoricStretch(h, volumeChange);
      const double grown = std::expm1(valueOf(x));
      return 0.5 * mu / parameter * compose(x, grown, 1.0 + grown, 1.0 + grown);
    }
    case StrainModel::Linear:
      break;
  }
  const auto& [a, b, c, d, e] = h;
  const Number shear = b + c;
  return mu *
    (a * a + d * d + e * e + 0.5 * (shear * shear) - 1.0 / 3.0 * (volumeChange * volumeChange));
}

using Dual = SecondOrder<5>;
template PALPATE_EXPORT double StrainEnergy::volumeChange(const Gradient<double>&) const;
template PALPATE_EXPORT Dual StrainEnergy::volumeChange(const Gradient<Dual>&) const;
template PALPATE_EXPORT double StrainEnergy::isochoric(
  const Gradient<double>&, const double&) const;
template PALPATE_EXPORT Dual StrainEnergy::isochoric(const Gradient<Dual>&, const Dual&) const;
} // namespace palpate
