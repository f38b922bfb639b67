// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/TrueShape/ShapedContact.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// r^{2m} becomes this times x^{2m}.
const Eigen::Vector4d Reduced(1.0, 2.0, 8.0 / 3.0, 16.0 / 5.0);

/// φ_m at x = t a, in powers of t.
Eigen::Vector4d reducedPowers(double t)
{
  const double s = t * t;
  return Reduced.cwiseProduct(Eigen::Vector4d(1.0, s, s * s, s * s * s));
}

constexpr double OfBending = 0.1; ///< of what bends
constexpr double OfFacets = 0.8;  ///< of H, times the square of the turn from facet to facet

/// What the elements let expect of the error of a contact's compliance, mm/N: by its place
/// (ElementError), less of a contact wider than they are, as they err most next to the source; of
/// what bends; and of facets on a curved surface, which is the same everywhere (measured on a
/// ball); and of what lies between the places where H is known. What the moduli of mixed cells do
/// is not in it.
double meshError(const ContactKernel& kernel, const KernelSite& site, double radius)
{
  const double self = std::abs(kernel.coefficients(0, 0));
  const double turn = 2.0 * kernel.drop[1] / (radius * radius) * site.spacing;
  return site.elements.error * site.spacing / (site.spacing + radius) +
    OfBending * std::max(0.0, self - site.elements.direct) +
    self * OfFacets * std::min(1.0, turn * turn) + kernel.spread;
}

/// What a kernel of one term leaves out, mm/N, where an edge or a base left too few sources for
/// more: H varies by its distance, between the source and the point, and under the contact.
double missedByOne(const ContactKernel& kernel, const KernelSite& site, double radius)
{
  const double under = radius / site.limit;
  return std::abs(kernel.coefficients(0, 0)) *
    std::min(1.0, site.nearestSource / site.limit + under * under);
}

std::vector<double> contactRadii(const AxisymmetricTool& tool, double largest, int count)
{
  const double smallest = tool.smallestContactRadius();
  std::vector<double> radii;
  for (int i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    radii.push_back(smallest > 0.0 ? smallest + (largest - smallest) * t * t
                                   : largest * std::pow(ContactKernels::FirstRadius, 1.0 - t));
  }
  return radii;
}

/// What ends a curve that meets nothing else.
CurveEnd endOf(const KernelSite& site, bool reachesWall)
{
  if (reachesWall)
  {
    return CurveEnd::None;
  }
  const PatchStatus by = site.limitedBy;
  return by == PatchStatus::OutOfReach ? CurveEnd::Held
    : by == PatchStatus::Edge          ? CurveEnd::Edge
                                       : CurveEnd::Patch;
}

/// d ln F / d ln a at a sample, by its neighbours.
double growth(const std::vector<ContactSample>& samples, std::size_t i)
{
  const std::size_t low = i > 0 ? i - 1 : 0;
  const std::size_t high = std::min(i + 1, samples.size() - 1);
  return std::log(samples[high].force / samples[low].force) /
    std::log(samples[high].radius / samples[low].radius);
}

/// Takes the tilt's part off the deflections.
void addTilts(std::vector<ContactSample>& samples, const std::vector<double>& tilts, double modulus)
{
  std::vector<double> parts(samples.size(), 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const ContactSample& s = samples[i];
    const double torque = 4.0 / 3.0 * modulus * s.radius * s.radius * s.radius;
    const double rigid = tilts[i] * tilts[i] * s.force * torque;
    // ½ F dT/dF over T: 3/2 over d ln F / d ln a, none where the radius stays.
    const double grows = samples.size() > 1 && s.force > 0.0 ? growth(samples, i) : Infinity;
    parts[i] = rigid * (1.0 + (grows > 0.0 ? 1.5 / grows : 0.0));
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (samples[i].deflection > 0.0)
    {
      samples[i].harmonics = parts[i] / samples[i].deflection;
      samples[i].deflection -= parts[i];
    }
  }
}
} // namespace

ShapedContact::ShapedContact(const AxisymmetricTool& tool, int samples)
  : Tool(tool)
  , Quadrature(tool)
  , Count(std::max(samples, 4))
{
}

ShapedContact::Contact ShapedContact::at(
  double radius, const ContactKernel& kernel, double reducedModulus, double deflection) const
{
  // In t = x/a: moments of φ_m φ_n, of φ_m, and of φ_m g, each over a.
  Eigen::Matrix4d products;
  Eigen::Vector4d ones;
  for (int m = 0; m < 4; ++m)
  {
    ones[m] = Reduced[m] / (2 * m + 1);
    for (int n = 0; n < 4; ++n)
    {
      products(m, n) = Reduced[m] * Reduced[n] / (2 * m + 2 * n + 1);
    }
  }
  Eigen::Vector4d gaps = products * kernel.drop;
  this->Quadrature.visit(radius,
    [&](double x, double weight, double g)
    { gaps += (weight * g / radius) * reducedPowers(x / radius); });

  const Eigen::Matrix4d c = 2.0 * reducedModulus * radius * kernel.coefficients;
  const Eigen::Matrix4d system = Eigen::Matrix4d::Identity() + products * c;
  const Eigen::PartialPivLU<Eigen::Matrix4d> lu(system);
  const Eigen::Vector4d flat = lu.solve(ones);
  const Eigen::Vector4d profile = lu.solve(gaps);
  const Eigen::Vector4d rim = c * reducedPowers(1.0);

  Contact contact;
  contact.stiffness = 2.0 * reducedModulus * radius * flat[0];
  contact.stable = 1.0 - rim.dot(flat) > 0.0 && contact.stiffness > 0.0;
  contact.deflection = deflection > 0.0
    ? deflection
    : (this->Tool.reducedProfile(radius) + kernel.drop.dot(reducedPowers(1.0)) - rim.dot(profile)) /
      (1.0 - rim.dot(flat));
  contact.force = 2.0 * reducedModulus * radius * (contact.deflection * flat[0] - profile[0]);
  return contact;
}

/// A curve on its way.
struct ShapedContact::Course
{
  std::vector<ContactSample> samples;
  std::vector<double> tilts;
  double firstStiffness = 0.0;
  double lastStiffness = 0.0;
};

/// Adds the contact of a radius; false when the contact does not grow to it.
bool ShapedContact::takeSample(
  double radius, const ContactKernels& kernels, int largestOrder, Course& course) const
{
  const double modulus = kernels.site().reducedModulus;
  const ContactKernel kernel = kernels.at(radius, largestOrder);
  const double given = this->isFlat() ? 1.0 : 0.0; // a flat's curve is a straight line
  const Contact contact = this->at(radius, kernel, modulus, given);
  ContactSample sample;
  sample.radius = radius;
  const bool begins =
    course.samples.empty() && this->Tool.smallestContactRadius() > 0.0 && !this->isFlat();
  if (!begins)
  {
    sample.deflection = contact.deflection;
    sample.force = contact.force;
  }
  const double depthBefore = course.samples.empty() ? 0.0 : course.samples.back().deflection;
  const double forceBefore = course.samples.empty() ? 0.0 : course.samples.back().force;
  const bool rises = sample.deflection > depthBefore && sample.force > forceBefore;
  if (kernel.order == 0 || !contact.stable || (!rises && !begins))
  {
    return false;
  }
  if (kernel.order > 1 && !begins)
  {
    ContactKernel coarser = kernels.at(radius, kernel.order - 1);
    coarser.drop = kernel.drop; // the shape is not what is expanded
    const Contact lower = this->at(radius, coarser, modulus, given);
    sample.truncation =
      (lower.force + lower.stiffness * (contact.deflection - lower.deflection)) / contact.force -
      1.0;
  }
  if (kernel.order == 1 && !begins)
  {
    sample.truncation = contact.stiffness * missedByOne(kernel, kernels.site(), radius);
  }
  sample.mesh = contact.stiffness * meshError(kernel, kernels.site(), radius);
  course.firstStiffness = course.samples.empty() ? contact.stiffness : course.firstStiffness;
  course.lastStiffness = contact.stiffness;
  course.samples.push_back(sample);
  course.tilts.push_back(kernel.tilt);
  return true;
}

ContactCurve ShapedContact::curve(const ContactKernels& kernels, int largestOrder) const
{
  const double smallest = this->Tool.smallestContactRadius();
  const double wall = this->Tool.largestContactRadius();
  CurveEnd end = endOf(kernels.site(), wall <= kernels.site().largestRadius);
  if (kernels.site().status != PatchStatus::Valid || smallest > kernels.site().largestRadius)
  {
    return ContactCurve({}, 1.0, false, 0.0, end, 0.0);
  }
  const double largest = std::min(std::nextafter(wall, 0.0), kernels.site().largestRadius);
  const std::vector<double> radii =
    this->isFlat() ? std::vector<double>{ wall } : contactRadii(this->Tool, largest, this->Count);
  Course course;
  for (std::size_t i = 0; i < radii.size() && end != CurveEnd::Unstable; ++i)
  {
    end = this->takeSample(radii[i], kernels, largestOrder, course) ? end : CurveEnd::Unstable;
  }
  std::vector<ContactSample>& samples = course.samples;
  addTilts(samples, course.tilts, kernels.site().reducedModulus);
  std::size_t rising = std::min<std::size_t>(samples.size(), 1);
  while (rising < samples.size() && samples[rising].deflection > samples[rising - 1].deflection)
  {
    ++rising;
  }
  end = rising < samples.size() ? CurveEnd::Unstable : end;
  samples.resize(rising);
  if (!this->isFlat())
  {
    return ContactCurve(std::move(samples), this->Tool.forceExponent(), smallest > 0.0,
      course.firstStiffness, end, course.lastStiffness);
  }
  const double slope = samples.empty() ? 0.0 : samples.front().force / samples.front().deflection;
  return ContactCurve(std::move(samples), 1.0, false, slope, end, slope);
}
} // namespace palpate
