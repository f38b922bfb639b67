// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FitResiduals_h
#define palpate_FitResiduals_h

#include "Mechanics/Identification/BodyFit.h"
#include "Mechanics/Identification/TrialLaw.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/**
 * The residuals for Eigen's LevenbergMarquardt. Parameters, all of order one: ln E*, then C_g over
 * a reference or ln h, then the offsets over a reference depth. Residuals over the largest force.
 */
class FitResiduals
{
public:
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  /// As Eigen's optimisers ask for it.
  enum
  {
    InputsAtCompileTime = Eigen::Dynamic,
    ValuesAtCompileTime = Eigen::Dynamic
  };

  FitResiduals(const std::vector<IndentationCurve>& curves, BodyModel model, bool findContact,
    const std::shared_ptr<const LayerKernel>& kernel)
    : Curves(curves)
    , Model(model)
    , FindContact(findContact)
    , Kernel(kernel)
  {
    for (const IndentationCurve& curve : curves)
    {
      this->Count += static_cast<Eigen::Index>(curve.force.size());
      this->Force =
        std::max(this->Force, *std::max_element(curve.force.begin(), curve.force.end()));
      this->Depth = std::max(this->Depth, curve.deflection.back() - curve.deflection.front());
    }
  }

  Eigen::Index inputs() const
  {
    return this->materialCount() +
      (this->FindContact ? static_cast<Eigen::Index>(this->Curves.size()) : 0);
  }
  Eigen::Index values() const { return this->Count; }
  Eigen::Index materialCount() const { return this->Model == BodyModel::HalfSpace ? 1 : 2; }
  double force() const { return this->Force; }
  double depth() const { return this->Depth; }
  /// C_g that yields the whole depth under the whole force.
  double compliance() const { return this->Depth / this->Force; }

  Eigen::VectorXd pack(const BodyParameters& body, const std::vector<double>& offsets) const
  {
    Eigen::VectorXd p(this->inputs());
    p[0] = std::log(body.reducedModulus);
    if (this->Model != BodyModel::HalfSpace)
    {
      p[1] = this->Model == BodyModel::Layer ? std::log(body.thickness)
                                             : body.compliance / this->compliance();
    }
    for (Eigen::Index i = this->materialCount(); i < p.size(); ++i)
    {
      p[i] = offsets[static_cast<std::size_t>(i - this->materialCount())] / this->Depth;
    }
    return p;
  }

  BodyParameters body(const Eigen::VectorXd& p) const
  {
    BodyParameters body;
    body.model = this->Model;
    body.reducedModulus = std::exp(p[0]);
    body.compliance = this->Model == BodyModel::GlobalCompliance ? p[1] * this->compliance() : 0.0;
    body.thickness = this->Model == BodyModel::Layer ? std::exp(p[1]) : 0.0;
    return body;
  }

  double offset(const Eigen::VectorXd& p, std::size_t curve) const
  {
    return this->FindContact
      ? p[this->materialCount() + static_cast<Eigen::Index>(curve)] * this->Depth
      : 0.0;
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
  int evaluate(
    const Eigen::VectorXd& p, Eigen::VectorXd* residuals, Eigen::MatrixXd* jacobian) const;
  void fillRow(Eigen::MatrixXd& jacobian, Eigen::Index row, std::size_t curve,
    const Sensitivity& at, double weight) const;

  const std::vector<IndentationCurve>& Curves;
  BodyModel Model;
  bool FindContact;
  std::shared_ptr<const LayerKernel> Kernel;
  Eigen::Index Count = 0;
  double Force = 0.0; ///< largest, N
  double Depth = 0.0; ///< largest range of a curve, mm
};
} // namespace palpate

#endif
