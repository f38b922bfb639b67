// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyFit_h
#define palpate_BodyFit_h

#include "Identification/FirstContact.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/SeriesCompliance.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// The models of the body at a site.
enum class BodyModel
{
  HalfSpace,        ///< parameter: E*
  GlobalCompliance, ///< parameters: E* and C_g, which is in series with the half-space
  Layer             ///< parameters: E* and thickness h of a layer on a rigid base
};

/// The parameters of a body.
struct BodyParameters
{
  BodyModel model = BodyModel::HalfSpace;
  double reducedModulus = 0.0; ///< E*, MPa
  double compliance = 0.0;     ///< C_g, mm/N
  double thickness = 0.0;      ///< h, mm; 0 if there is no layer
};

/// The loading of one tool: readings in ascending order of depth, measured from any origin. For a
/// fit the readings must be arranged and have an estimate of first contact (ArrangedReadings.h).
struct IndentationCurve
{
  const AxisymmetricTool* tool = nullptr;
  std::vector<double> deflection; ///< mm
  std::vector<double> force;      ///< N
  /// Number of readings averaged in each value; empty if each value is a single reading.
  std::vector<double> readings;
  FirstContact start;

  void append(double depth, double value, double count)
  {
    this->deflection.push_back(depth);
    this->force.push_back(value);
    this->readings.push_back(count);
  }
  /// Returns the largest net force, N.
  double largestForce() const
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->force.size(); ++i)
    {
      largest = std::max(largest, this->netForce(i));
    }
    return largest;
  }
  /// Returns the force of a reading minus the estimated baseline, N.
  double netForce(std::size_t reading) const
  {
    return this->force[reading] - this->start.baseline.at(this->deflection[reading]);
  }
};

/// Returns the response of a body to a tool at a deflection, mm. `kernel` is needed only for a
/// layer.
PALPATE_EXPORT SeriesPoint bodyResponse(const BodyParameters& body, const AxisymmetricTool& tool,
  const std::shared_ptr<const LayerKernel>& kernel, double deflection);

/// Returns the local contact of a tool, without the compliance in series. `kernel` is needed only
/// for a layer.
PALPATE_EXPORT IndentationPoint localContact(const BodyParameters& body,
  const AxisymmetricTool& tool, const std::shared_ptr<const LayerKernel>& kernel,
  double deflection);

/// A body fitted to curves, and the accuracy of the fit.
struct PALPATE_EXPORT BodyFit
{
  BodyParameters body;
  std::vector<double> contactOffset;   ///< depth of first contact of each curve, mm
  std::vector<ForceBaseline> baseline; ///< baseline of each curve
  std::vector<BaselineTerms> terms;    ///< fitted terms of each baseline
  /// Sum of squared force residuals over all single readings, N².
  double sumOfSquares = 0.0;
  int degreesOfFreedom = 0;
  bool converged = false;
  /// Standard errors of the fitted parameters, each divided by the standard deviation of the noise
  /// (N). Order: ln E*; C_g or ln h; depths of first contact; fitted terms of each baseline. The
  /// error is +inf for parameters that the curves do not determine.
  Eigen::VectorXd errorPerNoise;
  /// Matrix S with one row for ln E* and one for C_g or ln h. S Sᵀ is the covariance of these
  /// parameters divided by the variance of the noise (N²). Empty if the curves do not determine
  /// these parameters.
  Eigen::MatrixXd spreadPerNoise;
  /// The smallest sine of the angle between the effect of one parameter on the forces and the
  /// effects of the other parameters. 0 if two parameters cannot be separated.
  double separation = 0.0;

  /// Returns the root mean square residual of a reading, N.
  double residual() const;
};

/**
 * Fits a body by non-linear least squares (Levenberg and Marquardt) of the force. The parameters
 * are E*, C_g or h, the depth of first contact of each curve (fixed at 0 if `findContact` is
 * false), and the terms of each baseline that the readings determine. Returns no value if no
 * initial body leads to a finite E*, or if the number of readings does not exceed the number of
 * parameters.
 */
PALPATE_EXPORT std::optional<BodyFit> fitBody(const std::vector<IndentationCurve>& curves,
  BodyModel model, bool findContact, const std::shared_ptr<const LayerKernel>& kernel);

/// Returns the standard error that ln E* would have if C_g (0 here) were also unknown, divided by
/// the standard deviation of the noise (N).
PALPATE_EXPORT double modulusErrorBesideCompliance(
  const std::vector<IndentationCurve>& curves, const BodyFit& halfSpace, bool findContact);
} // namespace palpate

#endif
