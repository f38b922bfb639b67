// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/ContactHarmonics.h"

#include "Mechanics/Numerics/Constants.h"
#include "Solids/TrueShape/UnevenContact.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// d ln F / d ln a at a sample, by its neighbours.
double growth(const std::vector<ContactSample>& samples, std::size_t i)
{
  const std::size_t low = i > 0 ? i - 1 : 0;
  const std::size_t high = std::min(i + 1, samples.size() - 1);
  return std::log(samples[high].force / samples[low].force) /
    std::log(samples[high].radius / samples[low].radius);
}

/// Of the part of second order that a surface's shape has, what third order may do. Measured on
/// random waves against contacts without an angle mean (SurfaceGapTest).
constexpr double LeftOfGap = 0.4;
/// The part of the force up to which that will do; above it the contact is solved (UnevenContact).
constexpr double Enough = 0.01;
/// What the cells of a solved contact may miss: of what it differs from the mean one, and of the
/// force. Measured likewise.
constexpr double LeftOfUneven = 0.05;
constexpr double LeftOfCells = 0.002;
/// Of the force, times the mean square slope: what small slopes leave out. A ball's contact of a/R
/// = 0.4, of which that is 0.08, is off by up to 1 % (ShapedContactTest).
constexpr double LeftOfSlope = 0.25;
/// Growing contacts that one is solved for.
constexpr std::size_t ContactsPerSolution = 3;
/// How far smooth patches lie off the body that has the same points: of the geometric mean of how
/// far facets lie off them, and of how uneven their edges are. Measured on bumps, those that the
/// points describe and those that they do not (GapOfSurfaceTest), and on scans of a bunny and a
/// dragon of which a third, a tenth or a twentieth of the points was left.
constexpr double LeftOfFacets = 1.0 / 3.0;
/// g² of what is left of a gap, over its mean square.
constexpr double OfRoughness = 30.0;
/// Mean square slope under a contact of the angle mean of the surface.
double meanSlope(const Eigen::Vector4d& drop, double radius)
{
  double sum = 0.0;
  for (int m = 1; m < 4; ++m)
  {
    for (int n = 1; n < 4; ++n)
    {
      sum += 4.0 * m * n / (m + n) * drop[m] * drop[n];
    }
  }
  return sum / (radius * radius);
}

/// By how much more or less a body yields, mm/N, to a force that leans by the slope than to one
/// along the normal: n·Γn of both, the signs such as add up.
double yieldsOtherwise(const Eigen::Matrix3d& directed, const Eigen::Vector2d& slope)
{
  return 2.0 * slope.norm() * directed.col(2).head<2>().norm() +
    slope.dot(directed.topLeftCorner<2, 2>() * slope);
}

/// What the surface's shape around the axis does to a contact.
struct Unevenness
{
  double depth = 0.0; ///< how much less deep under the same force, mm
  double left = 0.0;  ///< what may be missing of that, mm
  double slope = 0.0; ///< mean square
  double cells = 0.0; ///< of the force
};

/// Solves every second contact while it grows, and the last; all of those that have reached the
/// wall. What cannot be solved stays.
void solveUneven(const std::vector<ContactSample>& samples, std::size_t growing, double modulus,
  UnevenContact& uneven, std::vector<Unevenness>& shape)
{
  std::size_t before = 0; // the last that was solved
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const ContactSample& s = samples[i];
    const bool isTaken = i >= growing || i + 1 == growing || i % ContactsPerSolution == 0;
    if (!isTaken || !(s.force > 0.0))
    {
      continue;
    }
    const UnevenContact::Change change = uneven.at(s.radius, s.force / modulus);
    const double left = change.isInside ? LeftOfUneven : LeftOfGap;
    shape[i] = { -change.deflection, left * std::abs(change.deflection), change.steepness,
      LeftOfCells };
    for (std::size_t k = before + 1; k < i; ++k)
    {
      // Of a leaning plane it is the same for all, of unequal curvatures it goes with a².
      const double t = static_cast<double>(k - before) / static_cast<double>(i - before);
      const auto between = [&](double Unevenness::*part)
      {
        const double low = shape[before].*part;
        const double high = shape[i].*part;
        return low * high > 0.0 ? low * std::pow(high / low, t) : low + t * (high - low);
      };
      shape[k] = { between(&Unevenness::depth), between(&Unevenness::left),
        between(&Unevenness::slope), LeftOfCells };
    }
    before = i;
  }
}
} // namespace

void addHarmonics(CurveSamples& curve, const ContactKernels& at, const AxisymmetricTool& tool)
{
  std::vector<ContactSample>& samples = curve.samples;
  const double modulus = at.site().reducedModulus;
  const SurfaceGap* surface = at.surface();
  std::vector<double> tilts(samples.size(), 0.0);
  std::vector<Unevenness> shape(samples.size());
  bool isEnough = curve.growing == samples.size();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    ContactSample& s = samples[i];
    if (!(s.deflection > 0.0 && s.force > 0.0))
    {
      continue;
    }
    const ContactKernel& kernel = curve.kernels[i];
    // da/dF; 0 where the radius stays.
    const double grows = i < curve.growing && curve.growing > 1 ? growth(samples, i) : Infinity;
    const double widens = grows > 0.0 ? s.radius / (s.force * grows) : 0.0;
    const double torque = 4.0 / 3.0 * modulus * s.radius * s.radius * s.radius;
    const auto leaning = [&](const Eigen::Vector2d& slope)
    { return 2.0 * modulus * s.radius * s.radius * slope.squaredNorm() * widens; };
    const Eigen::Vector2d turned = kernel.gap.lean + kernel.tilt * s.force;
    tilts[i] = kernel.tilt.dot(turned) * torque + leaning(turned) - leaning(kernel.gap.lean);
    s.harmonics = tilts[i] / s.deflection;
    const double gap = leaning(kernel.gap.lean) + 0.5 * modulus * kernel.gap.waves * widens;
    const double rough = 0.5 * modulus * OfRoughness * kernel.gap.left * widens;
    shape[i] = { gap, LeftOfGap * gap + rough, 0.0, 0.0 };
    isEnough = isEnough && curve.stiffness[i] / s.force * shape[i].left < Enough;
    const double open = LeftOfFacets * std::sqrt(kernel.gap.facets * kernel.gap.uneven);
    s.surface = curve.stiffness[i] / s.force * open;
    s.direction = curve.stiffness[i] * yieldsOtherwise(at.site().directed, turned);
  }
  if (surface != nullptr && !isEnough)
  {
    UnevenContact uneven(tool, *surface);
    solveUneven(samples, curve.growing, modulus, uneven, shape);
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    ContactSample& s = samples[i];
    if (s.force > 0.0)
    {
      s.gap += curve.stiffness[i] / s.force * shape[i].left + shape[i].cells +
        LeftOfSlope * (shape[i].slope + meanSlope(curve.kernels[i].gap.drop, s.radius));
      s.deflection -= tilts[i] + shape[i].depth;
    }
  }
}
} // namespace palpate
