// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/FiniteContact.h"

#include "Solids/TrueShape/FinitePart.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
/// Depths of the solution, as fractions of the largest depth.
constexpr std::array<double, 6> Fractions = { 0.08, 0.2, 0.38, 0.58, 0.79, 1.0 };
/// The depth is increased by this factor times the last penetration. The factor is above 1, because
/// the penetration grows until the next depth is reached.
constexpr double PenetrationFactor = 1.6;
constexpr int MostCorrections = 4;
/// Largest distance from the first touch to the point, in contact radii. With a larger distance,
/// nearly a whole ball would be inside the hollow, and parts of the body above the point would also
/// touch the tool.
constexpr double LongestApproach = 3.0;
/// Largest step, as a fraction of the largest depth and as a fraction of the distance to the point.
constexpr double LongestStep = 0.3;
constexpr double LongestApproachStep = 0.2;
/// Largest number of failed steps in depth; each failure halves the step.
constexpr int MostFailed = 4;
constexpr int MostIterations = 40; ///< largest number of iterations of Newton's method
constexpr int MostHalvings = 8;    ///< largest number of halvings of one Newton step
/// Fractions of the stiffness in the undeformed state. They are added one after the other to a
/// tangent that is not positive definite.
constexpr std::array<double, 5> AddedStiffness = { 0.0, 0.05, 0.3, 2.0, 10.0 };
/// The iteration ends when the relative decrease of the energy is below this value, because the
/// next decrease would be about the square of this value.
constexpr double LastDecrease = 1e-7;
constexpr double Fillet = 0.05; ///< radius of the fillet of the tool's apex, in contact radii
constexpr double ReachOfOutline = 3.0; ///< radius of the outline, in contact radii

/// Ratio of the relative error of the force to the square of the angle by which the motion of the
/// surrounding body rotates the place.
constexpr double RotationErrorFactor = 2.5;

/// Applies Newton's method to the potential at successive depths.
class FinitePress
{
public:
  /// Starts the solution at the depth of the first touch.
  explicit FinitePress(FinitePart& part)
    : Part(part)
    , Factor(StiffnessFactor::make(StiffnessFactor::Kind::Automatic))
    , Solution(Eigen::VectorXd::Zero(part.unknowns()))
    , Motion(Solution)
    , Depth(part.firstTouch())
  {
    this->IsReady = this->Factor->analyse(part.stiffness());
  }

  double depth() const { return this->Depth; }
  double deflection() const { return this->Depth - this->Contact.penetration; }
  const FinitePart::Pressed& pressed() const { return this->Contact; }

  /// Continues from the last depth to `depth` in steps of at most `longest`, mm. Returns false if
  /// `depth` is not reached.
  bool pressTo(double depth, double longest)
  {
    double step = longest;
    while (this->Depth < depth && this->Failed <= MostFailed)
    {
      if (!this->stepTo(std::min(this->Depth + step, depth)))
      {
        ++this->Failed;
        step *= 0.5;
      }
    }
    return this->Depth >= depth;
  }

private:
  /// Takes one step to `depth`. Restores the state and returns false if no equilibrium is found.
  bool stepTo(double depth)
  {
    const Eigen::VectorXd before = this->Solution;
    this->Solution += (depth - this->Depth) * this->Motion;
    if (!this->IsReady || !this->solve(depth))
    {
      this->Solution = before;
      return false;
    }
    this->Depth = depth;
    this->Contact = this->Part.pressed(this->Solution, depth);
    if (!this->newton(this->Contact.gradient, this->Motion))
    {
      this->Motion.setZero();
    }
    return true;
  }

  /// Computes the Newton step: minus the inverse of the tangent times the gradient. Returns false
  /// if the tangent is not positive definite.
  bool newton(const Eigen::VectorXd& gradient, Eigen::VectorXd& found) const
  {
    const Eigen::MatrixXd& border = this->Part.border();
    const Eigen::Index loads = border.cols();
    const Eigen::Index nodes = border.rows();
    Eigen::MatrixXd right(nodes, 1 + loads);
    right << -gradient.head(nodes), border;
    const Eigen::MatrixXd solved = this->Factor->solveAll(right);
    if (solved.size() == 0)
    {
      return false;
    }
    const Eigen::MatrixXd corner =
      this->Part.corner() - border.transpose() * solved.rightCols(loads);
    const Eigen::LLT<Eigen::MatrixXd> factor(corner);
    if (loads > 0 && factor.info() != Eigen::Success)
    {
      return false;
    }
    found.resize(nodes + loads);
    found.tail(loads) = factor.solve(-gradient.tail(loads) - border.transpose() * solved.col(0));
    found.head(nodes) = solved.col(0) - solved.rightCols(loads) * found.tail(loads);
    return true;
  }

  /// Finds one Newton step. If the tangent is not positive definite, a fraction of the tangent in
  /// the undeformed state is added, so that the potential decreases along the step. Returns this
  /// fraction; a value < 0 means that no step was found.
  double step(double depth, Eigen::VectorXd& found)
  {
    const auto isFound = [&]() {
      return this->Factor->factorise(this->Part.stiffness()) && this->newton(this->Gradient, found);
    };
    this->Part.linearize(
      this->Solution, depth, FinitePart::ToolCurvature::Included, this->Gradient);
    if (isFound())
    {
      return 0.0;
    }
    this->Part.linearize(this->Solution, depth, FinitePart::ToolCurvature::Omitted, this->Gradient);
    double stiffened = 0.0;
    for (const double more : AddedStiffness)
    {
      this->Part.stiffen(more - stiffened);
      stiffened = more;
      if (isFound())
      {
        return stiffened;
      }
    }
    return -1.0;
  }

  bool solve(double depth)
  {
    double energy = this->Part.energy(this->Solution, depth);
    for (int i = 0; i < MostIterations && std::isfinite(energy); ++i)
    {
      Eigen::VectorXd step;
      const double stiffened = this->step(depth, step);
      if (stiffened < 0.0)
      {
        return false;
      }
      const bool isLast = stiffened == 0.0 && -this->Gradient.dot(step) <= LastDecrease * energy;
      double next = this->Part.energy(this->Solution + step, depth);
      for (int k = 0; k < MostHalvings && !(next < energy); ++k)
      {
        step *= 0.5;
        next = this->Part.energy(this->Solution + step, depth);
      }
      if (!(next < energy))
      {
        return isLast;
      }
      this->Solution += step;
      if (isLast)
      {
        return true;
      }
      energy = next;
    }
    return false;
  }

  FinitePart& Part;
  std::unique_ptr<StiffnessFactor> Factor;
  bool IsReady = false;
  Eigen::VectorXd Solution;
  Eigen::VectorXd Motion; ///< change of the displacements per mm of depth
  Eigen::VectorXd Gradient;
  FinitePart::Pressed Contact;
  double Depth; ///< depth of the tool in the last equilibrium, mm
  int Failed = 0;
};

/// Returns whether the body has one material and consists of quadratic tetrahedra.
bool isSupported(const ElasticBody& body)
{
  const auto& elements = body.mesh().elements;
  return body.isUniform() &&
    std::all_of(elements.begin(), elements.end(),
      [](const VolumeElement& element)
      { return element.kind == ElementKind::QuadraticTetrahedron; });
}

/// Returns the curve. Below the first sample, it is a power of δ with the exponent at that sample.
ContactCurve curveOf(const std::vector<ContactSample>& samples)
{
  if (samples.empty())
  {
    return {};
  }
  const auto joined = [&](double exponent)
  { return ContactCurve(samples, exponent, false, 0.0, CurveEnd::Patch, 0.0); };
  const double first = samples.front().deflection;
  const IndentationPoint begins = joined(1.0).evaluate(first);
  return joined(begins.stiffness * first / begins.force);
}
} // namespace

ContactCurve pressAtFiniteStrain(const ElasticBody& body, const AxisymmetricTool& tool,
  const DirectPlace& at, double deepest, const UnitMotion* rest)
{
  if (!isSupported(body) || !isForFiniteStrain(tool) || !(deepest > 0.0))
  {
    return {};
  }
  const double radius = tool.contactRadius(deepest);
  const ToolOutline outline(tool, ReachOfOutline * radius, Fillet * radius);
  FinitePart part(body, tool, outline, at, deepest, rest);
  if (!part.isTouched())
  {
    return {};
  }
  FinitePress press(part);
  const double way = -press.depth();
  if (way > LongestApproach * radius)
  {
    return {};
  }
  const double longest = LongestStep * deepest + LongestApproachStep * way;
  std::vector<ContactSample> samples;
  for (const double fraction : Fractions)
  {
    // Because of the penalty, the deflection is smaller than the depth. The difference grows with
    // the force.
    const double wanted = fraction * deepest;
    bool isThere = true;
    for (int i = 0; i < MostCorrections && isThere && !(press.deflection() >= wanted); ++i)
    {
      isThere = press.pressTo(wanted + PenetrationFactor * press.pressed().penetration, longest);
    }
    const FinitePart::Pressed& pressed = press.pressed();
    if (!isThere || (!samples.empty() && !(pressed.force > samples.back().force)))
    {
      break;
    }
    if (pressed.force > 0.0)
    {
      ContactSample& sample = samples.emplace_back();
      sample.radius = pressed.radius;
      sample.deflection = press.deflection();
      sample.force = pressed.force;
      sample.strain = RotationErrorFactor * pressed.turned * pressed.turned;
    }
  }
  return curveOf(samples);
}
} // namespace palpate
