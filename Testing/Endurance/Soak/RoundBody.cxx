// SPDX-License-Identifier: BSD-3-Clause
#include "RoundBody.h"

#include "SampleBodies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate::endurance
{
namespace
{
constexpr double Waves = 6.0; ///< per radian

/// Ratio of the body's radius to the ellipsoid's radius, minus 1, in a unit direction; to be
/// multiplied by the height of the waves.
double wave(const Vector3& u)
{
  return std::sin(Waves * u.x()) * std::sin(Waves * u.y()) * std::cos(Waves * u.z());
}

Vector3 waveGradient(const Vector3& u)
{
  const Vector3 s = (Waves * u).array().sin();
  const Vector3 c = (Waves * u).array().cos();
  return Waves * Vector3(c.x() * s.y() * c.z(), s.x() * c.y() * c.z(), -s.x() * s.y() * s.z());
}
} // namespace

RoundBody::RoundBody(const BodyForm& form, int times)
{
  const palpate::testing::Surface unit = palpate::testing::icosphere(1.0, times);
  const double radius = form.halfAxes.mean();
  const double height = form.bumps / radius;
  for (const Vector3& u : unit.points)
  {
    // x = (1 + h w(u)) D u. Its normal is D⁻¹ (u (1 + h w) - h P∇w); P is the projection
    // perpendicular to u.
    const double stretch = 1.0 + height * wave(u);
    const Vector3 gradient = waveGradient(u);
    const Vector3 along = gradient - u * u.dot(gradient);
    this->Points.push_back(form.centre + stretch * form.halfAxes.cwiseProduct(u));
    this->Normals.push_back(
      (stretch * u - height * along).cwiseQuotient(form.halfAxes).normalized());
    this->Moduli.push_back(
      form.modulus * (1.0 + form.variation * std::sin(3.0 * u.x()) * std::cos(4.0 * u.y())));
  }
  this->Triangles = unit.triangles;
  for (const auto& t : this->Triangles)
  {
    Vector3 middle = Vector3::Zero();
    for (const std::int32_t corner : t)
    {
      middle += this->Points[static_cast<std::size_t>(corner)] / 3.0;
    }
    double reach = 0.0;
    for (const std::int32_t corner : t)
    {
      reach = std::max(reach, (this->Points[static_cast<std::size_t>(corner)] - middle).norm());
    }
    this->Middles.push_back(middle);
    this->Radii.push_back(reach);
  }
}

/// Returns the nearest point of a triangle: the nearest point of its plane if that point is inside
/// the triangle, otherwise the nearest point of its sides.
RoundBody::Foot RoundBody::foot(
  const Vector3& tip, const std::array<std::int32_t, 3>& triangle) const
{
  std::array<Vector3, 3> p;
  for (std::size_t k = 0; k < 3; ++k)
  {
    p[k] = this->Points[static_cast<std::size_t>(triangle[k])];
  }
  const Vector3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
  const double area = normal.squaredNorm();
  Foot best;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3& next = p[(k + 1) % 3];
    const Vector3& last = p[(k + 2) % 3];
    best.weights[static_cast<Eigen::Index>(k)] = normal.dot((last - next).cross(tip - next)) / area;
  }
  if (best.weights.minCoeff() >= 0.0)
  {
    best.point = best.weights[0] * p[0] + best.weights[1] * p[1] + best.weights[2] * p[2];
    best.distance = (tip - best.point).norm();
    return best;
  }
  best.distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 side = p[(k + 1) % 3] - p[k];
    const double along = std::clamp(side.dot(tip - p[k]) / side.squaredNorm(), 0.0, 1.0);
    const Vector3 point = p[k] + along * side;
    const double distance = (tip - point).norm();
    if (distance < best.distance)
    {
      best.distance = distance;
      best.point = point;
      best.weights.setZero();
      best.weights[static_cast<Eigen::Index>(k)] = 1.0 - along;
      best.weights[static_cast<Eigen::Index>((k + 1) % 3)] = along;
    }
  }
  return best;
}

std::vector<RoundBody::Touch> RoundBody::touch(const Vector3& tip) const
{
  double most =
    std::numeric_limits<double>::infinity(); // upper bound of the distance of the nearest point
  for (std::size_t i = 0; i < this->Middles.size(); ++i)
  {
    most = std::min(most, (tip - this->Middles[i]).squaredNorm());
  }
  most = std::sqrt(most);
  std::vector<std::pair<std::size_t, Foot>> near;
  for (std::size_t i = 0; i < this->Middles.size(); ++i)
  {
    const double reach = most + this->Radii[i] + NearestTolerance;
    if ((tip - this->Middles[i]).squaredNorm() <= reach * reach)
    {
      near.emplace_back(i, this->foot(tip, this->Triangles[i]));
      most = std::min(most, near.back().second.distance);
    }
  }
  std::vector<Touch> touches;
  for (const auto& [index, foot] : near)
  {
    if (foot.distance > most + NearestTolerance)
    {
      continue;
    }
    Touch touch;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto corner = static_cast<std::size_t>(this->Triangles[index][k]);
      touch.normal += foot.weights[static_cast<Eigen::Index>(k)] * this->Normals[corner];
      touch.modulus += foot.weights[static_cast<Eigen::Index>(k)] * this->Moduli[corner];
    }
    touch.normal.normalize();
    // The edges and corners of the bodies are blunt: there the direction to the tip is within about
    // 0.2 rad of the normals.
    touch.depth = (tip - foot.point).dot(touch.normal) < 0.0 ? foot.distance : -foot.distance;
    touches.push_back(touch);
  }
  return touches;
}
} // namespace palpate::endurance
