// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialLaw_h
#define palpate_TrialLaw_h

#include "Identification/BodyFit.h"
#include "Mechanics/Layers/LayerContact.h"

#include <cmath>
#include <memory>
#include <optional>

namespace palpate
{
/// Force at one depth below first contact, and its derivatives with respect to the parameters of
/// the body.
struct Sensitivity
{
  double force = 0.0;
  double stiffness = 0.0;
  double byLogModulus = 0.0;
  double bySecond = 0.0; ///< derivative with respect to C_g or ln h
};

/// The law of one tool on a trial body during a fit.
class TrialLaw
{
public:
  TrialLaw(const BodyParameters& body, const AxisymmetricTool& tool,
    const std::shared_ptr<const LayerKernel>& kernel)
    : Body(body)
    , Tool(tool)
  {
    if (body.model == BodyModel::Layer)
    {
      this->Layer.emplace(tool, kernel, body.thickness);
      this->Thicker.emplace(tool, kernel, body.thickness * std::exp(ThicknessStep));
    }
  }

  Sensitivity at(double deflection) const
  {
    Sensitivity result;
    const double modulus = this->Body.reducedModulus;
    if (!(deflection > 0.0))
    {
      return result;
    }
    if (this->Body.model == BodyModel::Layer)
    {
      const IndentationPoint point = this->Layer->evaluate(deflection, modulus);
      const double thicker = this->Thicker->evaluate(deflection, modulus).force;
      result = { point.force, point.stiffness, point.force,
        (thicker - point.force) / ThicknessStep };
    }
    else
    {
      const double compliance = this->Body.compliance;
      const SeriesPoint point = seriesResponse(this->Tool, modulus, compliance, deflection);
      // S = K/(1+CK) with the local stiffness K. Therefore dF/d ln E* = F/(1+CK) and dF/dC = -F S.
      result = { point.force, point.stiffness, point.force * (1.0 - compliance * point.stiffness),
        -point.force * point.stiffness };
    }
    return result;
  }

private:
  static constexpr double ThicknessStep = 1e-5; // step of ln h; the law is smooth to 1e-10

  BodyParameters Body;
  const AxisymmetricTool& Tool;
  std::optional<LayerContact> Layer;
  std::optional<LayerContact> Thicker;
};
} // namespace palpate

#endif
