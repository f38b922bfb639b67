// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationResiduals_h
#define palpate_RelaxationResiduals_h

#include "Identification/PackedBody.h"
#include "Identification/PressHistory.h"
#include "Identification/RelaxingFoundation.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/// A relaxing body, and the first contact of each history.
struct RelaxingBody
{
  BodyParameters body; ///< slow response
  PronySeries series;
  std::vector<double> contactOffset; ///< mm
  std::vector<ForceBaseline> baseline;
};

/// The unknowns of a fit: the model, the number of branches, and the number of blocks of elements.
/// If the number of branches is 0, `given` is used.
struct RelaxationProblem
{
  BodyModel model = BodyModel::HalfSpace;
  bool findContact = true;
  std::shared_ptr<const LayerKernel> kernel;
  std::size_t branches = 0;
  PronySeries given; ///< series that is used if branches is 0
  std::size_t blocks = 3;
};

/**
 * The residuals of histories, for Eigen's LevenbergMarquardt. The parameters are those of
 * PackedBody, followed by ln p_i and ln τ_i.
 *
 * Derivatives with respect to the parameters of the body are exact, because the elements do not
 * depend on the body. Derivatives with respect to offsets, strengths and times are finite
 * differences.
 */
class RelaxationResiduals : public PackedBody
{
public:
  /// `histories` must outlive this object.
  RelaxationResiduals(const std::vector<PressHistory>& histories, const RelaxationProblem& problem);

  Eigen::Index inputs() const { return this->firstStrength() + 2 * this->branches(); }
  /// Index of the first ln p_i.
  Eigen::Index firstStrength() const { return this->bodyInputs(); }

  Eigen::VectorXd pack(const RelaxingBody& body) const;
  RelaxingBody unpack(const Eigen::VectorXd& p) const;

  int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& residuals) const
  {
    return this->evaluate(p, &residuals, nullptr);
  }
  int df(const Eigen::VectorXd& p, Eigen::MatrixXd& jacobian) const
  {
    return this->evaluate(p, nullptr, &jacobian);
  }

private:
  Eigen::Index branches() const { return static_cast<Eigen::Index>(this->Problem.branches); }
  int evaluate(
    const Eigen::VectorXd& p, Eigen::VectorXd* residuals, Eigen::MatrixXd* jacobian) const;
  void fillRows(const RelaxingBody& trial, std::size_t index, Eigen::Index row,
    Eigen::VectorXd* residuals, Eigen::MatrixXd* jacobian) const;

  const std::vector<PressHistory>& Histories;
  RelaxationProblem Problem;
};

/// Returns the slow curve of a body at the depths of a foundation, followed by its derivatives with
/// respect to ln E* and, if the model has this parameter, to C_g or ln h.
std::vector<RelaxingFoundation::SlowCurve> slowCurves(const BodyParameters& body,
  const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  const RelaxingFoundation& foundation);
} // namespace palpate

#endif
