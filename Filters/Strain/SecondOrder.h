// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SecondOrder_h
#define palpate_SecondOrder_h

#include <Eigen/Core>

namespace palpate
{
/**
 * A number with its first and second derivatives with respect to N variables (second-order forward
 * automatic differentiation). A strain energy can then be written as one formula, from which stress
 * and tangent are computed.
 */
template <int N>
struct SecondOrder
{
  using Gradient = Eigen::Matrix<double, N, 1>;
  using Hessian = Eigen::Matrix<double, N, N>;

  double value = 0.0;
  Gradient gradient = Gradient::Zero();
  Hessian hessian = Hessian::Zero();

  SecondOrder() = default;
  SecondOrder(double constant) // NOLINT(google-explicit-constructor): a constant is such a number
    : value(constant)
  {
  }
  /// Returns the variable with the index `index`.
  static SecondOrder variable(double value, int index)
  {
    SecondOrder x(value);
    x.gradient[index] = 1.0;
    return x;
  }

  SecondOrder& operator+=(const SecondOrder& other)
  {
    this->value += other.value;
    this->gradient += other.gradient;
    this->hessian += other.hessian;
    return *this;
  }
  SecondOrder& operator-=(const SecondOrder& other) { return *this += -1.0 * other; }
  SecondOrder& operator*=(double factor)
  {
    this->value *= factor;
    this->gradient *= factor;
    this->hessian *= factor;
    return *this;
  }
  friend SecondOrder operator+(SecondOrder x, const SecondOrder& y) { return x += y; }
  friend SecondOrder operator-(SecondOrder x, const SecondOrder& y) { return x -= y; }
  friend SecondOrder operator*(double factor, SecondOrder x) { return x *= factor; }
  friend SecondOrder operator*(SecondOrder x, double factor) { return x *= factor; }
  friend SecondOrder operator*(const SecondOrder& x, const SecondOrder& y)
  {
    SecondOrder product(x.value * y.value);
    product.gradient = x.value * y.gradient + y.value * x.gradient;
    product.hessian = x.value * y.hessian + y.value * x.hessian;
    product.hessian += x.gradient * y.gradient.transpose();
    product.hessian += y.gradient * x.gradient.transpose();
    return product;
  }
};

/// Returns f(x), computed from the value and the first two derivatives of f at x.
template <int N>
SecondOrder<N> compose(const SecondOrder<N>& x, double f, double first, double second)
{
  SecondOrder<N> result(f);
  result.gradient = first * x.gradient;
  result.hessian = first * x.hessian + second * x.gradient * x.gradient.transpose();
  return result;
}
inline double compose(double, double f, double, double)
{
  return f;
}

template <int N>
double valueOf(const SecondOrder<N>& x)
{
  return x.value;
}
inline double valueOf(double x)
{
  return x;
}
} // namespace palpate

#endif
