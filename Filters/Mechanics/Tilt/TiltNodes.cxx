// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltNodes.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/SharedWork.h"
#include "Mechanics/Tilt/TiltError.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltedFlat.h"
#include "Mechanics/Tilt/TiltedHalfSpace.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr int Depths = 9;
constexpr int Angles = 13;
constexpr double AngleStep = 0.01;     // step in y for finite differences
constexpr double LeastFraction = 0.25; // fraction of the first x > 0, used instead of x = 0
// The half-space is solved to this multiple of the range, because the spline is inaccurate at the
// end, and because the contact on a layer corresponds to a larger depth on a half-space.
constexpr double HalfSpaceFactor = 1.6;
constexpr double LayerFactor = 4.0;

/// η and its derivatives with respect to x, to y, and to both.
using Node = std::array<double, 4>;

/// The ratio of two works, and its derivative with respect to the depth.
struct Ratio
{
  double value = 1.0;
  double byDepth = 0.0;
};

Ratio over(const TiltWork& one, const TiltWork& other)
{
  const double value = one.work / other.work;
  return { value, (one.force - value * other.force) / other.work };
}

/// Computes the nodes of one tool.
class NodesOfTool
{
public:
  NodesOfTool(const AxisymmetricTool& tool, double range, double largest,
    const std::vector<TiltBody>& bodies, const TiltedHalfSpace& halfSpace)
    : Tool(tool)
    , Range(range)
    , Largest(largest)
    , Bodies(bodies)
    , HalfSpace(halfSpace)
    , Uprights(Depths)
  {
    shareWork(this->Uprights.size(),
      [this](std::size_t depth)
      {
        for (const TiltBody& body : this->Bodies)
        {
          this->Uprights[depth].push_back(
            pressedInto(this->Tool, body, this->depthAt(static_cast<int>(depth))));
        }
      });
  }

  /// Returns the nodes of all bodies at one depth and angle.
  std::vector<Node> at(int depth, int angle) const
  {
    std::vector<Node> nodes = angle > 0
      ? this->tilted(depth, static_cast<double>(angle) / (Angles - 1))
      : this->upright(depth);
    if (depth == 0)
    {
      const double beside = placeAt(0);
      for (Node& node : nodes)
      {
        node[0] -= beside * node[1];
        node[2] -= beside * node[3];
      }
    }
    return nodes;
  }

private:
  /// Returns x of a node. At x = 0 there is no contact. Therefore a small x is used instead, and
  /// at() extrapolates to 0.
  static double placeAt(int depth)
  {
    return (depth > 0 ? static_cast<double>(depth) : LeastFraction) / (Depths - 1);
  }
  double depthAt(int depth) const { return this->Range * placeAt(depth) * placeAt(depth); }

  /// Returns the nodes at θ = 0, where η = 1. At a fixed depth of the tip W is even in θ, and
  /// therefore M = 0. This gives F dh/dθ + W_0 (ρ_θ + η_θ) = 0 with ρ_θ = -2κ/3D dh/dθ.
  std::vector<Node> upright(int node) const
  {
    const double scale = this->HalfSpace.dropScale();
    const double depth = this->depthAt(node);
    const double offset = this->HalfSpace.drop().at(0.0).offset;
    std::vector<Node> nodes;
    for (const TiltWork& at : this->Uprights[static_cast<std::size_t>(node)])
    {
      Node made{ 1.0, 0.0, 0.0, 0.0 };
      if (scale > 0.0)
      {
        const double rise = at.force / at.work;
        const double riseByDepth = at.stiffness / at.work - rise * rise;
        const double rim = 2.0 * scale / 3.0 / depth;
        made[2] = this->Largest * offset * (rim - rise);
        made[3] =
          this->Largest * offset * (-rim / depth - riseByDepth) * 2.0 * this->Range * placeAt(node);
      }
      nodes.push_back(made);
    }
    return nodes;
  }

  /// Returns the nodes at a tilt > 0. The derivatives with respect to y are finite differences;
  /// those with respect to x follow from F = dW/dD.
  std::vector<Node> tilted(int node, double y) const
  {
    const double depth = this->depthAt(node);
    const double depthByX = 2.0 * this->Range * placeAt(node);
    std::array<std::shared_ptr<const AxisymmetricTool>, 3> tools;
    std::array<Ratio, 3> rim{}; // ρ at the three positions
    // Work on the half-space divided by the work of the equivalent profile.
    std::array<Ratio, 3> missed{};
    // The differences use y and one position on each side. At the largest tilt they use y and two
    // smaller positions.
    const bool isLast = y + AngleStep > 1.0;
    const std::array<double, 3> steps = { 0.0, isLast ? 2.0 : -1.0, 1.0 };
    const std::array<double, 3> slope = { isLast ? 3.0 : 0.0, 1.0, isLast ? -4.0 : -1.0 };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double angle = this->Largest * (y - AngleStep * steps[i]);
      tools[i] = this->HalfSpace.equivalent(angle);
      if (this->HalfSpace.dropScale() > 0.0)
      {
        const double ratio =
          this->HalfSpace.dropScale() * this->HalfSpace.drop().at(angle).drop / depth;
        const TiltedFlatTerm rho = tiltedFlatWork(ratio);
        rim[i] = { rho.value, -rho.slope * ratio / depth };
      }
      missed[i] =
        over(this->HalfSpace.pressed(depth, angle), pressedInto(*tools[i], TiltBody(), depth));
    }
    std::vector<Node> nodes;
    for (std::size_t body = 0; body < this->Bodies.size(); ++body)
    {
      const TiltWork& upright = this->Uprights[static_cast<std::size_t>(node)][body];
      std::array<double, 3> eta{};
      std::array<double, 3> byX{};
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Ratio tau = over(pressedInto(*tools[i], this->Bodies[body], depth), upright);
        eta[i] = tau.value * missed[i].value / rim[i].value;
        byX[i] = eta[i] * depthByX *
          (tau.byDepth / tau.value + missed[i].byDepth / missed[i].value -
            rim[i].byDepth / rim[i].value);
      }
      const auto byY = [&slope](const std::array<double, 3>& values)
      {
        return (slope[0] * values[0] + slope[1] * values[1] + slope[2] * values[2]) /
          (2.0 * AngleStep);
      };
      nodes.push_back({ eta[0], byX[0], byY(eta), byY(byX) });
    }
    return nodes;
  }

  const AxisymmetricTool& Tool;
  double Range;
  double Largest;
  const std::vector<TiltBody>& Bodies;
  const TiltedHalfSpace& HalfSpace;
  /// Results of the upright tool for each depth and each body.
  std::vector<std::vector<TiltWork>> Uprights;
};

std::string countFault(const std::vector<TiltBody>& bodies)
{
  return !bodies.empty() && bodies.size() <= TiltTerms::MostLaws
    ? ""
    : joined("the number of laws must be 1 to ", TiltTerms::MostLaws, ", but is ", bodies.size());
}

/// Returns the reason why a tool cannot be pressed to the depth `range` (mm) into a body, upright
/// and at the largest tilt;
/// "" if it can be pressed.
std::string faultOf(const AxisymmetricTool& tool, const TiltedHalfSpace& halfSpace, double range,
  double largest, const TiltBody& body)
{
  for (const double angle : { 0.0, largest })
  {
    const auto tilted = halfSpace.equivalent(angle);
    const auto answers = [&](double depth)
    { return std::isfinite(pressedInto(*tilted, body, depth).work); };
    if (answers(range))
    {
      continue;
    }
    double answered = 0.0;
    double unanswered = range;
    for (int i = 0; i < 30; ++i)
    {
      const double middle = 0.5 * (answered + unanswered);
      (answers(middle) ? answered : unanswered) = middle;
    }
    constexpr double Degrees = 57.29577951308232;
    return joined("on ", body.describe(), " the tool's law is valid only to ", answered, " mm",
      angle > 0.0 ? joined(" when it is tilted by ", angle * Degrees, " degrees") : std::string(),
      ", not to the range of ", range, " mm");
  }
  return tool.checkDepth(range);
}

/// Returns the largest tiltError() over the depths of the nodes, at the largest tilt and at half of
/// it.
double largestError(const AxisymmetricTool& tool, const TiltedHalfSpace& halfSpace, double range,
  double largest, const std::vector<TiltBody>& bodies)
{
  double error = 0.0;
  for (int i = 1; i < Depths; ++i)
  {
    const double x = static_cast<double>(i) / (Depths - 1);
    const double depth = range * x * x;
    for (const double angle : { 0.5 * largest, largest })
    {
      const auto tilted = halfSpace.equivalent(angle);
      const double rim = halfSpace.dropScale() * halfSpace.drop().at(angle).drop / depth;
      for (const TiltBody& body : bodies)
      {
        if (body.hasLayer())
        {
          const double stretch =
            pressedInto(*tilted, body, depth).force / pressedInto(tool, body, depth).force;
          error = std::max(
            error, tiltError({ tool.contactRadius(depth) / body.thickness, stretch, rim }));
        }
      }
    }
  }
  return error;
}
} // namespace

std::string checkTiltDemand(const AxisymmetricTool& tool, double range, double largest)
{
  if (!(range > 0.0 && std::isfinite(range)))
  {
    return joined("the range of tilts must be positive and finite (mm), but is ", range);
  }
  return firstFault(
    [&] { return checkTilt(tool, largest); }, [&] { return tool.checkDepth(range); });
}

double depthToSolve(const AxisymmetricTool& tool, double range, bool isLayered)
{
  return std::min((isLayered ? LayerFactor : HalfSpaceFactor) * range, tool.depthLimit().depth);
}

MadeTilt makeTiltTable(
  const AxisymmetricTool& tool, double range, double largest, const std::vector<TiltBody>& bodies)
{
  for (const std::string& fault : { countFault(bodies), checkTiltDemand(tool, range, largest) })
  {
    if (!fault.empty())
    {
      return { {}, fault, 0.0 };
    }
  }
  const bool isLayered = std::any_of(bodies.begin(), bodies.end(),
    [](const TiltBody& body) { return body.hasLayer() || body.yielding < 0.0; });
  return makeTiltTable(
    TiltedHalfSpace(tool, depthToSolve(tool, range, isLayered), largest), range, bodies);
}

MadeTilt makeTiltTable(
  const TiltedHalfSpace& halfSpace, double range, const std::vector<TiltBody>& bodies)
{
  const std::string fault = countFault(bodies);
  if (!fault.empty())
  {
    return { {}, fault, 0.0 };
  }
  const AxisymmetricTool& tool = halfSpace.tool();
  const double largest = halfSpace.drop().largest();
  for (const TiltBody& body : bodies)
  {
    const std::string tooDeep = faultOf(tool, halfSpace, range, largest, body);
    if (!tooDeep.empty())
    {
      return { {}, tooDeep, 0.0 };
    }
  }

  TiltTerms terms;
  terms.range = range;
  terms.largest = largest;
  terms.dropScale = halfSpace.dropScale();
  terms.depths = Depths;
  terms.angles = Angles;
  terms.drops = ToolDrop::Angles;
  terms.laws = static_cast<int>(bodies.size());
  std::vector<double> nodes(TiltTable::nodeCount(terms));
  const NodesOfTool made(tool, range, largest, bodies, halfSpace);
  shareWork(static_cast<std::size_t>(Depths) * Angles,
    [&](std::size_t place)
    {
      const std::vector<Node> of =
        made.at(static_cast<int>(place / Angles), static_cast<int>(place % Angles));
      for (std::size_t law = 0; law < of.size(); ++law)
      {
        std::copy(of[law].begin(), of[law].end(),
          nodes.begin() +
            static_cast<std::ptrdiff_t>(
              4 * (place + law * static_cast<std::size_t>(Depths) * Angles)));
      }
    });
  const std::vector<double>& drops = halfSpace.drop().nodes();
  const std::string wrong = TiltTable::faultOf(terms, drops.data(), nodes.data());
  return wrong.empty() ? MadeTilt{ TiltTable(terms, drops.data(), nodes.data()), "",
    largestError(tool, halfSpace, range, largest, bodies) }
                       : MadeTilt{ {}, wrong, 0.0 };
}
} // namespace palpate
