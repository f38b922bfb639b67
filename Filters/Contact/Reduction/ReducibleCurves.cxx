// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/ReducibleCurves.h"

namespace palpate
{
ReducibleCurves::ReducibleCurves(const ResponseArrays& arrays)
  : Arrays(arrays)
  , Sampling(arrays.samples, arrays.exponent)
{
  for (std::size_t p = 0; p < arrays.points; ++p)
  {
    if (arrays.isUsable(p))
    {
      this->Points.push_back(p);
    }
  }
}

Eigen::VectorXd ReducibleCurves::curve(std::size_t i) const
{
  const std::size_t point = this->Points[i];
  const Eigen::Index n = this->Arrays.samples;
  const auto row = [point](const float* values, Eigen::Index columns)
  {
    return Eigen::Map<const Eigen::VectorXf>(
      values + static_cast<std::size_t>(columns) * point, columns)
      .cast<double>();
  };
  if (this->Arrays.basis)
  {
    const Eigen::Index laws = this->Arrays.laws;
    return Eigen::Map<const Eigen::MatrixXf>(this->Arrays.basis, 2 * n, laws).cast<double>() *
      row(this->Arrays.coefficient, laws);
  }
  Eigen::VectorXd curve(2 * n);
  curve << row(this->Arrays.force, n), row(this->Arrays.stiffness, n);
  return curve;
}
} // namespace palpate
