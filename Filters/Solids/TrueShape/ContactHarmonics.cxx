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
/// Returns d ln F / d ln a at a sample, from the neighbouring samples.
double growth(const std::vector<ContactSample>& samples, std::size_t i)
{
  const std::size_t low = i > 0 ? i - 1 : 0;
  const std::size_t high = std::min(i + 1, samples.size() - 1);
  return std::log(samples[high].force / samples[low].force) /
    std::log(samples[high].radius / samples[low].radius);
}

/// Ratio of the third-order error to the second-order correction for the shape of the surface. It
/// was measured on random waves, against contacts that were solved without a mean over angles
/// (SurfaceGapTest).
constexpr double GapErrorFactor = 0.4;
/// If the relative error of the second-order correction is at most this value, the correction is
/// sufficient. Otherwise the contact is solved (UnevenContact).
constexpr double SufficientError = 0.01;
/// Error of the cells of a solved contact, as a fraction of the contact's difference from the mean
/// contact, and as a fraction of the force. Both were measured in the same way as GapErrorFactor.
constexpr double UnevenErrorFactor = 0.05;
constexpr double CellError = 0.002;
/// Ratio of the relative error of the force, due to the assumption of small slopes, to the mean
/// square slope. The contact of a ball with a/R = 0.4 has a mean square slope of 0.08 and an error
/// of up to 1 % (ShapedContactTest).
constexpr double SlopeErrorFactor = 0.25;
/// While the contact grows, one in this many contacts is solved.
constexpr std::size_t ContactsPerSolution = 3;
/// Ratio of the distance between the smooth patches and the true body to the geometric mean of two
/// lengths: the distance of the facets from the patches and the unevenness of the facets' edges.
/// The ratio was measured on bumps that the points resolve, on bumps that they do not resolve
/// (GapOfSurfaceTest), and on scans of a bunny and a dragon that were thinned to a third, a tenth
/// or a twentieth of the points.
constexpr double FacetErrorFactor = 1.0 / 3.0;
/// Ratio of the square of the residual's g (SurfaceGap) to the mean square of the residual itself.
constexpr double RoughnessFactor = 30.0;
/// Returns the mean square slope of the mean surface (the mean over angles) under a contact.
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

/// Returns the difference of the compliance n·Γn, mm/N, between a force that is inclined by the
/// slope and a force along the normal. The magnitude of the first term is used, so that the result
/// is an upper bound.
double changeOfCompliance(const Eigen::Matrix3d& directed, const Eigen::Vector2d& slope)
{
  return 2.0 * slope.norm() * directed.col(2).head<2>().norm() +
    slope.dot(directed.topLeftCorner<2, 2>() * slope);
}

/// Effect of the surface's shape around the axis on a contact.
struct Unevenness
{
  double depth = 0.0; ///< reduction of δ under the same force, mm
  double left = 0.0;  ///< error of `depth`, mm
  double slope = 0.0; ///< mean square slope of the surface under the contact
  double cells = 0.0; ///< error of the cells, as a fraction of the force
};

/// Solves contacts and interpolates the effects on the other contacts. While the contact grows, one
/// in ContactsPerSolution contacts and the last contact are solved. At the wall, every contact is
/// solved. A contact that extends beyond the known surface gets the larger error (GapErrorFactor).
void solveUneven(const std::vector<ContactSample>& samples, std::size_t growing, double modulus,
  UnevenContact& uneven, std::vector<Unevenness>& shape)
{
  std::size_t before = 0; // index of the last contact that was solved
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const ContactSample& s = samples[i];
    const bool isTaken = i >= growing || i + 1 == growing || i % ContactsPerSolution == 0;
    if (!isTaken || !(s.force > 0.0))
    {
      continue;
    }
    const UnevenContact::Change change = uneven.at(s.radius, s.force / modulus);
    const double left = change.isInside ? UnevenErrorFactor : GapErrorFactor;
    shape[i] = { -change.deflection, left * std::abs(change.deflection), change.steepness,
      CellError };
    for (std::size_t k = before + 1; k < i; ++k)
    {
      // On an inclined plane, the effect is the same at all radii. With unequal curvatures, it
      // grows as a².
      const double t = static_cast<double>(k - before) / static_cast<double>(i - before);
      const auto between = [&](double Unevenness::*part)
      {
        const double low = shape[before].*part;
        const double high = shape[i].*part;
        return low * high > 0.0 ? low * std::pow(high / low, t) : low + t * (high - low);
      };
      shape[k] = { between(&Unevenness::depth), between(&Unevenness::left),
        between(&Unevenness::slope), CellError };
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
    // da/dF. It is 0 if the radius is constant.
    const double grows = i < curve.growing && curve.growing > 1 ? growth(samples, i) : Infinity;
    const double widens = grows > 0.0 ? s.radius / (s.force * grows) : 0.0;
    const double torque = 4.0 / 3.0 * modulus * s.radius * s.radius * s.radius;
    const auto leaning = [&](const Eigen::Vector2d& slope)
    { return 2.0 * modulus * s.radius * s.radius * slope.squaredNorm() * widens; };
    const Eigen::Vector2d turned = kernel.gap.lean + kernel.tilt * s.force;
    tilts[i] = kernel.tilt.dot(turned) * torque + leaning(turned) - leaning(kernel.gap.lean);
    s.harmonics = tilts[i] / s.deflection;
    const double gap = leaning(kernel.gap.lean) + 0.5 * modulus * kernel.gap.waves * widens;
    const double rough = 0.5 * modulus * RoughnessFactor * kernel.gap.left * widens;
    shape[i] = { gap, GapErrorFactor * gap + rough, 0.0, 0.0 };
    isEnough = isEnough && curve.stiffness[i] / s.force * shape[i].left < SufficientError;
    const double open = FacetErrorFactor * std::sqrt(kernel.gap.facets * kernel.gap.uneven);
    s.surface = curve.stiffness[i] / s.force * open;
    s.direction = curve.stiffness[i] * changeOfCompliance(at.site().directed, turned);
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
        SlopeErrorFactor * (shape[i].slope + meanSlope(curve.kernels[i].gap.drop, s.radius));
      s.deflection -= tilts[i] + shape[i].depth;
    }
  }
}
} // namespace palpate
