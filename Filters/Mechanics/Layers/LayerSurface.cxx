// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/LayerSurface.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/DimensionalityReduction.h"
#include "Mechanics/Numerics/GaussLegendre.h"
#include "Mechanics/Layers/LayerContact.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
// Radius beyond which displacements have decayed, in thicknesses. The slowest decay is e^(-0.74
// r/h), that of an incompressible layer.
constexpr double ReachInLayers = 20.0;

/// The position t and the value of y dt at one node of a rule over the contact.
struct Source
{
  double t;
  double strength;
};

/// Returns (1/πh) Σ y dt [kernel(t + x) + kernel(x - t)]. `kernel` accepts negative arguments.
template <class Kernel>
double field(const std::vector<Source>& sources, double x, double h, Kernel&& kernel)
{
  double sum = 0.0;
  for (const Source& source : sources)
  {
    sum += source.strength * (kernel((x + source.t) / h) + kernel((x - source.t) / h));
  }
  return sum / (Pi * h);
}

/// Returns ∫_begin^r f(x) dx/√(r²-x²) for an f that varies over a length h. The substitution x = r
/// sin θ removes the root, and panels of 4 h resolve f.
template <class Function>
double abel(double begin, double r, double h, Function&& f)
{
  static const GaussLegendre rule(32);
  const int panels = static_cast<int>(std::ceil((r - begin) / (4.0 * h)));
  double sum = 0.0;
  double from = std::asin(begin / r);
  for (int i = 1; i <= panels; ++i)
  {
    const double to = i == panels ? 0.5 * Pi : std::asin((begin + i * (r - begin) / panels) / r);
    sum += rule.integrate(from, to, [&](double theta) { return f(r * std::sin(theta)); });
    from = to;
  }
  return sum;
}

/// Calls visit(t, weight, δ - g(t)) for each node of a rule over the contact.
template <class Visit>
void overContact(const LayerContact& contact, double a, double deflection, Visit&& visit)
{
  if (contact.quadrature().kinkedBelow(a))
  {
    contact.quadrature().visit(
      a, [&](double x, double weight, double g) { visit(x, weight, deflection - g); });
    return;
  }
  for (int i = 0; i < LayerKernel::NodeCount; ++i)
  {
    const double x = a * LayerKernel::nodes()[i];
    visit(x, a * LayerKernel::weights()[i], deflection - contact.tool().reducedProfile(x));
  }
}
} // namespace

LayerSurface::LayerSurface(const LayerContact& contact, double deflection)
  : Contact(contact)
  , Deflection(deflection)
  , Correction(LayerKernel::Samples::Zero())
{
  if (!(deflection > 0.0 && deflection <= contact.deepest()))
  {
    return;
  }
  const LayerKernel& kernel = contact.kernel();
  const double h = contact.thickness();
  const auto normal = [&kernel](double s) { return kernel.normal(std::abs(s)); };
  const auto radial = [&kernel](double s)
  { return s < 0.0 ? -kernel.radial(-s) : kernel.radial(s); };

  // y = (δ - g) - c with a smooth c that satisfies c + K c = K (δ - g).
  const double a = contact.contactRadius(deflection);
  std::vector<Source> sources;
  overContact(contact, a, deflection,
    [&](double t, double weight, double f) {
      sources.push_back({ t, weight * f });
    });
  LayerKernel::Samples right;
  for (int i = 0; i < LayerKernel::NodeCount; ++i)
  {
    right[i] = field(sources, a * LayerKernel::nodes()[i], h, normal);
  }
  this->Correction = kernel.solve(a / h, right);
  std::size_t next = 0;
  overContact(contact, a, deflection,
    [&](double t, double weight, double)
    {
      sources[next].strength -= weight * LayerKernel::interpolate(this->Correction, t / a);
      this->Integral += sources[next].strength;
      ++next;
    });

  this->Radius = a;
  this->Reach = a + ReachInLayers * h;
  const auto pieces = [h](double length) { return static_cast<int>(std::ceil(length / h)); };
  this->Normal = { this->Reach - a, pieces(this->Reach - a),
    [&](double x) { return field(sources, a + x, h, normal); } };
  this->Radial = { this->Reach, pieces(this->Reach),
    [&](double x) { return field(sources, x, h, radial); } };
}

/// Returns u_z at r > a.
double LayerSurface::outside(double r) const
{
  const double halfSpace = reduction::normalDisplacementOutside([this](double x)
    { return this->Contact.tool().reducedProfile(x); },
    r, this->Radius, this->Deflection);
  const double layer = abel(this->Radius, r, this->Contact.thickness(),
    [this](double x) { return this->Normal.evaluate(std::max(0.0, x - this->Radius)); });
  return halfSpace + 2.0 / Pi * layer;
}

/// Returns the load within the radius r, divided by 2E*.
double LayerSurface::loadInside(double r) const
{
  if (r >= this->Radius)
  {
    return this->Integral;
  }
  // The substitution t = √(r²+s²) removes the root of ∫_r^a y t dt/√(t²-r²).
  const double end = std::sqrt((this->Radius - r) * (this->Radius + r));
  const double ring = GaussLegendre::standard().integrate(0.0, end,
    [&](double s)
    {
      const double t = std::min(std::sqrt(r * r + s * s), std::nextafter(this->Radius, 0.0));
      return this->Deflection - this->Contact.tool().reducedProfile(t) -
        LayerKernel::interpolate(this->Correction, t / this->Radius);
    });
  return this->Integral - ring;
}

SurfaceDisplacement LayerSurface::at(double r) const
{
  if (!(r >= 0.0) || std::isnan(this->Deflection))
  {
    return { NotANumber, NotANumber };
  }
  if (this->Radius == 0.0 || r > this->Reach)
  {
    return { 0.0, 0.0 };
  }
  const double normal =
    r <= this->Radius ? this->Deflection - this->Contact.tool().profile(r) : this->outside(r);
  if (r == 0.0)
  {
    return { 0.0, normal };
  }
  const double nu = this->Contact.kernel().poissonRatio();
  const double halfSpace = (1.0 - 2.0 * nu) / (Pi * (1.0 - nu)) * this->loadInside(r) / r;
  const double layer = 2.0 / Pi / r *
    abel(
      0.0, r, this->Contact.thickness(), [this](double x) { return this->Radial.evaluate(x) * x; });
  return { -halfSpace - layer, normal };
}
} // namespace palpate
