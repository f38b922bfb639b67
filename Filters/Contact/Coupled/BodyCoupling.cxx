// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Coupled/BodyCoupling.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
/// Smallest distance between two contacts, mm; used if the sum of their contact radii is smaller.
constexpr double LeastDistance = 1e-6;

std::vector<CouplingKnot> knotsOf(const CouplingTerms& terms)
{
  return terms.knots ? std::vector<CouplingKnot>(terms.knots, terms.knots + CouplingLaw::KnotCount)
                     : std::vector<CouplingKnot>();
}

bool isPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

std::string faultOfValues(const float* values, std::size_t points, const char* what)
{
  for (std::size_t i = 0; values && i < points; ++i)
  {
    const double value{ values[i] };
    if (!isPositive(value))
    {
      return joined(what, " of point ", i, " must be finite and above 0, but is ", value);
    }
  }
  return {};
}

std::string faultOfModes(const CouplingTerms& terms, std::size_t points)
{
  const auto modes = static_cast<std::size_t>(terms.modeCount);
  for (std::size_t i = 0; terms.modes && i < points * modes; ++i)
  {
    if (!std::isfinite(terms.modes[i]))
    {
      return joined(
        "mode ", i % modes, " of point ", i / modes, " must be finite, but is ", terms.modes[i]);
    }
  }
  return {};
}
} // namespace

std::string faultOfCoupling(const CouplingTerms& terms, std::size_t points)
{
  if (!(terms.modulus >= 0.0) || !std::isfinite(terms.modulus))
  {
    return joined(
      "the reduced modulus must be finite and not negative (MPa), but is ", terms.modulus);
  }
  if (!(terms.thickness >= 0.0) || !std::isfinite(terms.thickness) ||
    (terms.thickness > 0.0) != (terms.knots != nullptr))
  {
    return joined("the thickness must be finite and above 0 (mm) with the ", CouplingLaw::KnotCount,
      " knots of a layer, and 0 without them, but is ", terms.thickness);
  }
  for (int k = 0; terms.knots && k < CouplingLaw::KnotCount; ++k)
  {
    const CouplingKnot& knot = terms.knots[k];
    const double before = k > 0 ? terms.knots[k - 1].ratio : 0.0;
    if (!std::isfinite(knot.share) || !std::isfinite(knot.slope) || !(knot.ratio >= before) ||
      !std::isfinite(knot.ratio))
    {
      return joined("knot ", k,
        " must be finite, with a contact radius that does not decrease, but is (", knot.share, ", ",
        knot.slope, ", ", knot.ratio, ")");
    }
  }
  if (terms.modeCount < 0 || terms.modeCount > CouplingTerms::MostModes)
  {
    return joined(
      "the number of modes must be 0 to ", CouplingTerms::MostModes, ", but is ", terms.modeCount);
  }
  return firstFault([&]
    { return faultOfValues(terms.localModulus, points, "the reduced modulus (MPa)"); },
    [&] { return faultOfValues(terms.localThickness, points, "the thickness (mm)"); },
    [&] { return faultOfModes(terms, points); });
}

BodyCoupling::BodyCoupling(
  const PackedMesh& mesh, const ResponseField& response, const CouplingTerms& terms)
  : Mesh(mesh)
  , Response(response)
  , Law(knotsOf(terms))
  , HasSurface(terms.modulus > 0.0)
  , ModeCount(terms.modes ? static_cast<std::size_t>(terms.modeCount) : 0)
  , Stride(2 + this->ModeCount)
{
  this->Records.resize(this->Stride * mesh.pointCount());
  for (std::size_t i = 0; i < mesh.pointCount(); ++i)
  {
    const auto input = static_cast<std::size_t>(mesh.inputPoint(static_cast<std::int32_t>(i)));
    float* record = this->Records.data() + this->Stride * i;
    record[0] = terms.localModulus ? terms.localModulus[input] : static_cast<float>(terms.modulus);
    record[1] =
      terms.localThickness ? terms.localThickness[input] : static_cast<float>(terms.thickness);
    if (this->ModeCount > 0)
    {
      std::copy_n(terms.modes + this->ModeCount * input, this->ModeCount, record + 2);
    }
  }
}

BodyCoupling::Spot BodyCoupling::at(
  std::int32_t triangle, const Vector3& weights, double stiffness) const noexcept
{
  Spot spot;
  spot.corners = this->Mesh.corners(triangle);
  for (int k = 0; k < 3; ++k)
  {
    const double weight = weights[k];
    const std::int32_t corner = spot.corners[static_cast<std::size_t>(k)];
    const float* record = this->record(corner);
    spot.point += weight * this->Mesh.corner(triangle, k);
    spot.normal += weight * this->Response.normal(corner);
    spot.modulus += weight * static_cast<double>(record[0]);
    spot.thickness += weight * static_cast<double>(record[1]);
    for (std::size_t m = 0; m < this->ModeCount; ++m)
    {
      spot.modes[m] += weight * static_cast<double>(record[2 + m]);
    }
  }
  spot.normalLength = spot.normal.norm();
  spot.normal /= spot.normalLength > 0.0 ? spot.normalLength : 1.0;
  spot.radius =
    this->HasSurface ? this->Law.contactRadius(stiffness, spot.modulus, spot.thickness) : 0.0;
  return spot;
}

BodyCoupling::Surface BodyCoupling::surface(const Spot& one, const Spot& other) const noexcept
{
  Surface result;
  result.facing = one.normal.dot(other.normal);
  if (!this->HasSurface || !(result.facing > 0.0))
  {
    result.facing = 0.0;
    return result;
  }
  const Vector3 apart = one.point - other.point;
  const double distance = apart.norm();
  const double least = std::max(one.radius + other.radius, LeastDistance);
  const bool isHeld = !(distance > least);
  const double r = isHeld ? least : distance;
  const double inverse = 1.0 / (Pi * r * std::sqrt(one.modulus * other.modulus));
  double share = 1.0;
  if (this->Law.isLayered())
  {
    const double x = r / std::sqrt(one.thickness * other.thickness);
    const CouplingLaw::Share at = this->Law.at(x);
    share = at.value;
    result.byDistance = inverse * at.slope * x / r;
    result.byThickness = -0.5 * inverse * at.slope * x;
  }
  result.value = inverse * share;
  result.byDistance = isHeld ? 0.0 : result.byDistance - result.value / r;
  if (!isHeld)
  {
    result.away = apart / r;
  }
  return result;
}

double BodyCoupling::pointForceError(const Spot& one, const Spot& other) const noexcept
{
  if (!this->HasSurface || !(one.normal.dot(other.normal) > 0.0))
  {
    return 0.0;
  }
  const double radii = one.radius + other.radius;
  const double distance = (one.point - other.point).norm();
  const double ratio = distance > radii ? radii / distance : 1.0;
  const double onHalfSpace = 0.0085 * std::pow(ratio, 1.5);
  return this->Law.isLayered() ? onHalfSpace + 0.14 * std::pow(ratio, 4.2) : onHalfSpace;
}

double BodyCoupling::compliance(const Spot& one, const Spot& other) const noexcept
{
  const Surface surface = this->surface(one, other);
  double sum = surface.facing * surface.value;
  for (std::size_t m = 0; m < this->ModeCount; ++m)
  {
    sum += one.modes[m] * other.modes[m];
  }
  return sum;
}

Vector3 BodyCoupling::gradient(
  const Spot& of, std::int32_t triangle, const Spot& other) const noexcept
{
  const Surface surface = this->surface(of, other);
  Vector3 gradient = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const std::int32_t corner = of.corners[static_cast<std::size_t>(k)];
    const float* record = this->record(corner);
    double& by = gradient[k];
    if (surface.facing > 0.0)
    {
      const Vector3 own = this->Response.normal(corner);
      const Vector3 turned = (own - of.normal.dot(own) * of.normal) / of.normalLength;
      by += surface.value * turned.dot(other.normal);
      by += surface.facing * surface.byDistance *
        surface.away.dot(this->Mesh.corner(triangle, k) - of.point);
      by -= 0.5 * surface.facing * surface.value * static_cast<double>(record[0]) / of.modulus;
      if (this->Law.isLayered())
      {
        by += surface.facing * surface.byThickness * static_cast<double>(record[1]) / of.thickness;
      }
    }
    for (std::size_t m = 0; m < this->ModeCount; ++m)
    {
      by += static_cast<double>(record[2 + m]) * other.modes[m];
    }
  }
  return gradient;
}
} // namespace palpate
