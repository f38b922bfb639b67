// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/StrainWindow.h"

#include "Mechanics/Layers/LayerContact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
double smallStrainDepth(const AxisymmetricTool& tool, const BodyParameters& body,
  const std::shared_ptr<const LayerKernel>& kernel, double strain)
{
  const double depth = tool.depthAtStrain(strain);
  if (!(depth > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  if (body.model != BodyModel::Layer)
  {
    return depth;
  }
  const double compressed = 0.5 * strain * body.thickness;
  const double radius = std::isfinite(depth) ? tool.contactRadius(depth) : 0.0;
  if (!(radius > tool.smallestContactRadius()))
  {
    return std::min(depth, compressed);
  }
  const double reached = LayerContact(tool, kernel, body.thickness).depthAtContactRadius(radius);
  return std::isfinite(reached) ? std::min(reached, compressed) : compressed;
}

IndentationCurve readingsWithin(const IndentationCurve& curve, const BodyParameters& body,
  double contactOffset, const ForceBaseline& baseline,
  const std::shared_ptr<const LayerKernel>& kernel, double strain)
{
  const double limit = smallStrainDepth(*curve.tool, body, kernel, strain);
  IndentationCurve kept;
  kept.tool = curve.tool;
  for (std::size_t i = 0; i < curve.force.size(); ++i)
  {
    const double given =
      body.compliance * std::max(curve.force[i] - baseline.at(curve.deflection[i]), 0.0);
    if (curve.deflection[i] - contactOffset - given <= limit)
    {
      kept.deflection.push_back(curve.deflection[i]);
      kept.force.push_back(curve.force[i]);
    }
  }
  return kept;
}
} // namespace palpate
