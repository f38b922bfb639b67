// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Tilt/ContactTilt.h"

#include "Mechanics/Numerics/IncreasingRoot.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Largest rotation of a tool in one tick, rad. The distance of the followed point from the tip
/// includes an allowance for this rotation.
constexpr double MostTurn = 0.035;
/// Below this angle (rad) the axis counts as parallel to the normal, because the direction of the
/// tilt is uncertain.
constexpr double Upright = 1e-9;

Vector3 sumOfNormals(
  const TriangleCorners& corners, const Vector3& weights, const ResponseField& response) noexcept
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    sum += weights[static_cast<Eigen::Index>(k)] * response.normal(corners[k]);
  }
  return sum;
}

/// Returns the angle between two unit vectors; exact also for small angles.
double angleBetween(const Vector3& a, const Vector3& b) noexcept
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}
} // namespace

[[gnu::hot]] Vector3 ContactTilt::follow(const ToolPose& pose, bool isFollowed) noexcept
{
  this->IsFelt = this->Body && pose.hasAxis();
  if (!this->IsFelt)
  {
    return pose.tip;
  }
  this->Axis = pose.axis;
  const TiltTable& table = this->Body->table();
  const double largest = table.terms().largest;
  if (isFollowed && !this->Normal.isZero(0.0))
  {
    this->Down = -this->Normal;
    this->Under =
      table.deepest(std::min(angleBetween(this->Axis, this->Normal) + MostTurn, largest)).drop;
  }
  else
  {
    this->Normal.setZero();
    this->Down = -this->Axis;
    this->Under = this->Body->largestDrop() / std::cos(largest);
  }
  return pose.tip + this->Under * this->Down;
}

double ContactTilt::leanAt(
  const TriangleCorners& corners, const Vector3& weights, const ResponseField& response) noexcept
{
  const Vector3 sum = sumOfNormals(corners, weights, response);
  this->NormalLength = sum.norm();
  if (!(this->NormalLength > 0.0))
  {
    this->NormalLength = 1.0;
    // The sum of opposite normals is zero: the tool is treated as upright.
    this->Normal = this->Axis;
  }
  else
  {
    this->Normal = sum / this->NormalLength;
  }
  this->Angle = angleBetween(this->Axis, this->Normal);
  this->Deepest = this->Body->table().deepest(this->Angle);
  return -this->Under * this->Down.dot(this->Normal) - this->Deepest.drop;
}

void ContactTilt::changeGradients(Eigen::Matrix3d& weightGradients, const TriangleCorners& corners,
  const ResponseField& response) const noexcept
{
  // The followed point is p = tip - e n(p). Therefore a displacement of the tip is (1 + e dn/dp)
  // times a displacement of p.
  Eigen::Matrix3d turning = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    turning +=
      response.normal(corners[k]) * weightGradients.col(static_cast<Eigen::Index>(k)).transpose();
  }
  turning = (turning - this->Normal * (this->Normal.transpose() * turning)) / this->NormalLength;
  const Eigen::Matrix3d step = Eigen::Matrix3d::Identity() + this->Under * turning;
  Eigen::Matrix3d inverse;
  bool isInvertible = false;
  step.computeInverseWithCheck(inverse, isInvertible, 1e-3);
  if (isInvertible)
  {
    weightGradients = (inverse.transpose() * weightGradients).eval();
  }
}

Jet ContactTilt::factor(const TriangleCorners& corners, const Vector3& weights, double depth,
  const Eigen::Matrix3d* weightGradients) const noexcept
{
  const BodyTilt::Weights laws = this->Body->weights(corners, weights);
  const TiltFactor tau = this->Body->table().at(depth, this->Angle, laws.data());
  Jet factor{ tau.value, tau.byDepth, tau.byDepthTwice, tau.byAngle };
  for (std::size_t k = 0; weightGradients && this->Body->isPerPoint() && k < 3; ++k)
  {
    const BodyTilt::Weights own = this->Body->weights(corners[k]);
    factor.byPlace += this->Body->table().at(depth, this->Angle, own.data()).value *
      weightGradients->col(static_cast<Eigen::Index>(k));
  }
  return factor;
}

ContactTilt::Alike ContactTilt::findAlike(
  const BlendedResponse& curve, double depth, const ResponseValue& tilted) const noexcept
{
  constexpr int doublings = 16;
  double most = depth;
  for (int i = 0; i < doublings && curve.evaluate(most).force < tilted.force; ++i)
  {
    most *= 2.0;
  }
  Alike same;
  same.depth = increasingRoot(
    [&](double at) -> ValueAndSlope
    {
      const ResponseValue value = curve.evaluate(at);
      return { value.force - tilted.force, value.stiffness };
    },
    0.0, most, depth);
  same.value = curve.evaluate(same.depth);
  same.stiffening = same.value.stiffness > 0.0 ? tilted.stiffness / same.value.stiffness : 1.0;
  return same;
}

void ContactTilt::addMoment(double byTilt, const TriangleCorners& corners,
  const Eigen::Matrix3d* weightGradients, const ResponseField& response,
  Contact& result) const noexcept
{
  if (this->Body->table().isBeyond(this->Angle) && result.state == ContactState::Slide)
  {
    result.state = ContactState::TiltedTooFar;
  }
  result.tilt = this->Angle;
  const double sine = std::sin(this->Angle);
  if (!(sine > Upright))
  {
    return;
  }
  // Moment M about the tip, N mm.
  const double moment = result.normalForce * this->Deepest.offset + byTilt;
  result.torque = moment / sine * this->Axis.cross(this->Normal);
  if (!weightGradients)
  {
    return;
  }
  // cos θ = axis · n, n = Σ n_i U_i/|Σ n_i U_i|.
  const double cosine = this->Axis.dot(this->Normal);
  Vector3 gradient = Vector3::Zero(); // gradient of cos θ
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 normal = response.normal(corners[k]);
    gradient += (this->Axis.dot(normal) - cosine * this->Normal.dot(normal)) *
      weightGradients->col(static_cast<Eigen::Index>(k));
  }
  result.force += moment / (sine * this->NormalLength) * gradient;
}
} // namespace palpate
