// SPDX-License-Identifier: BSD-3-Clause
#include "FullSolve.h"

namespace palpate::testing
{
namespace
{
/// Tolerance relative to the largest wanted motion. It is below the threshold by which
/// UnilateralContact distinguishes a gap from rounding.
constexpr double Residual = 1e-10;
constexpr int MostGradients = 500;
} // namespace

void FullSolve::move(
  const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved)
{
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(this->body().windowNodes());
  for (const int i : active)
  {
    loads[this->candidates()[static_cast<std::size_t>(i)]] = forces[i];
  }
  const Eigen::VectorXd motion = this->body().solve(loads);
  ++this->Solutions;
  moved.resize(forces.size());
  for (Eigen::Index i = 0; i < moved.size(); ++i)
  {
    moved[i] = motion[this->candidates()[static_cast<std::size_t>(i)]];
  }
}

void FullSolve::press(
  const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces)
{
  // All vectors are zero except at the active nodes.
  Eigen::VectorXd onActive = Eigen::VectorXd::Zero(wanted.size());
  for (const int i : active)
  {
    onActive[i] = 1.0;
  }
  forces = forces.cwiseProduct(onActive);
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(wanted.size());
  if (forces.cwiseAbs().maxCoeff() > 0.0)
  {
    this->move(active, forces, moved);
  }
  Eigen::VectorXd residual = (wanted - moved).cwiseProduct(onActive);
  Eigen::VectorXd direction = residual;
  double square = residual.squaredNorm();
  const double enough = Residual * wanted.maxCoeff();
  for (int step = 0; step < MostGradients && residual.cwiseAbs().maxCoeff() > enough; ++step)
  {
    this->move(active, direction, moved);
    moved = moved.cwiseProduct(onActive);
    const double length = square / direction.dot(moved);
    forces += length * direction;
    residual -= length * moved;
    const double next = residual.squaredNorm();
    direction = residual + next / square * direction;
    square = next;
  }
}

} // namespace palpate::testing
