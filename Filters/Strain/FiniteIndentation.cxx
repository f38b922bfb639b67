// SPDX-License-Identifier: BSD-3-Clause
#include "Strain/FiniteIndentation.h"

#include "Strain/FiniteBody.h"
#include "Mechanics/JoinedText.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::VectorXd;

constexpr int MostIterations = 14;
constexpr int MostHalvings = 4; // largest number of halvings of a step of Newton's method
// Largest number of halvings of a depth increment before the solution ends.
constexpr int MostCuts = 7;
// Largest factor by which the depth increases per increment. It is a factor because the contact
// grows with the depth.
constexpr double LargestGrowth = 1.3;
// First depth increment from the undeformed body, as a fraction of the first depth.
constexpr double FirstFraction = 0.05;
// Largest energy gain of a further iteration, relative to the energy.
constexpr double Converged = 1e-12;

/// Solves the equilibrium of a body and a tool at successive depths with Newton's method.
class Press
{
public:
  Press(const ToolOutline& tool, const FiniteProblem& problem)
    : Body(tool, problem)
    , Now(VectorXd::Zero(this->Body.unknowns()))
    , Course{ this->Now, 0.0 }
  {
    this->Solver.analyzePattern(this->Body.pattern());
  }

  /// Moves from the last depth to `depth`. Returns false if no equilibrium is found.
  bool to(double depth, FinitePoint& point)
  {
    int iterations = 0;
    int cuts = 0;
    while (this->Depth < depth)
    {
      const double target =
        this->Depth > 0.0 ? std::min(depth, this->Growth * this->Depth) : FirstFraction * depth;
      const VectorXd before = this->Now;
      this->Now += (target - this->Depth) * this->Course.motion;
      if (this->solve(target, iterations))
      {
        this->Depth = target;
        this->Course = this->Body.course(this->Now, target, this->Solver);
      }
      else if (this->Now = before; ++cuts > MostCuts || !(this->Depth > 0.0))
      {
        return false;
      }
      else
      {
        // The smaller growth also applies to later steps.
        this->Growth = 1.0 + 0.5 * (this->Growth - 1.0);
      }
    }
    point = this->Body.evaluate(this->Now, depth);
    // To first order, the potential of a rigid contact is the potential with the penalty plus the
    // energy of the penalty. The force is the derivative of this sum.
    point.force += this->Course.penaltySlope;
    point.iterations = iterations;
    return true;
  }

private:
  bool solve(double depth, int& iterations)
  {
    double energy = this->Body.energy(this->Now, depth);
    this->Body.restart();
    if (!std::isfinite(energy))
    {
      return false;
    }
    for (int i = 0; i < MostIterations; ++i)
    {
      ++iterations;
      this->Body.linearize(this->Now, depth, this->Gradient);
      this->Solver.factorize(this->Body.pattern());
      if (this->Solver.info() != Eigen::Success)
      {
        return false;
      }
      const VectorXd step = -this->Solver.solve(this->Gradient);
      const double slope = this->Gradient.dot(step);
      // The step is no descent: the tangent is indefinite, or only rounding errors remain.
      if (!(slope < 0.0))
      {
        return std::abs(slope) <= Converged * energy;
      }
      if (-slope <= Converged * energy)
      {
        this->Now += step;
        return true;
      }
      double length = 1.0;
      double next = HUGE_VAL;
      for (int k = 0; k < MostHalvings && !std::isfinite(next); ++k)
      {
        length *= k > 0 ? 0.5 : 1.0;
        next = this->Body.energy(this->Now + length * step, depth);
      }
      if (!std::isfinite(next))
      {
        return false;
      }
      this->Now += length * step;
      this->Body.follow(length * step);
      energy = next;
    }
    return false;
  }

  FiniteBody Body;
  Eigen::SimplicialLDLT<FiniteBody::Matrix, Eigen::Lower> Solver;
  VectorXd Now;
  VectorXd Gradient;
  FiniteBody::Course Course;
  double Depth = 0.0;
  double Growth = LargestGrowth;
};
} // namespace

std::string checkProblem(const FiniteProblem& problem)
{
  if (problem.layers.empty())
  {
    return "The body has no layer";
  }
  for (std::size_t i = 0; i < problem.layers.size(); ++i)
  {
    const FiniteLayer& layer = problem.layers[i];
    const bool isLast = i + 1 == problem.layers.size();
    if (!(layer.thickness > 0.0) || (std::isinf(layer.thickness) && !isLast))
    {
      return joined("Layer ", i,
        ": its thickness must be positive (mm), and finite except for the ", "last, but is ",
        layer.thickness);
    }
    if (!(layer.youngsModulus > 0.0 && std::isfinite(layer.youngsModulus)))
    {
      return joined("Layer ", i, ": Young's modulus must be positive and finite (MPa), but is ",
        layer.youngsModulus);
    }
    if (!(layer.poissonRatio >= 0.0 && layer.poissonRatio <= FiniteLayer::LargestPoissonsRatio))
    {
      return joined("Layer ", i, ": Poisson's ratio must lie between 0 and ",
        FiniteLayer::LargestPoissonsRatio, ", but is ", layer.poissonRatio);
    }
    const std::string fault = checkStrainEnergy(layer.model, layer.parameter);
    if (!fault.empty())
    {
      return joined("Layer ", i, ": ", fault);
    }
  }
  if (!(problem.contactRadius > 0.0 && std::isfinite(problem.contactRadius)))
  {
    return joined(
      "The contact radius must be positive and finite (mm), but is ", problem.contactRadius);
  }
  const double least = 2.0 * problem.contactRadius;
  if (problem.bodyRadius != 0.0 && !(std::abs(problem.bodyRadius) >= least))
  {
    return joined("The body's radius must be 0 (flat), or at least two contact radii (", least,
      " mm), but is ", problem.bodyRadius);
  }
  if (!(problem.edge >= FiniteProblem::ShortestEdge && problem.edge <= FiniteProblem::LongestEdge))
  {
    return joined("The edge of the elements must lie between ", FiniteProblem::ShortestEdge,
      " and ", FiniteProblem::LongestEdge, " (of the contact radius), but is ", problem.edge);
  }
  double last = 0.0;
  for (const double depth : problem.depths)
  {
    if (!(depth > last && std::isfinite(depth)))
    {
      return joined("The depths must grow from above 0 (mm), but ", depth, " follows ", last);
    }
    last = depth;
  }
  return {};
}

FiniteCurve pressTool(
  const ToolOutline& tool, const FiniteProblem& problem, const std::function<bool(double)>& goOn)
{
  FiniteCurve curve;
  curve.fault = checkProblem(problem);
  if (!curve.fault.empty())
  {
    return curve;
  }
  Press press(tool, problem);
  for (const double depth : problem.depths)
  {
    FinitePoint point;
    if (!press.to(depth, point))
    {
      curve.fault = joined("No equilibrium was found at ", depth, " mm");
      return curve;
    }
    if (point.leastVolume <= 0.0)
    {
      curve.fault = joined("An element has turned inside out at ", depth, " mm");
      return curve;
    }
    curve.points.push_back(point);
    if (goOn && !goOn(depth / problem.depths.back()))
    {
      curve.fault = "Aborted";
      return curve;
    }
  }
  return curve;
}
} // namespace palpate
