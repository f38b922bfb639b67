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
/// Of the deepest, where it is solved.
constexpr std::array<double, 6> Fractions = { 0.08, 0.2, 0.38, 0.58, 0.79, 1.0 };
/// Of the last penetration, by which the tool goes farther: it grows until the next.
constexpr double MakeUp = 1.6;
constexpr int MostMadeUp = 4;
/// Contact radii that it may touch before it comes to the place: beyond, nearly all of a ball would
/// be in the hollow, and what else is over the place touches it too.
constexpr double LongestWay = 3.0;
/// At once, of the deepest and of the way to the place.
constexpr double LongestStep = 0.3;
constexpr double LongestShare = 0.2;
constexpr int MostFailed = 4;      ///< steps in depth that are then halved
constexpr int MostIterations = 40; ///< of Newton's method
constexpr int MostHalvings = 8;    ///< of one of its steps
/// By what share of its stiffness at rest a tangent is made stiffer that is not positive.
constexpr std::array<double, 5> Stiffened = { 0.0, 0.05, 0.3, 2.0, 10.0 };
/// Relative to the energy, what an iteration gains that needs no other: the next gains some square
/// of it.
constexpr double Converged = 1e-7;
constexpr double Fillet = 0.05;        ///< of the contact radius, at a tool's apex
constexpr double ReachOfOutline = 3.0; ///< contact radii

/// Of a force, by the square of the angle that a place turns with what is around it.
constexpr double LeftOfTurning = 2.5;

/// Newton's method on the potential at successive depths.
class FinitePress
{
public:
  /// From where the tool touches on.
  explicit FinitePress(FinitePart& part)
    : Part(part)
    , Factor(StiffnessFactor::make(StiffnessFactor::Kind::Automatic))
    , Now(Eigen::VectorXd::Zero(part.unknowns()))
    , Motion(Now)
    , Depth(part.firstTouch())
  {
    this->IsReady = this->Factor->analyse(part.stiffness());
  }

  double depth() const { return this->Depth; }
  double deflection() const { return this->Depth - this->Contact.penetration; }
  const FinitePart::Pressed& pressed() const { return this->Contact; }

  /// Goes there from the last depth, in steps; false where it does not come so far.
  bool to(double depth, double longest)
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
  /// Where there is no equilibrium it stays.
  bool stepTo(double depth)
  {
    const Eigen::VectorXd before = this->Now;
    this->Now += (depth - this->Depth) * this->Motion;
    if (!this->IsReady || !this->solve(depth))
    {
      this->Now = before;
      return false;
    }
    this->Depth = depth;
    this->Contact = this->Part.pressed(this->Now, depth);
    if (!this->newton(this->Contact.gradient, this->Motion))
    {
      this->Motion.setZero();
    }
    return true;
  }

  /// A gradient, and less the inverse of the tangent times it; false where that is not positive.
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

  /// A step of Newton's method; where the tangent is not positive, of one that is stiffened by what
  /// it is at rest, with which the potential falls, too. How much of that; < 0: none was found.
  double step(double depth, Eigen::VectorXd& found)
  {
    const auto isFound = [&]() {
      return this->Factor->factorise(this->Part.stiffness()) && this->newton(this->Gradient, found);
    };
    this->Part.linearize(this->Now, depth, FinitePart::Bending::AsItDoes, this->Gradient);
    if (isFound())
    {
      return 0.0;
    }
    this->Part.linearize(this->Now, depth, FinitePart::Bending::LeftOut, this->Gradient);
    double stiffened = 0.0;
    for (const double more : Stiffened)
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
    double energy = this->Part.energy(this->Now, depth);
    for (int i = 0; i < MostIterations && std::isfinite(energy); ++i)
    {
      Eigen::VectorXd step;
      const double stiffened = this->step(depth, step);
      if (stiffened < 0.0)
      {
        return false;
      }
      const bool isLast = stiffened == 0.0 && -this->Gradient.dot(step) <= Converged * energy;
      double next = this->Part.energy(this->Now + step, depth);
      for (int k = 0; k < MostHalvings && !(next < energy); ++k)
      {
        step *= 0.5;
        next = this->Part.energy(this->Now + step, depth);
      }
      if (!(next < energy))
      {
        return isLast;
      }
      this->Now += step;
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
  Eigen::VectorXd Now;
  Eigen::VectorXd Motion; ///< by the depth
  Eigen::VectorXd Gradient;
  FinitePart::Pressed Contact;
  double Depth; ///< mm
  int Failed = 0;
};

/// One material in quadratic tetrahedra.
bool isKnown(const ElasticBody& body)
{
  const auto& elements = body.mesh().elements;
  return body.isUniform() &&
    std::all_of(elements.begin(), elements.end(),
      [](const VolumeElement& element)
      { return element.kind == ElementKind::QuadraticTetrahedron; });
}

/// Towards the surface a power, that with which the samples begin.
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
  if (!isKnown(body) || !isForFiniteStrain(tool) || !(deepest > 0.0))
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
  if (way > LongestWay * radius)
  {
    return {};
  }
  const double longest = LongestStep * deepest + LongestShare * way;
  std::vector<ContactSample> samples;
  for (const double fraction : Fractions)
  {
    // The penalty takes the more away the larger the force is.
    const double wanted = fraction * deepest;
    bool isThere = true;
    for (int i = 0; i < MostMadeUp && isThere && !(press.deflection() >= wanted); ++i)
    {
      isThere = press.to(wanted + MakeUp * press.pressed().penetration, longest);
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
      sample.strain = LeftOfTurning * pressed.turned * pressed.turned;
    }
  }
  return curveOf(samples);
}
} // namespace palpate
