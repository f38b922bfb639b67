// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyIdentification_h
#define palpate_BodyIdentification_h

#include "Identification/BodyFit.h"
#include "Identification/Estimate.h"
#include "Identification/ForceNoise.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Options of an identification: known properties, and limits for an acceptable fit.
struct IdentificationOptions
{
  /// The model to fit. If it is not given, the simplest sufficient model is chosen.
  std::optional<BodyModel> model;
  double noise = 0.0;        ///< standard deviation of a force reading, N; with 0, it is estimated
  double poissonRatio = 0.5; ///< Poisson's ratio of a layer
  LayerBase base = LayerBase::Bonded;
  bool findContact = true; ///< false if deflections are measured from first contact
  /// Largest contact radius divided by tip radius up to which readings are used.
  double largestStrain = 0.4;
  double largestMisfit = 0.02; ///< largest residual as a fraction of the largest force
  /// Largest half width of the confidence interval of E*, relative to E*.
  double largestUncertainty = 0.5;
  /// The relaxation of the body, if it is known in advance. If it has no branches, the relaxation
  /// is identified.
  PronySeries relaxation;
};

/// The body identified at one site.
struct IdentifiedBody
{
  /// The reason why no body was identified; empty if a body was identified.
  std::string refusal;

  BodyParameters body;
  Estimate reducedModulus;             ///< MPa
  Estimate compliance;                 ///< mm/N; for BodyModel::GlobalCompliance
  Estimate thickness;                  ///< mm; for BodyModel::Layer
  std::vector<Estimate> contactOffset; ///< depth of first contact of each curve, mm
  std::vector<Estimate> forceOffset;   ///< force offset of each curve at first contact, N
  /// Force drift of each curve, N/mm. If the drift is not determined, the interval is 0 to 0.
  std::vector<Estimate> forceDrift;
  /// Baseline of each curve, computed from forceOffset and forceDrift.
  std::vector<ForceBaseline> baseline;
  /// The relaxation of the body. The other parameters then describe the slow response. Without
  /// branches, the body is elastic.
  PronySeries relaxation;
  std::vector<Estimate> relaxationStrength; ///< p_i
  std::vector<Estimate> relaxationTime;     ///< τ_i, s
  /// Shortest time that the test can resolve, s.
  double shortestTime = std::numeric_limits<double>::quiet_NaN();
  /// Longest time that the test can resolve, s.
  double longestTime = std::numeric_limits<double>::quiet_NaN();
  /// The readings that were not used, and the quantities that are not determined.
  std::string remark;
  /// Matrix S with one row for ln E* and one for C_g or ln h. S Sᵀ is the covariance of these
  /// parameters, multiplied by the square of the factor from a standard error to half a 95 %
  /// interval.
  Eigen::MatrixXd spread;

  double noise = 0.0; ///< standard deviation of a reading, N; given or estimated
  /// Residual of the fit per reading, N. For a suitable model it is about equal to the noise.
  double misfit = 0.0;
  double largestForce = 0.0; ///< largest force of the readings used, N
  bool withinNoise = false;  ///< false if the residual of the best model exceeds the noise

  // The end of the used data, computed from the fitted curves.
  double endForce = 0.0;     ///< N
  double endStiffness = 0.0; ///< dF/dδ, N/mm
  IndentationPoint end;      ///< end of the curve with the largest contact radius, without C_g
  double endDepth = 0.0;     ///< depth at `end`, mm, without C_g
};

/**
 * Identifies the elastic body at one site from the loading curves of one or several tools.
 *
 * Three models are fitted: a half-space (E*), a half-space in series with a global compliance (E*,
 * C_g > 0), and a layer on a rigid base (E*, h; Poisson's ratio is given). A model is within the
 * noise under two conditions: its residual does not exceed the noise (an F test at three standard
 * deviations), and no model with more parameters reduces the residual by more than noise would (a
 * likelihood ratio test at 1 %). The result is the simplest model within the noise. If no model is
 * within the noise, the result is the model with the smallest residual, provided this residual is
 * below `largestMisfit`; withinNoise is then false.
 *
 * The laws are those of small strain. Readings at larger strain than `largestStrain`
 * (StrainWindow.h) are not used; `remark` reports their number. The corresponding depth depends on
 * the body. Therefore the fit and the selection of readings alternate.
 *
 * In addition to the body, the fit determines the depth of first contact of each curve. It also
 * determines the offset of the force and its drift with the depth, if the readings before contact
 * suffice (ArrangedReadings.h).
 *
 * In the following cases no body is identified, and the reason is returned:
 * - there are too few readings;
 * - the readings before contact are not on a straight line;
 * - the global compliance is below 0;
 * - the curves do not separate the parameters; for example, the curves of flat punches of one
 *   radius are straight lines for any E*, C_g and h;
 * - the uncertainty of E* would be above `largestUncertainty` if C_g were also unknown;
 * - no model has a sufficiently small residual.
 *
 * Confidence intervals are those of the linearised problem. They follow from the Jacobian and from
 * the given noise or the misfit (Student's t). The intervals of E* and h are symmetric in the
 * logarithm. Cost: a few milliseconds, or a tenth of a second for a layer. Immutable; can be used
 * from any number of threads.
 */
class PALPATE_EXPORT BodyIdentification
{
public:
  static constexpr std::size_t FewestReadings = 8;

  explicit BodyIdentification(const IdentificationOptions& options);

  /// Identifies the body. The readings of a curve need not be sorted. Many readings are averaged
  /// (ArrangedReadings.h).
  IdentifiedBody identify(std::vector<IndentationCurve> curves) const;

  const IdentificationOptions& options() const noexcept { return this->Options; }
  const std::shared_ptr<const LayerKernel>& kernel() const noexcept { return this->Kernel; }

private:
  struct Judgement
  {
    std::optional<BodyFit> fit;
    bool withinNoise = false;
    double largestForce = 0.0;
  };
  std::string choose(const std::vector<IndentationCurve>& curves, const ForceNoise& noise,
    Judgement& judgement) const;
  std::string select(const std::vector<IndentationCurve>& all, const BodyFit& fit,
    std::vector<IndentationCurve>& used, std::size_t& count) const;
  std::string judge(const std::vector<IndentationCurve>& curves, const ForceNoise& noise,
    Judgement& judgement) const;
  void report(const std::vector<IndentationCurve>& curves, bool noiseGiven, const BodyFit& fit,
    IdentifiedBody& result) const;
  std::string checkDetermined(
    const std::vector<IndentationCurve>& curves, const BodyFit& fit, double noise) const;

  IdentificationOptions Options;
  std::shared_ptr<const LayerKernel> Kernel;
};

/// Returns "half-space", "half-space in series with global compliance" or "layer on a rigid base".
PALPATE_EXPORT const char* nameOf(BodyModel model);
} // namespace palpate

#endif
