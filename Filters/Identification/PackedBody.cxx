// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/PackedBody.h"

#include "Identification/FitVerdict.h"

#include <cmath>
#include <limits>

namespace palpate
{
void PackedBody::packBody(
  const BodyParameters& body, const std::vector<double>& offsets, Eigen::VectorXd& p) const
{
  p[0] = std::log(body.reducedModulus);
  if (this->Model != BodyModel::HalfSpace)
  {
    p[1] = this->Model == BodyModel::Layer ? std::log(body.thickness)
                                           : body.compliance / this->compliance();
  }
  for (Eigen::Index i = 0; i < this->Offsets; ++i)
  {
    p[this->materialCount() + i] = offsets[static_cast<std::size_t>(i)] / this->Depth;
  }
}

BodyParameters PackedBody::body(const Eigen::VectorXd& p) const
{
  BodyParameters body;
  body.model = this->Model;
  body.reducedModulus = std::exp(p[0]);
  body.compliance = this->Model == BodyModel::GlobalCompliance ? p[1] * this->compliance() : 0.0;
  body.thickness = this->Model == BodyModel::Layer ? std::exp(p[1]) : 0.0;
  return body;
}

bool PackedBody::isUsable(const BodyParameters& body)
{
  return body.reducedModulus > 0.0 && std::isfinite(body.reducedModulus) &&
    std::isfinite(body.compliance) &&
    (body.model != BodyModel::Layer || (body.thickness > 0.0 && std::isfinite(body.thickness)));
}

void PackedBody::judge(const Eigen::MatrixXd& jacobian, BodyFit& fit) const
{
  const JacobianVerdict verdict = judgeJacobian(jacobian);
  fit.separation = verdict.separation;
  fit.errorPerNoise = verdict.error / this->Force;
  if (verdict.spread.size() > 0)
  {
    fit.spreadPerNoise = verdict.spread.topRows(this->materialCount()) / this->Force;
  }
  if (this->Model == BodyModel::GlobalCompliance)
  {
    fit.errorPerNoise[1] *= this->compliance();
    if (fit.spreadPerNoise.size() > 0)
    {
      fit.spreadPerNoise.row(1) *= this->compliance();
    }
  }
  fit.errorPerNoise.segment(this->materialCount(), this->Offsets) *= this->Depth;
}

double PackedBody::modulusError(const Eigen::MatrixXd& jacobian) const
{
  const JacobianVerdict verdict = judgeJacobian(jacobian);
  return verdict.separation > 1e-6 ? verdict.error[0] / this->Force
                                   : std::numeric_limits<double>::infinity();
}
} // namespace palpate
