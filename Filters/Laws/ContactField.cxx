// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ContactField.h"

#include "Contact/ParallelRanges.h"
#include "Contact/TriangleProjection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Layers/LayerSurface.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/IncreasingRoot.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace palpate
{
namespace
{
/// Returns the thickness of the layer under the contact, mm; 0 on a half-space. The inverse 1/h is
/// interpolated, because the stiffening by a base is proportional to 1/h, and 1/h is 0 on a
/// half-space.
double thicknessAt(const std::array<double, 3>& thickness, const Vector3& weights)
{
  if (thickness[0] == thickness[1] && thickness[1] == thickness[2])
  {
    return thickness[0];
  }
  double inverse = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double h = thickness[i];
    inverse += h > 0.0 ? weights[static_cast<Eigen::Index>(i)] / h : 0.0;
  }
  return inverse > 0.0 ? 1.0 / inverse : 0.0;
}

/// Returns the stack of layers under the contact. Thicknesses that vary are rounded to half a
/// percent, so that one kernel can be used for nearby contacts.
LayerStack stackAt(const FieldTriangle& triangle, const Vector3& weights)
{
  LayerStack stack = triangle.stack;
  const std::array<const std::array<double, 3>*, 2> varying = { &triangle.thickness,
    &triangle.second };
  for (std::size_t i = 0; i < std::min(stack.layers.size(), varying.size()); ++i)
  {
    const std::array<double, 3>& corner = *varying[i];
    const double h = thicknessAt(corner, weights);
    const bool isEven = corner[0] == corner[1] && corner[1] == corner[2];
    if (h > 0.0)
    {
      constexpr double step = 0.01;
      stack.layers[i].thickness = isEven ? h : std::exp(step * std::round(std::log(h) / step));
    }
  }
  return stack;
}

/// Upper limit of the local deflection that is searched for a given force, as a multiple of the
/// deflection.
constexpr double DeepestDent = 10.0;

/// Returns the deflection at which a tool on a half-space has the given force; at most `most`, mm.
double deflectionOf(const AxisymmetricTool& tool, double force, double reducedModulus, double most)
{
  const double high = std::min(most, tool.depthLimit().depth);
  if (!(tool.force(high, reducedModulus) > force))
  {
    return high;
  }
  return increasingRoot(
    [&](double depth) -> ValueAndSlope
    {
      const IndentationPoint at = tool.evaluate(depth, reducedModulus);
      return { at.force - force, at.stiffness };
    },
    0.0, high, 0.5 * high);
}

/// Returns the radius of an edge of the tool that is well within the contact; 0 if there is no such
/// edge.
double edgeWithin(const AxisymmetricTool& tool, double contactRadius)
{
  const std::vector<double> kinks = tool.kinks();
  return !kinks.empty() && kinks.front() < 0.999 * contactRadius ? kinks.front() : 0.0;
}

/// Returns 0 below `begin` and 1 above `end`, with a smooth transition between them.
double smoothStep(double begin, double end, double x)
{
  const double t = std::clamp((x - begin) / (end - begin), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Adds the displacement by a mode, multiplied by `weight`. Returns whether all values are finite.
template <class Number>
bool addMode(const Number* mode, double weight, std::size_t points, float* displacement)
{
  std::atomic<bool> isFinite{ true };
  forRanges(points,
    [&](std::size_t first, std::size_t last)
    {
      bool isPartFinite = true;
      for (std::size_t i = first; i < last; ++i)
      {
        const Vector3 phi(static_cast<double>(mode[3 * i]), static_cast<double>(mode[3 * i + 1]),
          static_cast<double>(mode[3 * i + 2]));
        Eigen::Map<Eigen::Vector3f> u(displacement + 3 * i);
        u += (weight * phi).cast<float>();
        isPartFinite = isPartFinite && u.allFinite();
      }
      if (!isPartFinite)
      {
        isFinite = false;
      }
    });
  return isFinite;
}
} // namespace

ContactField::ContactField(const FieldTriangle& triangle, const AxisymmetricTool& tool,
  const FieldContact& contact, const FieldSettings& settings,
  std::shared_ptr<const LayerKernel>& kernel)
  : Deflection(contact.deflection)
  , Reach(settings.reach)
{
  if (contact.cell < 0 || !(contact.deflection > 0.0))
  {
    return;
  }
  const auto& corners = triangle.corners;
  const Vector3 weights =
    projectOnTriangle(contact.point, corners[0], corners[1], corners[2]).weights;
  this->bend(triangle, weights, contact);
  if (triangle.modes.empty())
  {
    this->Deflection = std::min(this->Deflection, contact.depth);
  }
  this->surround(tool, triangle, weights, contact.force);
  if (this->Deflection > 0.0)
  {
    this->press(tool, triangle, weights, settings.poissonRatio, kernel);
  }
}

void ContactField::bend(
  const FieldTriangle& triangle, const Vector3& weights, const FieldContact& contact)
{
  for (const FieldTriangle::Mode& mode : triangle.modes)
  {
    double here = 0.0; // n·φ at the contact point
    for (std::size_t i = 0; i < 3; ++i)
    {
      here += weights[static_cast<Eigen::Index>(i)] * contact.normal.dot(mode.vectors[i]);
    }
    this->Weights.push_back(-contact.force * mode.sign * here);
    this->Deflection -= contact.force * mode.sign * here * here;
  }
}

void ContactField::surround(
  const AxisymmetricTool& tool, const FieldTriangle& triangle, const Vector3& weights, double force)
{
  std::array<double, NearField::Numbers> sum{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::array<double, NearField::Numbers> corner = numbersOf(triangle.near[i]);
    for (std::size_t k = 0; k < sum.size(); ++k)
    {
      sum[k] += weights[static_cast<Eigen::Index>(i)] * corner[k];
    }
  }
  const NearField near = nearFieldOf(sum);
  const bool isFinite =
    std::all_of(sum.begin(), sum.end(), [](double number) { return std::isfinite(number); });
  if (!isFinite || !(near.radius > 0.0) || !(near.reducedModulus > 0.0) || !(force > 0.0))
  {
    return;
  }
  this->Near = near;
  this->Near.depth *= force;
  this->Near.slope *= force;
  this->Near.bend *= force;
  const double local =
    deflectionOf(tool, force, near.reducedModulus, DeepestDent * this->Deflection);
  this->NearDepth = this->Deflection - local;
  this->Deflection = local;
}

void ContactField::press(const AxisymmetricTool& tool, const FieldTriangle& triangle,
  const Vector3& weights, double poissonRatio, std::shared_ptr<const LayerKernel>& kernel)
{
  const double deflection = this->Deflection;
  double thickness = thicknessAt(triangle.thickness, weights);
  if (!(thickness > 0.0))
  {
    this->Radius = tool.contactRadius(deflection);
    this->Kink = edgeWithin(tool, this->Radius);
    this->Law = [&tool, deflection, poissonRatio](double r)
    { return tool.surfaceDisplacement(r, deflection, poissonRatio); };
    return;
  }
  if (!triangle.stack.layers.empty())
  {
    const LayerStack stack = stackAt(triangle, weights);
    thickness = stack.layers.front().thickness;
    if (!kernel || !kernel->stack() || !(*kernel->stack() == stack))
    {
      kernel = std::make_shared<const LayerKernel>(stack);
    }
  }
  else if (!kernel || kernel->stack() || kernel->poissonRatio() != poissonRatio ||
    kernel->base() != triangle.base)
  {
    kernel = LayerKernel::shared(poissonRatio, triangle.base);
  }
  auto layer = std::make_shared<const LayerContact>(tool, kernel, thickness);
  if (deflection > layer->deepest())
  {
    this->Fault = joined("No field: the layer of ", thickness,
      " mm at the contact is thinner than a tenth of the contact radius");
    return;
  }
  this->Radius = layer->contactRadius(deflection);
  this->Kink = edgeWithin(tool, this->Radius);
  auto surface = std::make_shared<const LayerSurface>(*layer, deflection);
  this->Law = [layer, surface](double r) { return surface->at(r); };
}

SurfaceDisplacement ContactField::local(double r) const
{
  return this->Law ? this->Law(r) : SurfaceDisplacement{ 0.0, 0.0 };
}

double ContactField::near(const Vector3& away) const
{
  if (!(this->Near.radius > 0.0))
  {
    return 0.0;
  }
  const double r = away.norm();
  if (!(r > this->Radius))
  {
    return this->NearDepth;
  }
  const double part = this->Radius / r;
  const double held = 2.0 / Pi * (std::asin(part) - part * std::sqrt(1.0 - part * part)); // 1 - m
  return held * this->NearDepth + (1.0 - held) * this->Near.at(away);
}

double ContactField::fade(double r, double cosine) const
{
  if (!(this->Reach > 0.0))
  {
    return 1.0;
  }
  return smoothStep(CosineOfEnd, CosineOfFade, cosine) *
    (1.0 - smoothStep(FadeBegin * this->Reach, this->Reach, r));
}

bool contactField(const ContactField& field, const Vector3& normal,
  const std::vector<ModeSpan>& modes, SurfacePatch& patch, std::size_t points, float* displacement,
  const SeamCrossing& cross)
{
  bool isFinite = true;
  for (std::size_t k = 0; k < field.modeWeights().size(); ++k)
  {
    const double weight = field.modeWeights()[k];
    const bool isModeFinite = std::visit(
      [&](const auto* mode) { return addMode(mode, weight, points, displacement); }, modes[k]);
    isFinite = isFinite && isModeFinite;
  }
  const auto move =
    [&](std::int32_t id, double distance, const Vector3& away, const Vector3& pointNormal)
  {
    const SurfaceDisplacement u = field.local(distance);
    const double share = field.fade(distance, pointNormal.dot(normal));
    const Vector3 across = away - away.dot(normal) * normal;
    const double near = field.near(distance * across.normalized());
    Eigen::Map<Eigen::Vector3f>(displacement + 3 * static_cast<std::size_t>(id)) +=
      (share * (u.radial * away - (u.normal + near) * normal)).cast<float>();
  };
  do
  {
    patch.visit(move);
  } while (cross && cross(patch));
  return isFinite;
}
} // namespace palpate
