// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/ShapedContact.h"

#include "Mechanics/Numerics/Constants.h"
#include "Solids/TrueShape/ContactHarmonics.h"
#include "Solids/TrueShape/KernelError.h"
#include "Solids/TrueShape/PunchDepths.h"
#include "Solids/TrueShape/StrainShare.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace palpate
{
namespace
{
/// Factors κ_m, with which r^{2m} is replaced by κ_m x^{2m}.
const Eigen::Vector4d Reduced(1.0, 2.0, 8.0 / 3.0, 16.0 / 5.0);

/// Returns φ_m at x = t a, as powers of t.
Eigen::Vector4d reducedPowers(double t)
{
  const double s = t * t;
  return Reduced.cwiseProduct(Eigen::Vector4d(1.0, s, s * s, s * s * s));
}

constexpr double RoundExponent = 1.5; ///< exponent m of F ∝ δ^m for a bulging surface

/// Type of the first touch of a contact.
enum class Touch
{
  Pointed, ///< the tool has a tip
  Flat,    ///< the tool's end and the surface under it are flat
  Bulging, ///< The surface bulges under a flat end. The contact grows from a point.
  Closing  ///< A flat punch is on a hollow or inclined surface. Its rim touches first.
};

/// Smallest rise of the surface under a flat end that counts as a bulge, as a fraction of the
/// radius of the end.
constexpr double LeastBulge = 1e-4;

std::vector<double> contactRadii(double smallest, double largest, Touch touch, int count)
{
  std::vector<double> radii;
  const auto at = [count](int i)
  { return static_cast<double>(i) / static_cast<double>(count - 1); };
  if (touch == Touch::Pointed || touch == Touch::Bulging)
  {
    const double end = touch == Touch::Bulging ? std::min(smallest, largest) : largest;
    for (int i = 0; i < count; ++i)
    {
      radii.push_back(end * std::pow(ContactKernels::FirstRadius, 1.0 - at(i)));
    }
  }
  if (touch != Touch::Pointed && smallest < largest)
  {
    for (int i = touch == Touch::Bulging ? 1 : 0; i < count; ++i)
    {
      radii.push_back(smallest + (largest - smallest) * at(i) * at(i));
    }
  }
  return radii;
}

/// Returns the reason why a curve ends. It is used if no other reason ended the curve earlier.
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

/// Returns whether the tool is only a flat punch.
bool isFlat(const AxisymmetricTool& tool)
{
  return tool.largestContactRadius() <= tool.smallestContactRadius();
}

/// The first contact of a flat end.
struct FlatTouch
{
  Touch touch = Touch::Pointed;
  double closed = 0.0; ///< depth from which a flat punch is in full contact, mm
};

FlatTouch touchOf(
  const ShapedContact& law, const AxisymmetricTool& tool, const ContactKernels& kernels)
{
  const double smallest = tool.smallestContactRadius();
  if (!(smallest > 0.0))
  {
    return {};
  }
  const double radius = std::nextafter(smallest, 0.0);
  const ContactKernel kernel = kernels.at(radius);
  const double rise = law.at(radius, kernel, kernels.site().reducedModulus).deflection;
  const double least = LeastBulge * smallest;
  // From this depth on, the pressure near the rim, (δ - 2 s·r - g)/√(a² - r²), is nowhere negative.
  const double uneven = 2.0 * radius * kernel.gap.lean.norm() + std::sqrt(2.0 * kernel.gap.waves);
  FlatTouch found{ Touch::Flat, (rise < 0.0 ? -2.0 * rise : rise) + uneven };
  if (rise > std::max(least, isFlat(tool) ? uneven : 0.0))
  {
    found.touch = Touch::Bulging;
  }
  else if (isFlat(tool) && found.closed > least)
  {
    found.touch = Touch::Closing;
  }
  return found;
}

/// Removes samples whose deflection or force is not above that of the previous sample, or not above
/// zero. Returns true if the last sample is removed.
bool keepRising(std::vector<ContactSample>& samples, bool beginsFlat)
{
  std::size_t kept = beginsFlat ? std::min<std::size_t>(samples.size(), 1) : 0;
  bool left = false;
  for (std::size_t i = kept; i < samples.size(); ++i)
  {
    const ContactSample before = kept > 0 ? samples[kept - 1] : ContactSample{};
    left = !(samples[i].deflection > before.deflection && samples[i].force > before.force);
    if (!left)
    {
      samples[kept++] = samples[i];
    }
  }
  samples.resize(kept);
  return left;
}
} // namespace

ShapedContact::ShapedContact(
  const AxisymmetricTool& tool, const StrainCorrection* strain, int samples)
  : Tool(tool)
  , Strain(strain)
  , Quadrature(tool)
  , Count(std::max(samples, 4))
{
}

ShapedContact::Contact ShapedContact::at(double radius, const ContactKernel& kernel,
  double reducedModulus, std::optional<double> deflection) const
{
  // With t = x/a, these are the moments of φ_m φ_n, of φ_m, and of φ_m g, each divided by a.
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
  Eigen::Vector4d gaps = products * kernel.gap.drop;
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
  contact.deflection = deflection ? *deflection
                                  : (this->Tool.reducedProfile(radius) +
                                      kernel.gap.drop.dot(reducedPowers(1.0)) - rim.dot(profile)) /
      (1.0 - rim.dot(flat));
  contact.force = 2.0 * reducedModulus * radius * (contact.deflection * flat[0] - profile[0]);
  return contact;
}

struct ShapedContact::Course : CurveSamples
{
  Touch touch = Touch::Pointed;
};

/// Adds the contact with a given radius, or the contact at the tool's wall for a given deflection.
/// Returns false if, with this kernel, the contact cannot grow to this radius or deflection.
bool ShapedContact::takeSample(double radius, std::optional<double> deflection,
  const ContactKernels& kernels, int largestOrder, Course& course) const
{
  const double modulus = kernels.site().reducedModulus;
  const ContactKernel kernel = kernels.at(radius, largestOrder);
  const Contact contact = this->at(radius, kernel, modulus, deflection);
  if (kernel.order == 0 || !contact.stable)
  {
    return false;
  }
  ContactSample sample;
  sample.radius = radius;
  const bool begins = course.touch == Touch::Flat && course.samples.empty() && !isFlat(this->Tool);
  if (!begins)
  {
    sample.deflection = contact.deflection;
    sample.force = contact.force;
    const bool isFirst = course.samples.empty();
    // The deflection does not yet include the uneven part of the shape.
    const double least = deflection ? -Infinity : 0.0;
    const double depthBefore = isFirst ? least : course.samples.back().deflection;
    const double forceBefore = isFirst ? 0.0 : course.samples.back().force;
    if (!(sample.deflection > depthBefore && sample.force > forceBefore))
    {
      // The cause is the surface and not the kernel. Therefore the contact can grow further.
      return !kernel.gap.drop.isZero();
    }
    if (kernel.order > 1)
    {
      ContactKernel coarser = kernels.at(radius, kernel.order - 1);
      coarser.gap = kernel.gap; // the order of the kernel does not affect the shape of the surface
      const Contact lower = this->at(radius, coarser, modulus, deflection);
      sample.truncation =
        (lower.force + lower.stiffness * (contact.deflection - lower.deflection)) / contact.force -
        1.0;
    }
    else
    {
      sample.truncation = contact.stiffness * missedByOne(kernel, kernels.site(), radius);
    }
  }
  sample.mesh = contact.stiffness * meshError(kernel, kernels.site(), radius);
  sample.beside = std::min(1.0, kernels.site().spacing / kernels.site().limit);
  course.samples.push_back(sample);
  course.kernels.push_back(kernel);
  course.stiffness.push_back(contact.stiffness);
  return true;
}

/// Applies the correction for finite strain to the samples. Without a correction, adds the error
/// due to finite strain.
void ShapedContact::addStrain(const ContactKernels& kernels, Course& course) const
{
  for (std::size_t i = 0; i < course.samples.size(); ++i)
  {
    ContactSample& sample = course.samples[i];
    if (sample.force > 0.0)
    {
      const StrainShare share = strainShare(this->Tool, this->Strain, kernels.site().material,
        { sample.force, course.stiffness[i], sample.radius });
      sample.force += share.force;
      sample.deflection += share.deflection;
      sample.strain = share.error;
    }
  }
}

ContactCurve ShapedContact::curve(const ContactKernels& kernels, int largestOrder) const
{
  const double smallest = this->Tool.smallestContactRadius();
  const double wall = this->Tool.largestContactRadius();
  const KernelSite& site = kernels.site();
  CurveEnd end = endOf(site, wall <= site.largestRadius);
  if (site.status != PatchStatus::Valid || smallest > site.largestRadius)
  {
    return ContactCurve({}, 1.0, false, 0.0, end, 0.0);
  }
  Course course;
  const FlatTouch touch = touchOf(*this, this->Tool, kernels);
  course.touch = touch.touch;
  const bool isPunch = isFlat(this->Tool);
  bool grows = true;
  bool isTaken = true; // whether the last sample was added
  const auto take = [&](double radius, std::optional<double> deflection, double open)
  {
    const std::size_t before = course.samples.size();
    grows = grows && this->takeSample(radius, deflection, kernels, largestOrder, course);
    isTaken = course.samples.size() > before;
    if (isTaken)
    {
      course.samples.back().gap = open;
    }
  };
  if (!isPunch || touch.touch == Touch::Bulging)
  {
    const double largest = std::min(std::nextafter(wall, 0.0), site.largestRadius);
    for (const double radius : contactRadii(smallest, largest, touch.touch, this->Count))
    {
      take(radius, {}, 0.0);
    }
  }
  course.growing = course.samples.size();
  if (isPunch)
  {
    const Contact closed = this->at(wall, kernels.at(wall), site.reducedModulus, touch.closed);
    PunchClosing closing;
    closing.depth = touch.touch == Touch::Flat ? 0.0 : touch.closed;
    closing.sink = closed.force / closed.stiffness;
    closing.carried = course.growing > 0 ? course.samples.back().force / closed.force : 0.0;
    closing.isSolved = kernels.surface() != nullptr;
    for (const PunchDepth& pressed : punchDepths(wall, closing))
    {
      take(wall, pressed.depth, pressed.open);
    }
  }
  std::vector<ContactSample>& samples = course.samples;
  addHarmonics(course, kernels, this->Tool);
  this->addStrain(kernels, course);
  const bool beginsFlat = touch.touch == Touch::Flat && !isPunch;
  end = keepRising(samples, beginsFlat) || !grows || !isTaken ? CurveEnd::Unstable : end;
  const double first = course.stiffness.empty() ? 0.0 : course.stiffness.front();
  double tail = course.stiffness.empty() ? 0.0 : course.stiffness.back();
  if (isPunch && samples.size() > 1)
  {
    const ContactSample& last = samples.back();
    const ContactSample& before = samples[samples.size() - 2];
    tail = (last.force - before.force) / (last.deflection - before.deflection);
  }
  const double exponent = touch.touch == Touch::Bulging ? RoundExponent
    : isPunch                                           ? 1.0
                                                        : this->Tool.forceExponent();
  return ContactCurve(std::move(samples), exponent, beginsFlat, first, end, tail);
}
} // namespace palpate
