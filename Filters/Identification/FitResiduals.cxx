// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/FitResiduals.h"

#include <cmath>

namespace palpate
{
int FitResiduals::evaluate(
  const Eigen::VectorXd& p, Eigen::VectorXd* residuals, Eigen::MatrixXd* jacobian) const
{
  const BodyParameters trial = this->body(p);
  if (!isUsable(trial))
  {
    if (residuals)
    {
      residuals->setConstant(Astray);
    }
    if (jacobian)
    {
      jacobian->setZero();
    }
    return 0;
  }
  Eigen::Index row = 0;
  for (std::size_t c = 0; c < this->Curves.size(); ++c)
  {
    const IndentationCurve& curve = this->Curves[c];
    const TrialLaw law(trial, *curve.tool, this->Kernel);
    const ForceBaseline baseline = this->baseline(p, c);
    for (std::size_t i = 0; i < curve.force.size(); ++i, ++row)
    {
      const Sensitivity at = law.at(curve.deflection[i] - this->offset(p, c));
      if (residuals)
      {
        const double left = at.force + baseline.at(curve.deflection[i]) - curve.force[i];
        (*residuals)[row] =
          std::isfinite(at.force) ? std::sqrt(curve.readings[i]) * left / this->Force : Astray;
      }
      if (jacobian)
      {
        this->fillRow(*jacobian, row, c, i, at);
      }
    }
  }
  return 0;
}

void FitResiduals::fillRow(Eigen::MatrixXd& jacobian, Eigen::Index row, std::size_t curve,
  std::size_t reading, const Sensitivity& at) const
{
  const double readings = this->Curves[curve].readings[reading];
  const double weight = std::sqrt(readings) / this->Force;
  jacobian.row(row).setZero();
  if (!std::isfinite(at.force) || !std::isfinite(at.bySecond))
  {
    return;
  }
  jacobian(row, 0) = weight * at.byLogModulus;
  if (this->Model != BodyModel::HalfSpace)
  {
    jacobian(row, 1) = weight * at.bySecond * this->secondScale();
  }
  if (this->Offsets > 0)
  {
    jacobian(row, this->materialCount() + static_cast<Eigen::Index>(curve)) =
      -weight * at.stiffness * this->Depth;
  }
  this->fillBaseline(jacobian, row, curve, this->Curves[curve].deflection[reading], readings);
}
} // namespace palpate
