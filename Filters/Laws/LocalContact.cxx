// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/LocalContact.h"

#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr int NodeCount = 64;
// Fewer nodes are used on layers, because each node is solved at every point. The error is 2e-5, 16
// times as large.
constexpr int LayerNodeCount = 32;
// In a hollow the contact is wider at the same depth. Therefore the tool's nodes extend to about
// twice the depth. This suffices if the sum of the curvatures is at least half the tool's
// curvature.
constexpr double HollowFactor = 2.1;
constexpr double NegativeComplianceFactor = 3.0;
// The contact radius of the sag must exceed that of the tool on any layer.
constexpr double SagFactor = 2.0;

std::vector<double> nodeDepths(double deepest, int count)
{
  std::vector<double> depths;
  depths.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i <= count; ++i)
  {
    const double root = static_cast<double>(i) / count;
    depths.push_back(deepest * root * root);
  }
  return depths;
}

double deepestOf(const AxisymmetricTool& tool, double range, bool deeper)
{
  return std::min(
    range * HollowFactor * (deeper ? NegativeComplianceFactor : 1.0), tool.depthLimit().depth);
}

ContactNodes nodesOf(const std::vector<double>& depths, const LayerCurves::Curve& curve)
{
  const auto column = [&curve](Eigen::Index i)
  { return std::vector<double>(curve.col(i).begin(), curve.col(i).end()); };
  return { depths, column(0), column(1), column(2), depths, true };
}
} // namespace

LocalContact::LocalContact(
  const AxisymmetricTool& tool, double range, bool deeper, const StrainCorrection* strain)
  : Tool(tool)
  , Range(range)
  , Strain(strain)
  , Direct(tool, deepestOf(tool, range, deeper))
{
  const double deepest = deepestOf(tool, range, deeper);
  for (const double depth : nodeDepths(deepest, NodeCount))
  {
    const IndentationPoint at = tool.evaluate(depth, 1.0);
    this->HalfSpace.add(depth, at.force, at.stiffness, at.contactRadius, depth);
  }
  const double a = this->HalfSpace.radii.back();
  this->SagCurvature = deepest / (a * a);
  this->Sag = makeTool({ ToolShape::Paraboloid, 1.0 / this->SagCurvature });
}

LocalContact::~LocalContact() = default;

void LocalContact::prepareLayers(const LayerTable::Layers& layers)
{
  const double deepest = this->HalfSpace.depths.back();
  this->Layers = makeLayerCurves(this->Tool, layers, nodeDepths(deepest, LayerNodeCount));
  this->SagLayers =
    makeLayerCurves(*this->Sag, layers, nodeDepths(SagFactor * deepest, LayerNodeCount));
}

bool LocalContact::answers(const ContactSpot& spot) const
{
  return !(spot.thickness > 0.0) ||
    (this->Layers->answers(spot.place()) &&
      (spot.curvature.isFlat() || this->SagLayers->answers(spot.place())));
}

ContactNodes LocalContact::flatNodes(const ContactSpot& spot) const
{
  return spot.thickness > 0.0 ? nodesOf(this->Layers->depths(), this->Layers->sample(spot.place()))
                              : this->HalfSpace;
}

ContactNodes LocalContact::curvedNodes(const ContactSpot& spot, const ContactNodes& flat) const
{
  SagLaw sag{ this->SagCurvature, {} };
  if (spot.thickness > 0.0)
  {
    sag.nodes = nodesOf(this->SagLayers->depths(), this->SagLayers->sample(spot.place()));
  }
  return onCurvedBody(flat, sag, spot.curvature);
}

NodeLaw LocalContact::law(const ContactSpot& spot, bool& fits) const
{
  const ContactNodes flat = this->flatNodes(spot);
  ContactNodes nodes = spot.curvature.isFlat() ? flat : this->curvedNodes(spot, flat);
  fits = nodes.size() > 0 && nodes.depths.back() >= this->Range;
  if (!fits)
  {
    nodes = flat;
  }
  if (this->Strain)
  {
    this->strain(spot, nodes);
  }
  return NodeLaw(std::move(nodes));
}

bool LocalContact::states(
  const ContactSpot& spot, const std::vector<double>& deflections, LocalState* states) const
{
  const double softness = spot.compliance * spot.reducedModulus;
  const bool fits = this->Direct.solve(spot.curvature, softness, deflections, states);
  if (!fits)
  {
    this->Direct.solve({}, softness, deflections, states);
  }
  const StrainCorrection::Course course =
    this->Strain ? this->Strain->course(spot.poissonRatio, 0.0) : StrainCorrection::Course();
  for (std::size_t i = 0; this->Strain && i < deflections.size(); ++i)
  {
    LocalState& state = states[i];
    const StrainCorrection::Value value = course.at(state.toolDepth);
    if (std::isfinite(value.factor))
    {
      state.stiffness = value.factor * state.stiffness + state.force * value.slope * state.toolTurn;
      state.force *= value.factor;
    }
  }
  return fits;
}

void LocalContact::strain(const ContactSpot& spot, ContactNodes& nodes) const
{
  const std::vector<double>& toolDepth = nodes.toolDepths;
  const StrainCorrection::Course course =
    this->Strain->course(spot.poissonRatio, spot.thickness, spot.second);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const std::size_t next = std::min(i + 1, nodes.size() - 1);
    const std::size_t last = i == 0 ? 0 : i - 1;
    const double turn = i == 0
      ? toolDepth[0] / nodes.depths[0]
      : (toolDepth[next] - toolDepth[last]) / (nodes.depths[next] - nodes.depths[last]);
    const StrainCorrection::Value value = course.at(toolDepth[i]);
    if (!std::isfinite(value.factor))
    {
      continue;
    }
    nodes.stiffnesses[i] =
      value.factor * nodes.stiffnesses[i] + nodes.forces[i] * value.slope * turn;
    nodes.forces[i] *= value.factor;
  }
}
} // namespace palpate
