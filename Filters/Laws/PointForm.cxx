// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/PointForm.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Weight of a regularization that keeps the tilt small if few directions determine it.
constexpr double LeastTilt = 0.3;
/// Smallest eigenvalue of the products, relative to the sum of weights. A smaller eigenvalue means
/// that there are fewer than three distinct directions.
constexpr double LeastSpread = 1e-3;
} // namespace

TangentFrame::TangentFrame(const Vector3d& normal)
  : first(normal.unitOrthogonal())
  , second(normal.cross(this->first))
{
}

PointFormSums::PointFormSums(const Vector3d& normal)
  : Normal(normal)
  , Frame(normal)
{
}

void PointFormSums::add(const Vector3d& edge, const Vector3d& turn)
{
  const double t = edge.dot(this->Frame.first);
  const double u = edge.dot(this->Frame.second);
  const double flat = t * t + u * u;
  const double weight = edge.squaredNorm(); // the error of a normal has more effect on a short edge
  const double turned = edge.dot(turn) / weight;
  const double sagged = -2.0 * edge.dot(this->Normal) / weight;
  if (!(flat > 0.0) || !std::isfinite(turned))
  {
    return;
  }
  const Vector3d row = Vector3d(t * t, 2.0 * t * u, u * u) / flat;
  this->Products += weight * row * row.transpose();
  this->Turns += weight * turned * row;
  this->Sags += weight * sagged * row;
  this->Square += weight * turned * turned;
  this->Weight += weight;
  this->Count += 1.0;
  // A tilt of the normal changes the curvature by a sag. The change is twice the component of the
  // tilt along the edge, divided by the length of the edge.
  const Eigen::Vector2d along = -2.0 / std::sqrt(flat) * Eigen::Vector2d(t, u);
  const double length = std::sqrt(weight);
  this->Mixed += length * row * along.transpose();
  this->Tilts += along * along.transpose();
  this->TiltSags += length * sagged * along;
}

/// Fits the form to the sags together with a small tilt of the tangent plane, because a normal
/// computed from few triangles is inexact.
Vector3d PointFormSums::sagForm() const
{
  const Eigen::Matrix2d tilts = this->Tilts + LeastTilt * this->Count * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, 3, 2> share = this->Mixed * tilts.inverse();
  const Matrix3d reduced = this->Products - share * this->Mixed.transpose();
  return reduced.ldlt().solve(this->Sags - share * this->TiltSags);
}

PointForm PointFormSums::fit() const
{
  if (this->Weight == 0.0)
  {
    return {};
  }
  const double edgeSquare = this->Weight / this->Count;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> spread(this->Products, Eigen::EigenvaluesOnly);
  if (!(spread.eigenvalues()[0] > LeastSpread * this->Weight))
  {
    // t² + u² = 1. Therefore the sum of the first and the last product is the sum of the
    // curvatures.
    const auto mean = [this](const Vector3d& sums) -> Vector3d
    { return (sums[0] + sums[2]) / this->Weight * Vector3d(1.0, 0.0, 1.0); };
    return { mean(this->Turns), mean(this->Sags), 2.0 * std::sqrt(this->Square / this->Weight),
      edgeSquare };
  }
  const Vector3d form = this->Products.ldlt().solve(this->Turns);
  const double left = std::max(0.0, this->Square - form.dot(this->Turns)) / this->Weight;
  return { form, this->sagForm(), std::sqrt(left), edgeSquare };
}
} // namespace palpate
