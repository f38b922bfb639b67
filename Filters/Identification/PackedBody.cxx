// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/PackedBody.h"

#include "Identification/FitVerdict.h"

#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
PackedBody::PackedBody(BodyModel model, bool findContact, std::vector<FirstContact> starts)
  : Model(model)
  , Offsets(findContact ? static_cast<Eigen::Index>(starts.size()) : 0)
  , Starts(std::move(starts))
{
  this->BaselineInputs = this->firstOfBaseline(this->Starts.size()) - this->bodyInputs();
}

Eigen::Index PackedBody::firstOfBaseline(std::size_t curve) const
{
  Eigen::Index first = this->materialCount() + this->Offsets;
  for (std::size_t i = 0; i < curve; ++i)
  {
    first += this->countOfBaseline(i);
  }
  return first;
}

ForceBaseline PackedBody::baseline(const Eigen::VectorXd& p, std::size_t curve) const
{
  const Eigen::Index first = this->firstOfBaseline(curve);
  const Eigen::Index count = this->countOfBaseline(curve);
  return { count > 0 ? p[first] * this->Force : 0.0,
    count > 1 ? p[first + 1] * this->Force / this->Depth : 0.0,
    this->Starts[curve].baseline.reference };
}

void PackedBody::fillBaseline(Eigen::MatrixXd& jacobian, Eigen::Index row, std::size_t curve,
  double deflection, double readings) const
{
  const Eigen::Index first = this->firstOfBaseline(curve);
  const Eigen::Index count = this->countOfBaseline(curve);
  const double weight = std::sqrt(readings);
  if (count > 0)
  {
    jacobian(row, first) = weight;
  }
  if (count > 1)
  {
    jacobian(row, first + 1) =
      weight * (deflection - this->Starts[curve].baseline.reference) / this->Depth;
  }
}

void PackedBody::packBody(const BodyParameters& body, const std::vector<double>& offsets,
  const std::vector<ForceBaseline>& baselines, Eigen::VectorXd& p) const
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
  for (std::size_t curve = 0; curve < this->Starts.size(); ++curve)
  {
    const Eigen::Index first = this->firstOfBaseline(curve);
    const Eigen::Index count = this->countOfBaseline(curve);
    if (count > 0)
    {
      p[first] = baselines[curve].offset / this->Force;
    }
    if (count > 1)
    {
      p[first + 1] = baselines[curve].drift * this->Depth / this->Force;
    }
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
  for (std::size_t curve = 0; curve < this->Starts.size(); ++curve)
  {
    const Eigen::Index first = this->firstOfBaseline(curve);
    const Eigen::Index count = this->countOfBaseline(curve);
    fit.errorPerNoise.segment(first, count) *= this->Force;
    fit.errorPerNoise.segment(first, count).tail(count > 1 ? 1 : 0) /= this->Depth;
  }
}

double PackedBody::modulusError(const Eigen::MatrixXd& jacobian) const
{
  const JacobianVerdict verdict = judgeJacobian(jacobian);
  return verdict.separation > 1e-6 ? verdict.error[0] / this->Force
                                   : std::numeric_limits<double>::infinity();
}
} // namespace palpate
