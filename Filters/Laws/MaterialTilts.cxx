// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/MaterialTilts.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/SharedWork.h"
#include "Mechanics/Tilt/TiltNodes.h"
#include "Mechanics/Tilt/TiltedHalfSpace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
/// A parameter that varies from point to point, with evenly spaced nodes.
struct Axis
{
  double first = 0.0;
  double last = 0.0;
  int nodes = 1;

  Axis() = default;
  /// Spaces the nodes evenly from `from` to `to`, at most `spacing` apart.
  Axis(double from, double to, double spacing)
    : first(from)
    , last(to)
    , nodes(1 + static_cast<int>(std::ceil((to - from) / spacing - 1e-9)))
  {
  }

  double at(int node) const
  {
    return this->nodes < 2 ? this->first
                           : this->first + (this->last - this->first) * node / (this->nodes - 1);
  }
  /// Returns the weight of a node at a value of the parameter. Beyond an end of the axis, the
  /// weight is that at the end.
  double weightOf(int node, double place) const
  {
    if (this->nodes < 2)
    {
      return 1.0;
    }
    const double position =
      std::clamp((place - this->first) / (this->last - this->first), 0.0, 1.0) * (this->nodes - 1);
    return std::max(0.0, 1.0 - std::abs(position - node));
  }
};

/// The grid of parameters. Each grid node has one law of the tool.
class TiltGrid
{
public:
  TiltGrid(const TiltedHalfSpace& tool, double range, const MaterialRange& bounds)
    : Bounds(bounds)
    , Radius(tool.tool().contactRadius(range))
  {
    // The error of linear interpolation is an eighth of the squared spacing times the second
    // derivative. With these spacings the error is at most 1 % of the force on layers and in
    // series.
    constexpr double Thickness = 0.1;
    constexpr double Ratio = 0.05;
    constexpr double Yielding = 0.15;
    if (bounds.hasStack() && bounds.second.thickest > 0.0)
    {
      this->Axes[2] = Axis(this->thicknessPlace(bounds.second.thickest),
        this->thicknessPlace(bounds.second.thinnest), Thickness);
    }
    if (bounds.hasLayers())
    {
      const std::vector<double>& ratios = bounds.layers.poissonRatios;
      if (!bounds.hasStack())
      {
        this->Axes[1] = Axis(ratios.front(), ratios.back(), Ratio);
      }
      this->findThinnest(tool, range);
      this->Axes[0] = Axis(bounds.hasHalfSpace ? 0.0 : this->thicknessPlace(bounds.layers.thickest),
        this->thicknessPlace(std::max(this->Thinnest, bounds.layers.thinnest)), Thickness);
    }
    double least = Infinity;
    double most = -Infinity;
    for (const ContactSpot& spot : bounds.extremes)
    {
      least = std::min(least, this->yieldingPlace(spot));
      most = std::max(most, this->yieldingPlace(spot));
    }
    if (most >= least)
    {
      this->Axes[3] = Axis(least, most, Yielding);
    }
    this->limitLaws();
  }

  double thinnest() const { return this->Thinnest; }
  /// Returns whether all layers are too thin for a law.
  bool isTooThin() const
  {
    return this->Bounds.hasLayers() && this->Thinnest > this->Bounds.layers.thickest &&
      !this->Bounds.hasHalfSpace;
  }

  std::size_t laws() const
  {
    std::size_t count = 1;
    for (const Axis& axis : this->Axes)
    {
      count *= static_cast<std::size_t>(axis.nodes);
    }
    return count;
  }

  std::vector<TiltBody> bodies() const
  {
    std::vector<TiltBody> made(this->laws());
    std::vector<std::shared_ptr<const LayerKernel>> kernels(this->laws());
    shareWork(this->laws(),
      [&](std::size_t law)
      {
        const std::array<int, 4> node = this->nodeOf(law);
        const double place = this->Axes[0].at(node[0]);
        // A kernel is valid for one Poisson's ratio or one stack. All laws with the same Poisson's
        // ratio or stack share the kernel, including the laws in series with a compliance.
        made[law].thickness = place > 0.0 ? this->thicknessAt(place) : 0.0;
        const double yielding = this->Axes[3].at(node[3]);
        made[law].yielding = yielding / ((1.0 - yielding) * 2.0 * this->Radius);
        if (this->Bounds.hasLayers() && made[law].thickness > 0.0 && node[3] == 0 &&
          (this->Bounds.hasStack() || node[0] == this->firstLayer()))
        {
          kernels[law] = this->kernelOf(made[law].thickness, node);
        }
      });
    for (std::size_t law = 0; law < made.size(); ++law)
    {
      if (this->Bounds.hasLayers() && made[law].thickness > 0.0)
      {
        std::array<int, 4> node = this->nodeOf(law);
        node[3] = 0;
        node[0] = this->Bounds.hasStack() ? node[0] : this->firstLayer();
        made[law].kernel = kernels[this->lawOf(node)];
      }
    }
    return made;
  }

  void addWeights(const ContactSpot& spot, float* weights) const
  {
    const std::array<double, 4> places = {
      spot.thickness > 0.0 ? this->thicknessPlace(spot.thickness) : 0.0, spot.poissonRatio,
      this->thicknessPlace(spot.second), this->yieldingPlace(spot)
    };
    for (std::size_t law = 0; law < this->laws(); ++law)
    {
      const std::array<int, 4> node = this->nodeOf(law);
      double weight = 1.0;
      for (std::size_t axis = 0; axis < places.size(); ++axis)
      {
        weight *= this->Axes[axis].weightOf(node[axis], places[axis]);
      }
      weights[law] = static_cast<float>(weight);
    }
  }

private:
  double thicknessPlace(double thickness) const
  {
    return std::isinf(thickness) ? 0.0 : this->Radius / (this->Radius + thickness);
  }
  double thicknessAt(double place) const { return this->Radius * (1.0 / place - 1.0); }
  double yieldingPlace(const ContactSpot& spot) const
  {
    // If the compliance is so negative that the curve folds, the point has no response and needs no
    // tilt factor.
    constexpr double Stiffest = -0.4;
    const double yielding =
      std::max(Stiffest, spot.compliance * spot.reducedModulus * 2.0 * this->Radius);
    return yielding / (1.0 + yielding);
  }
  /// Returns the index of the first node that is a layer instead of a half-space.
  int firstLayer() const { return this->Axes[0].at(0) > 0.0 ? 0 : 1; }

  std::array<int, 4> nodeOf(std::size_t law) const
  {
    std::array<int, 4> node{};
    for (std::size_t axis = 0; axis < node.size(); ++axis)
    {
      const auto nodes = static_cast<std::size_t>(this->Axes[axis].nodes);
      node[axis] = static_cast<int>(law % nodes);
      law /= nodes;
    }
    return node;
  }
  std::size_t lawOf(const std::array<int, 4>& node) const
  {
    std::size_t law = 0;
    for (std::size_t axis = node.size(); axis-- > 0;)
    {
      law = law * static_cast<std::size_t>(this->Axes[axis].nodes) +
        static_cast<std::size_t>(node[axis]);
    }
    return law;
  }

  std::shared_ptr<const LayerKernel> kernelOf(
    double thickness, const std::array<int, 4>& node) const
  {
    if (!this->Bounds.hasStack())
    {
      return LayerKernel::shared(this->Axes[1].at(node[1]), this->Bounds.layers.base);
    }
    LayerStack stack = this->Bounds.stack;
    stack.layers[0].thickness = thickness;
    if (stack.layers.size() > 1 && this->Bounds.second.thickest > 0.0)
    {
      stack.layers[1].thickness = this->thicknessAt(this->Axes[2].at(node[2]));
    }
    return std::make_shared<const LayerKernel>(stack);
  }

  /// Removes nodes from the axis with the smallest spacing until the table has room for all laws.
  void limitLaws()
  {
    const std::array<Axis, 4> wanted = this->Axes;
    while (this->laws() > TiltTerms::MostLaws)
    {
      std::size_t densest = 0;
      double most = 0.0;
      for (std::size_t axis = 0; axis < this->Axes.size(); ++axis)
      {
        const double density = this->Axes[axis].nodes < 3
          ? 0.0
          : (this->Axes[axis].nodes - 1.0) / (wanted[axis].nodes - 1.0);
        densest = density > most ? axis : densest;
        most = std::max(most, density);
      }
      // The loop ends, because four axes of two nodes each have only sixteen laws.
      --this->Axes[densest].nodes;
    }
  }

  /// Finds the thinnest layer that has a law down to the range, both upright and at the largest
  /// tilt.
  void findThinnest(const TiltedHalfSpace& tool, double range)
  {
    // The contact is widest in the least compressible material.
    const std::array<int, 4> first{ 0, this->Axes[1].nodes - 1, 0, 0 };
    double answered = this->Bounds.layers.thinnest;
    std::shared_ptr<const LayerKernel> kernel = this->kernelOf(answered, first);
    for (const double angle : { 0.0, tool.drop().largest() })
    {
      const auto tilted = tool.equivalent(angle);
      const auto answers = [&](double thickness)
      {
        const auto own = this->Bounds.hasStack() ? this->kernelOf(thickness, first) : kernel;
        return LayerContact(*tilted, own, thickness).deepest() >= range;
      };
      constexpr double Thicker = 1.1;
      constexpr int MostSteps = 300; // enough for a thickness ratio of 1e12
      for (int step = 0; step < MostSteps && !answers(answered); ++step)
      {
        answered *= Thicker;
      }
    }
    this->Thinnest = answered;
  }

  const MaterialRange& Bounds;
  double Radius;
  double Thinnest = 0.0;
  std::array<Axis, 4> Axes; ///< thickness, Poisson's ratio, second thickness, yielding
};
} // namespace

MaterialTilts tiltsOf(const AxisymmetricTool& tool, double range, double largest,
  const MaterialRange& bounds, const ContactSpots& spots, std::size_t points)
{
  MaterialTilts result;
  result.fault = checkTiltDemand(tool, range, largest);
  if (!result.fault.empty())
  {
    return result;
  }
  const TiltedHalfSpace halfSpace(
    tool, depthToSolve(tool, range, bounds.hasLayers() || bounds.stiffens), largest);
  const TiltGrid grid(halfSpace, range, bounds);
  result.thinnest = grid.thinnest();
  if (grid.isTooThin())
  {
    result.fault = joined("a tool tilted by ", largest * 180.0 / Pi, " degrees and pressed ", range,
      " mm deep needs a layer of ", grid.thinnest(), " mm, but the thickest is ",
      bounds.layers.thickest, " mm");
    return result;
  }
  MadeTilt made = makeTiltTable(halfSpace, range, grid.bodies());
  result.fault = std::move(made.fault);
  result.error = made.error;
  if (!result.fault.empty())
  {
    return result;
  }
  result.table = std::move(made.table);
  if (grid.laws() > 1)
  {
    result.weights.resize(points * grid.laws());
    for (std::size_t point = 0; point < points; ++point)
    {
      grid.addWeights(spots.at(point), result.weights.data() + point * grid.laws());
    }
  }
  return result;
}
} // namespace palpate
