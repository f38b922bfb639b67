// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitResiduals_h
#define palpate_FitResiduals_h

#include "Identification/PackedBody.h"
#include "Identification/TrialLaw.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/// The residuals of arranged loading curves, for Eigen's LevenbergMarquardt. The parameters are
/// those of PackedBody.
class FitResiduals : public PackedBody
{
public:
  FitResiduals(const std::vector<IndentationCurve>& curves, BodyModel model, bool findContact,
    const std::shared_ptr<const LayerKernel>& kernel)
    : PackedBody(model, findContact, startsOf(curves))
    , Curves(curves)
    , Kernel(kernel)
  {
    for (const IndentationCurve& curve : curves)
    {
      this->Count += static_cast<Eigen::Index>(curve.force.size());
      this->Force = std::max(this->Force, curve.largestForce());
      this->Depth = std::max(this->Depth, curve.deflection.back() - curve.deflection.front());
    }
  }

  Eigen::Index inputs() const { return this->bodyInputs(); }

  Eigen::VectorXd pack(const BodyParameters& body, const std::vector<double>& offsets,
    const std::vector<ForceBaseline>& baselines) const
  {
    Eigen::VectorXd p(this->inputs());
    this->packBody(body, offsets, baselines, p);
    return p;
  }

  int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& residuals) const
  {
    return this->evaluate(p, &residuals, nullptr);
  }
  int df(const Eigen::VectorXd& p, Eigen::MatrixXd& jacobian) const
  {
    return this->evaluate(p, nullptr, &jacobian);
  }

private:
  static std::vector<FirstContact> startsOf(const std::vector<IndentationCurve>& curves)
  {
    std::vector<FirstContact> starts;
    for (const IndentationCurve& curve : curves)
    {
      starts.push_back(curve.start);
    }
    return starts;
  }
  int evaluate(
    const Eigen::VectorXd& p, Eigen::VectorXd* residuals, Eigen::MatrixXd* jacobian) const;
  void fillRow(Eigen::MatrixXd& jacobian, Eigen::Index row, std::size_t curve, std::size_t reading,
    const Sensitivity& at) const;

  const std::vector<IndentationCurve>& Curves;
  std::shared_ptr<const LayerKernel> Kernel;
};
} // namespace palpate

#endif
