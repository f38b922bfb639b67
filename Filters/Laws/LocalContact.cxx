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
// A hollow body is reached later: twice as deep at half the tool's curvature.
constexpr double ForHollows = 2.1;
constexpr double ForNegativeCompliance = 3.0;
// The sag's contact radius is to pass the tool's on any layer.
constexpr double ForSag = 2.0;

std::vector<double> nodeDepths(double deepest)
{
  std::vector<double> depths;
  depths.reserve(NodeCount);
  for (int i = 1; i <= NodeCount; ++i)
  {
    const double root = static_cast<double>(i) / NodeCount;
    depths.push_back(deepest * root * root);
  }
  return depths;
}

ContactNodes nodesOf(const std::vector<double>& depths, const LayerCurves::Curve& curve)
{
  const auto column = [&curve](Eigen::Index i)
  { return std::vector<double>(curve.col(i).begin(), curve.col(i).end()); };
  return { depths, column(0), column(1), column(2) };
}
} // namespace

LocalContact::LocalContact(
  const AxisymmetricTool& tool, double range, bool deeper, const StrainCorrection* strain)
  : Tool(tool)
  , Range(range)
  , Strain(strain)
{
  const double deepest =
    std::min(range * ForHollows * (deeper ? ForNegativeCompliance : 1.0), tool.depthLimit().depth);
  for (const double depth : nodeDepths(deepest))
  {
    const IndentationPoint at = tool.evaluate(depth, 1.0);
    this->HalfSpace.add(depth, at.force, at.stiffness, at.contactRadius);
  }
  const double a = this->HalfSpace.radii.back();
  this->SagCurvature = deepest / (a * a);
  this->Sag = makeTool({ ToolShape::Paraboloid, 1.0 / this->SagCurvature });
}

LocalContact::~LocalContact() = default;

void LocalContact::prepareLayers(const LayerTable::Layers& layers)
{
  const std::vector<double>& depths = this->HalfSpace.depths;
  this->Layers = makeLayerCurves(this->Tool, layers, depths);
  this->SagLayers = makeLayerCurves(*this->Sag, layers, nodeDepths(ForSag * depths.back()));
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
  std::vector<double> toolCurvature;
  toolCurvature.reserve(flat.size());
  for (const double a : flat.radii)
  {
    toolCurvature.push_back(this->Tool.depthAtContactRadius(a) / (a * a));
  }
  SagLaw sag{ this->SagCurvature, {} };
  if (spot.thickness > 0.0)
  {
    sag.nodes = nodesOf(this->SagLayers->depths(), this->SagLayers->sample(spot.place()));
  }
  return onCurvedBody(flat, toolCurvature, sag, spot.curvature);
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

void LocalContact::strain(const ContactSpot& spot, ContactNodes& nodes) const
{
  const std::vector<double>& depths = nodes.toolDepths.empty() ? nodes.depths : nodes.toolDepths;
  const auto toolDepth = [&depths](std::size_t i) { return depths[i]; };
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const std::size_t next = std::min(i + 1, nodes.size() - 1);
    const std::size_t last = i == 0 ? 0 : i - 1;
    const double turn = i == 0
      ? toolDepth(0) / nodes.depths[0]
      : (toolDepth(next) - toolDepth(last)) / (nodes.depths[next] - nodes.depths[last]);
    const StrainCorrection::Value value =
      this->Strain->at(toolDepth(i), spot.poissonsRatio, spot.thickness);
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
