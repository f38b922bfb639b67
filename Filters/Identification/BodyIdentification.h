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
/// Known properties, and the limits of an acceptable fit.
struct IdentificationOptions
{
  /// The model to fit, if it is known from elsewhere; otherwise the simplest that suffices.
  std::optional<BodyModel> model;
  double noise = 0.0;         ///< standard deviation of a reading of force, N; 0: estimated
  double poissonsRatio = 0.5; ///< of a layer
  LayerBase base = LayerBase::Bonded;
  bool findContact = true;         ///< false: deflections are measured from first contact already
  double largestStrain = 0.4;      ///< contact radius over tip radius: deeper readings are not used
  double largestMisfit = 0.02;     ///< fraction of the largest force
  double largestUncertainty = 0.5; ///< of E*: half the confidence interval, relative
  /// How the body relaxes, if that is known from elsewhere; no branch: it is identified.
  PronySeries relaxation;
};

/// The body identified at one site.
struct IdentifiedBody
{
  /// Why no body was identified; empty if one was.
  std::string refusal;

  BodyParameters body;
  Estimate reducedModulus;             ///< MPa
  Estimate compliance;                 ///< mm/N, of BodyModel::GlobalCompliance
  Estimate thickness;                  ///< mm, of BodyModel::Layer
  std::vector<Estimate> contactOffset; ///< depth of first contact of each curve, mm
  std::vector<Estimate> forceOffset;   ///< of each curve, N, at first contact
  std::vector<Estimate> forceDrift;    ///< of each curve, N/mm; 0 to 0: its readings do not tell it
  std::vector<ForceBaseline> baseline; ///< of each curve, of these two
  /// How it relaxes; the numbers above are then the slow response. No branch: an elastic body.
  PronySeries relaxation;
  std::vector<Estimate> relaxationStrength;                       ///< p_i
  std::vector<Estimate> relaxationTime;                           ///< τ_i, s
  double shortestTime = std::numeric_limits<double>::quiet_NaN(); ///< that the test can resolve, s
  double longestTime = std::numeric_limits<double>::quiet_NaN();  ///< likewise
  std::string remark; ///< what was left out, and what the readings cannot tell
  /// A row each for ln E* and for C_g or ln h: S Sᵀ is their covariance, times the square of the
  /// factor from a standard error to half a 95 % interval.
  Eigen::MatrixXd spread;

  double noise = 0.0;        ///< standard deviation of a reading, N, given or estimated
  double misfit = 0.0;       ///< of the fit, N, per reading; about the noise if the model is right
  double largestForce = 0.0; ///< of the readings used, N
  bool withinNoise = false;  ///< false: the best model, whose residual exceeds the noise

  // The end of the data used, by the fitted curves.
  double endForce = 0.0;     ///< N
  double endStiffness = 0.0; ///< dF/dδ, N/mm
  IndentationPoint end;      ///< of the curve with the largest contact, without C_g
  double endDepth = 0.0;     ///< its depth, mm, without C_g
};

/**
 * Identifies the elastic body at one site from the loading curves of one or several tools.
 *
 * Three models are fitted: a half-space (E*), a half-space in series with a global compliance (E*,
 * C_g > 0), a layer on a rigid base (E*, h; Poisson's ratio given). A model is within the noise
 * when its residual is no larger than the noise (an F test at three standard deviations) and no
 * richer model reduces it by more than noise would (a likelihood ratio at 1 %). The result is the
 * simplest model within the noise. If there is none, it is the one with the least residual, if that
 * is below `largestMisfit`, and withinNoise is false.
 *
 * The laws are those of small strain. Readings deeper than `largestStrain` allows (StrainWindow.h)
 * are not used, which `remark` says; since that depth depends on the body, fit and choice of
 * readings alternate.
 *
 * With the body are fitted, of each curve, the depth of first contact, and an offset and a drift
 * with the depth of its force, where the readings before contact tell them (ArrangedReadings.h).
 *
 * Refused, with the reason: too few readings; readings before contact that do not lie on a straight
 * line; a global compliance below 0; curves from which the parameters cannot be separated,
 * as those of flat punches of one radius, which are straight lines whatever E*, C_g and h; an
 * uncertainty of E* above `largestUncertainty` if C_g were unknown as well; no model with a
 * residual small enough.
 *
 * Confidence intervals are those of the linearised problem, from the Jacobian and the noise (given)
 * or the misfit (Student's t); of E* and h symmetric in the logarithm. Cost: some milliseconds, a
 * tenth of a second for a layer. Immutable and safe to use from any number of threads.
 */
class PALPATE_EXPORT BodyIdentification
{
public:
  static constexpr std::size_t FewestReadings = 8;

  explicit BodyIdentification(const IdentificationOptions& options);

  /// The readings of a curve need not be sorted. Many are averaged (ArrangedReadings.h).
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

/// "half-space", "half-space in series with global compliance", "layer on a rigid base".
PALPATE_EXPORT const char* nameOf(BodyModel model);
} // namespace palpate

#endif
