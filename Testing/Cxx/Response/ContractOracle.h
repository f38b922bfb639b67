// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ContractOracle_h
#define palpate_testing_ContractOracle_h

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace palpate::testing
{
/**
 * The data contract evaluated directly by its definition, slow and independent of the kernel: F(δ)
 * = δ^m r(s), s = √(δ/δ_max), r the cubic Hermite interpolant of r_i = F_i/δ_i^m with r'_i = (K_i -
 * m F_i/δ_i) (dδ/ds)/δ_i^m; below δ_1 the power start, beyond δ_max the tangent.
 */
class ContractOracle
{
public:
  explicit ContractOracle(vtkPolyData* body, const std::string& name = "Response")
    : Force(body->GetPointData()->GetArray((name + "Force").c_str()))
    , Stiffness(body->GetPointData()->GetArray((name + "Stiffness").c_str()))
    , Normal(body->GetPointData()->GetArray((name + "Normal").c_str()))
    , Range(body->GetPointData()->GetArray((name + "Range").c_str()))
    , Exponent(body->GetFieldData()->GetArray((name + "Exponent").c_str())->GetTuple1(0))
    , Samples(this->Force->GetNumberOfComponents())
  {
  }

  double force(vtkIdType point, double depth) const
  {
    const double range = this->Range->GetTuple1(point);
    const double m = this->Exponent;
    const auto at = [&](int i) // i = 1..n
    {
      const double s = static_cast<double>(i) / this->Samples;
      return std::array<double, 4>{ s, range * s * s, this->Force->GetComponent(point, i - 1),
        this->Stiffness->GetComponent(point, i - 1) };
    };
    if (depth <= 0.0)
    {
      return 0.0;
    }
    if (depth >= range)
    {
      return at(this->Samples)[2] + at(this->Samples)[3] * (depth - range);
    }
    const auto [s1, d1, f1, k1] = at(1);
    if (depth < d1)
    {
      return f1 == 0.0 ? 0.0 : f1 * std::pow(depth / d1, k1 * d1 / f1);
    }
    const double s = std::sqrt(depth / range);
    const int i = std::min(static_cast<int>(s * this->Samples), this->Samples - 1);
    const auto left = at(i);
    const auto right = at(i + 1);
    const auto value = [m](const std::array<double, 4>& x) { return x[2] / std::pow(x[1], m); };
    const auto slope = [m, range](const std::array<double, 4>& x)
    { return (x[3] - m * x[2] / x[1]) * 2.0 * range * x[0] / std::pow(x[1], m); };
    const double h = right[0] - left[0];
    const double t = (s - left[0]) / h;
    const double r = (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) * value(left) +
      t * (1.0 - t) * (1.0 - t) * h * slope(left) + t * t * (3.0 - 2.0 * t) * value(right) +
      t * t * (t - 1.0) * h * slope(right);
    return std::pow(depth, m) * r;
  }

  void normal(vtkIdType point, double n[3]) const { this->Normal->GetTuple(point, n); }

private:
  vtkDataArray* Force;
  vtkDataArray* Stiffness;
  vtkDataArray* Normal;
  vtkDataArray* Range;
  double Exponent;
  int Samples;
};
} // namespace palpate::testing

#endif
