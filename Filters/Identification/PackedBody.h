// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PackedBody_h
#define palpate_PackedBody_h

#include "Identification/BodyFit.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * Packs a fitted body and the first contacts of its curves into parameters of order one, in this
 * order: ln E*; C_g divided by a reference, or ln h; the depths of first contact divided by a
 * reference depth; the fitted offset and drift of each baseline divided by the largest force.
 * Residuals are divided by the largest force. This is the common base class of all residual
 * classes.
 */
class PackedBody
{
public:
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  /// Required by Eigen's optimisers.
  enum
  {
    InputsAtCompileTime = Eigen::Dynamic,
    ValuesAtCompileTime = Eigen::Dynamic
  };

  Eigen::Index values() const { return this->Count; }
  /// Number of parameters of the material: 1 for a half-space, else 2.
  Eigen::Index materialCount() const { return this->Model == BodyModel::HalfSpace ? 1 : 2; }
  /// Number of parameters for the material and the first contacts.
  Eigen::Index bodyInputs() const
  {
    return this->materialCount() + this->Offsets + this->BaselineInputs;
  }
  double force() const { return this->Force; }
  double depth() const { return this->Depth; }
  /// Returns the C_g with which the largest force causes a deflection equal to the whole range of
  /// depth.
  double compliance() const { return this->Depth / this->Force; }

  BodyParameters body(const Eigen::VectorXd& p) const;
  double offset(const Eigen::VectorXd& p, std::size_t curve) const
  {
    return this->Offsets > 0
      ? p[this->materialCount() + static_cast<Eigen::Index>(curve)] * this->Depth
      : 0.0;
  }
  ForceBaseline baseline(const Eigen::VectorXd& p, std::size_t curve) const;

  /// Returns whether a sum of squares is that of a valid body. For an invalid body, each residual
  /// is Astray.
  static bool isBody(double squares) { return squares < Astray * Astray; }

  /// Computes the separation, the spread, and the errors of body and offsets from the Jacobian at
  /// the minimum. Errors of parameters after those of PackedBody are not unpacked.
  void judge(const Eigen::MatrixXd& jacobian, BodyFit& fit) const;
  /// Returns the standard error of ln E* divided by the standard deviation of the noise (N), from
  /// the Jacobian at the minimum.
  double modulusError(const Eigen::MatrixXd& jacobian) const;

protected:
  /// `starts` are the estimated first contacts of the curves.
  PackedBody(BodyModel model, bool findContact, std::vector<FirstContact> starts);

  /// Packs a body into the first parameters of `p`.
  void packBody(const BodyParameters& body, const std::vector<double>& offsets,
    const std::vector<ForceBaseline>& baselines, Eigen::VectorXd& p) const;
  /// Sets the derivatives of a residual with respect to the baseline of its curve.
  void fillBaseline(Eigen::MatrixXd& jacobian, Eigen::Index row, std::size_t curve,
    double deflection, double readings) const;
  /// Returns whether a step has resulted in a valid body.
  static bool isUsable(const BodyParameters& body);
  /// Scale by which C_g is packed; 1 for ln h.
  double secondScale() const
  {
    return this->Model == BodyModel::GlobalCompliance ? this->compliance() : 1.0;
  }

  /// The residual of an invalid body or of a force that is not finite. It is so large that the
  /// optimiser rejects the step.
  static constexpr double Astray = 1e3;

  BodyModel Model;
  Eigen::Index Offsets; ///< number of fitted depths of first contact
  Eigen::Index BaselineInputs = 0;
  Eigen::Index Count = 0; ///< number of residuals
  double Force = 0.0;     ///< largest force, N
  double Depth = 0.0;     ///< largest range of a curve, mm

private:
  /// Index of the first parameter of a curve's baseline, and the number of these parameters.
  Eigen::Index firstOfBaseline(std::size_t curve) const;
  Eigen::Index countOfBaseline(std::size_t curve) const
  {
    return static_cast<Eigen::Index>(this->Starts[curve].terms);
  }

  std::vector<FirstContact> Starts;
};
} // namespace palpate

#endif
