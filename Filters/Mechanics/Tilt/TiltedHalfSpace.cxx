// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltedHalfSpace.h"

#include "Mechanics/Numerics/IsotonicRegression.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/SharedWork.h"
#include "Mechanics/Tilt/TiltBody.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltedContact.h"
#include "Mechanics/Tilt/TiltedFlat.h"
#include "Mechanics/Tilt/TiltedTool.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
// Ratio of the largest to the smallest depth at which the tool is solved.
constexpr double Shallowest = 256.0;
constexpr int RowCells = 13; // number of intervals, about two per factor of e in the depth
constexpr int AngleCells = 11;
constexpr double Power = -1.2; // exponent of τ that makes it nearly linear in sin² θ
constexpr int SamplesPerRow = 4;
// Number of samples over the solved depths, plus two more.
constexpr std::size_t OfRows = SamplesPerRow * RowCells + 2;
// Samples at small tilts, down to 1e-7 of the smallest depth.
constexpr std::size_t MostSamples = 200;
// Lower bound of contact radius divided by depth, for results of the solver.
constexpr double Smallest = 1e-9;

/// Makes the contact radii increase with the depth. Radii that decrease because of the solver's
/// error are replaced by their mean over the depth, which preserves the force.
void makeMonotone(std::vector<TiltedTool::Sample>& samples)
{
  std::vector<double> radii;
  std::vector<double> depths;
  for (const TiltedTool::Sample& sample : samples)
  {
    radii.push_back(sample.radius);
    depths.push_back(sample.depth);
  }
  radii = isotonicRegression(radii, depths);
  constexpr double Growth = 1e-9; // makes the radii distinct, so that each radius has one depth
  for (std::size_t i = 0, same = 0; i < samples.size(); ++i)
  {
    same = i > 0 && radii[i] == radii[i - 1] ? same + 1 : 0;
    samples[i].radius = radii[i] * (1.0 + Growth * static_cast<double>(same));
  }
}

/// Computes d ln a/d ln D by central differences.
void setExponents(std::vector<TiltedTool::Sample>& samples)
{
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const TiltedTool::Sample& before = samples[i > 0 ? i - 1 : i];
    const TiltedTool::Sample& after = samples[i + 1 < samples.size() ? i + 1 : i];
    samples[i].exponent =
      std::log(after.radius / before.radius) / std::log(after.depth / before.depth);
  }
}

/// Returns whether only the spherical tip of a blunted cone touches. In this case τ = 1 at any
/// tilt.
bool touchesWithTipOnly(const std::optional<ToolSpecification>& tool, double radius, double angle)
{
  return tool && tool->Shape == ToolShape::BluntedCone && radius < tool->Radius &&
    angle + std::asin(radius / tool->Radius) <= (90.0 - tool->HalfAngle) * Pi / 180.0;
}
} // namespace

TiltedHalfSpace::TiltedHalfSpace(const AxisymmetricTool& tool, double depth, double largest)
  : Tool(tool)
  , Drop(tool, largest)
  , DropScale(dropScaleOf(tool))
{
  const std::optional<ToolSpecification> specification = knownSpecification(tool);
  if (specification)
  {
    const ToolShape shape = specification->Shape;
    this->Is = shape == ToolShape::Sphere ? Kind::Sphere
      : shape == ToolShape::Flat          ? Kind::Flat
      : shape == ToolShape::Cone || (shape == ToolShape::PowerLaw && specification->Exponent == 1.0)
      ? Kind::ScaleFree
      : Kind::Solved;
  }
  this->IsFaceted =
    !(this->DropScale > 0.0) && (!specification || specification->Shape == ToolShape::Profile);
  if (this->Is == Kind::ScaleFree || this->Is == Kind::Solved)
  {
    this->solveRows(depth);
  }
}

/// Returns s of tiltedFlatWork; 0 for a tool without a flat end.
double TiltedHalfSpace::rimRatio(double depth, double angle) const
{
  return this->DropScale > 0.0 ? this->DropScale * this->Drop.at(angle).drop / depth : 0.0;
}

void TiltedHalfSpace::solveRows(double depth)
{
  const int steps = this->Is == Kind::ScaleFree ? 0 : RowCells;
  const auto rows = static_cast<std::size_t>(steps) + 1;
  const std::size_t columns = AngleCells + 1;
  std::vector<double> depths(rows);
  std::vector<double> angles(columns);
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto shallower = static_cast<double>(rows - 1 - row);
    depths[row] = depth * std::exp(-shallower * std::log(Shallowest) / std::max(1, steps));
  }
  for (std::size_t column = 0; column < columns; ++column)
  {
    angles[column] = this->Drop.largest() * static_cast<double>(column) / AngleCells;
  }
  const std::optional<ToolSpecification> specification = knownSpecification(this->Tool);
  std::vector<TiltedForce> solved(rows * columns);
  shareWork(rows * columns,
    [&](std::size_t i)
    {
      const double at = depths[i / columns];
      const double angle = angles[i % columns];
      if (i % columns == 0 ||
        !touchesWithTipOnly(specification, this->Tool.contactRadius(at), angle))
      {
        solved[i] = solveTilted(this->Tool, angle, at);
      }
    });
  for (std::size_t row = 0; row < rows; ++row)
  {
    const double at = depths[row];
    std::vector<double> works;
    for (std::size_t column = 0; column < columns; ++column)
    {
      // The work is divided by the work of the upright tool on the same grid. This cancels most of
      // the error of the grid.
      const TiltedForce& tilted = solved[row * columns + column];
      const double tau = tilted.work > 0.0 ? tilted.work / solved[row * columns].work : 1.0;
      works.push_back(this->DropScale > 0.0
          ? tau / tiltedFlatWork(this->rimRatio(at, angles[column])).value
          : this->IsFaceted ? std::log(tau)
                            : std::pow(tau, Power));
    }
    std::optional<double> slope;
    if (!(this->DropScale > 0.0))
    {
      slope = 0.0; // the slope at θ = 0 is 0, because τ is even in θ
    }
    else if (this->rimRatio(at, angles[1]) < 1.0)
    {
      // At a very small tilt only the change of the tip's depth has an effect: W(D, θ) = W(D - h,
      // 0).
      const TiltWork upright = pressedInto(this->Tool, {}, at);
      slope = this->Drop.at(0.0).offset * (2.0 / at - upright.force / upright.work);
    }
    this->Rows.push_back({ at, CubicSpline(angles, works, slope) });
  }
  const double spacing = std::log(Shallowest) / std::max(1, steps) / SamplesPerRow;
  for (std::size_t i = 0; i < (steps > 0 ? MostSamples : 0); ++i)
  {
    const double at = depth * std::exp(-spacing * static_cast<double>(i));
    this->Uprights.push_back({ at, pressedInto(this->Tool, {}, at) });
  }
}

std::shared_ptr<const AxisymmetricTool> TiltedHalfSpace::equivalent(double angle) const
{
  if (!(angle > 0.0) || this->Is == Kind::Sphere)
  {
    return { std::shared_ptr<void>(), &this->Tool }; // the returned pointer does not own the tool
  }
  return this->Is == Kind::Flat ? this->flat(angle) : this->fromRows(angle);
}

/// Returns the equivalent profile of a flat end: a(D) = R f'(q).
std::shared_ptr<const AxisymmetricTool> TiltedHalfSpace::flat(double angle) const
{
  constexpr double Least = 1e-4;
  constexpr double Whole = 3.0; // smallest q at which the end is in full contact
  constexpr int Lower = 60;     // number of points from the smallest q to 1
  // Number of points from q = 1 to full contact, with decreasing distances between them.
  constexpr int Upper = 40;
  const double radius = this->Tool.largestContactRadius();
  const double drop = this->Drop.at(angle).drop;
  std::vector<TiltedTool::Sample> samples;
  const auto add = [&](double q)
  {
    const TiltedFlatTerm at = tiltedFlatForce(q);
    samples.push_back({ q * drop, radius * at.slope, at.bend * q / at.slope });
  };
  for (int i = 0; i < Lower; ++i)
  {
    add(std::pow(Least, 1.0 - static_cast<double>(i) / Lower));
  }
  for (int i = 0; i <= Upper; ++i)
  {
    const double left = 1.0 - static_cast<double>(i) / Upper;
    add(Whole - (Whole - 1.0) * left * left);
  }
  return std::make_shared<const TiltedTool>(
    joined(this->Tool.specification(), " tilted by ", angle, " rad"), std::move(samples), true);
}

std::shared_ptr<const AxisymmetricTool> TiltedHalfSpace::fromRows(double angle) const
{
  const std::string name = joined(this->Tool.specification(), " tilted by ", angle, " rad");
  const Row& first = this->Rows.front();
  if (this->Is == Kind::ScaleFree)
  {
    // For a cone W ∝ D³ and a ∝ D.
    const double radius =
      this->Tool.contactRadius(first.depth) * std::pow(first.works.at(angle).value, 1.0 / Power);
    return std::make_shared<const TiltedTool>(name,
      std::vector<TiltedTool::Sample>{
        { first.depth, radius, 1.0 }, { 2.0 * first.depth, 2.0 * radius, 1.0 } },
      false);
  }
  const CubicSpline stored = this->over(angle);
  // For a flat end the samples begin at a depth at which only its rim touches; for other tools they
  // begin at the smallest solved depth.
  const double drop = this->DropScale > 0.0 ? this->Drop.at(angle).drop : 0.0;
  constexpr double OnRim = 0.02; // largest D/h at which the force is nearly a power of the depth
  const double begin = drop > 0.0 ? std::min(first.depth, OnRim * drop) : first.depth;
  std::vector<TiltedTool::Sample> samples;
  for (std::size_t i = this->Uprights.size(); i-- > 0;)
  {
    const bool isNeeded =
      i < OfRows || (i + 1 < this->Uprights.size() && this->Uprights[i + 1].depth > begin);
    if (isNeeded)
    {
      const double depth = this->Uprights[i].depth;
      const double radius = 0.5 * this->workOf(this->Uprights[i], stored, angle).stiffness;
      samples.push_back({ depth, std::max(radius, Smallest * depth), 0.0 });
    }
  }
  makeMonotone(samples);
  setExponents(samples);
  auto tool = std::make_shared<const TiltedTool>(name, samples, false);
  if (drop > 0.0)
  {
    // a(D) has a kink at the depth at which the whole end is in contact.
    tool = std::make_shared<const TiltedTool>(name, std::move(samples), false,
      std::vector<double>{ tool->contactRadius(this->DropScale * drop) });
  }
  return tool;
}

/// Returns W = W_0 ρ η and its derivatives. Slopes and second derivatives (bends) are with respect
/// to ln D.
TiltWork TiltedHalfSpace::workOf(
  const Upright& upright, const CubicSpline& stored, double angle) const
{
  const double depth = upright.depth;
  const TiltWork& at = upright.at;
  const SplinePoint eta = stored.at(std::log(depth));
  double logarithm = eta.value; // logarithm of η; its derivatives are computed from those of η
  double logarithmSlope = eta.slope;
  double logarithmBend = eta.bend;
  if (!this->IsFaceted)
  {
    const double power = this->DropScale > 0.0 ? 1.0 : 1.0 / Power;
    const double relative = eta.slope / eta.value;
    logarithm = power * std::log(eta.value);
    logarithmSlope = power * relative;
    logarithmBend = power * (eta.bend / eta.value - relative * relative);
  }
  const double m = depth * at.force / at.work;
  double work = at.work * std::exp(logarithm);
  double slope = m + logarithmSlope;
  double bend = m + depth * depth * at.stiffness / at.work - m * m + logarithmBend;
  if (this->DropScale > 0.0)
  {
    const double ratio = this->rimRatio(depth, angle);
    const TiltedFlatTerm rho = tiltedFlatWork(ratio);
    const double rhoSlope = -ratio * rho.slope / rho.value;
    work *= rho.value;
    slope += rhoSlope;
    bend += ratio * (rho.slope + ratio * rho.bend) / rho.value - rhoSlope * rhoSlope;
  }
  return { work * slope / depth, work * (slope * (slope - 1.0) + bend) / (depth * depth), work };
}

CubicSpline TiltedHalfSpace::over(double angle) const
{
  std::vector<double> places; // ln D
  std::vector<double> works;
  for (const Row& row : this->Rows)
  {
    places.push_back(std::log(row.depth));
    works.push_back(row.works.at(angle).value);
  }
  return CubicSpline(places, works);
}

TiltWork TiltedHalfSpace::pressed(double depth, double angle) const
{
  if (this->Is == Kind::Solved && angle > 0.0)
  {
    return this->workOf({ depth, pressedInto(this->Tool, {}, depth) }, this->over(angle), angle);
  }
  return pressedInto(*this->equivalent(angle), {}, depth);
}
} // namespace palpate
