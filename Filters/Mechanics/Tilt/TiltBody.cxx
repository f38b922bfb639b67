// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltBody.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Numerics/GaussLegendre.h"
#include "Mechanics/SeriesCompliance.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <cmath>
#include <optional>
#include <vector>

namespace palpate
{
namespace
{
const GaussLegendre& workRule()
{
  static const GaussLegendre rule(16);
  return rule;
}
} // namespace

std::string TiltBody::describe() const
{
  const std::string local =
    this->hasLayer() ? joined("a layer of ", this->thickness, " mm") : std::string("a half-space");
  return this->yielding == 0.0
    ? local
    : joined(local, " in series with a compliance times modulus of ", this->yielding, " per mm");
}

TiltWork pressedInto(const AxisymmetricTool& tool, const TiltBody& body, double depth)
{
  std::optional<LayerContact> layer;
  const IndentationLaw* local = &tool;
  if (body.hasLayer())
  {
    layer.emplace(tool, body.kernel, body.thickness);
    local = &*layer;
  }
  TiltWork result;
  double deepest = depth;
  if (body.yielding == 0.0)
  {
    const IndentationPoint at = local->evaluate(depth, 1.0);
    result = { at.force, at.stiffness, 0.0 };
  }
  else
  {
    const SeriesPoint at = seriesResponse(*local, 1.0, body.yielding, depth);
    result = { at.force, at.stiffness, 0.5 * body.yielding * at.force * at.force };
    deepest = at.localDeflection;
  }
  if (!std::isfinite(result.force))
  {
    const double none = std::nan("");
    return { none, none, none };
  }

  // Integrates from kink to kink. After a kink the force may start like any power of the depth.
  std::vector<double> radii = tool.kinks();
  if (std::isfinite(tool.largestContactRadius()))
  {
    radii.push_back(std::nextafter(tool.largestContactRadius(), 0.0));
  }
  double begin = 0.0;
  const auto addPanel = [&](double end)
  {
    result.work += workRule().integrate(0.0, 1.0,
      [&](double u)
      {
        const double width = end - begin;
        return local->evaluate(begin + width * u * u, 1.0).force * 2.0 * width * u;
      });
    begin = end;
  };
  for (const double radius : radii)
  {
    const double kink =
      layer ? layer->depthAtContactRadius(radius) : tool.depthAtContactRadius(radius);
    if (kink > begin && kink < deepest)
    {
      addPanel(kink);
    }
  }
  addPanel(deepest);
  return result;
}
} // namespace palpate
