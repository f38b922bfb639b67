// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/PredictedForceError.h"

#include "Mechanics/Numerics/Constants.h"

#include <cmath>
#include <limits>

namespace palpate
{
double predictedForceError(const IdentifiedBody& body, const AxisymmetricTool& tool,
  const std::shared_ptr<const LayerKernel>& kernel, double deflection)
{
  constexpr double step = 1e-3;
  const auto forceOf = [&](double modulus, double second)
  {
    BodyParameters moved = body.body;
    moved.reducedModulus *= modulus;
    (moved.model == BodyModel::Layer ? moved.thickness : moved.compliance) = second;
    const SeriesPoint point = bodyResponse(moved, tool, kernel, deflection);
    return point.stable ? point.force : std::numeric_limits<double>::quiet_NaN();
  };
  const bool isLayer = body.body.model == BodyModel::Layer;
  const double second = isLayer ? body.body.thickness : body.body.compliance;
  const double force = forceOf(1.0, second);
  if (!(force > 0.0) || body.spread.size() == 0)
  {
    return 1.0;
  }
  // Derivatives of ln F with respect to ln E* and the second parameter.
  Eigen::VectorXd gradient(body.spread.rows());
  gradient[0] = (forceOf(1.0 + step, second) - forceOf(1.0 - step, second)) / (2.0 * step * force);
  if (gradient.size() > 1)
  {
    const double width = step * (isLayer ? second : deflection / force);
    gradient[1] = (forceOf(1.0, second + width) - forceOf(1.0, second - width)) /
      (2.0 * force * (isLayer ? step : width));
  }
  const double open = (gradient.transpose() * body.spread).norm();
  const double unfitted = body.withinNoise ? 0.0 : Normal95 * body.misfit / body.largestForce;
  return std::isfinite(open) ? open + unfitted : 1.0;
}
} // namespace palpate
