// SPDX-License-Identifier: BSD-3-Clause
#include "SplitReference.h"

#include "Mechanics/Numerics/Constants.h"
#include "LoveSquare.h"
#include "Mechanics/SeriesCompliance.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace palpate::testing
{
namespace
{
/// Squares are placed up to this multiple of the expected contact radius, and farther if the
/// contact extends beyond it.
constexpr double Margin = 1.25;
/// Tolerance relative to the depth: the iteration of the depth correction ends below it.
constexpr double Settled = 1e-7;

/// The four values of cubic Lagrange interpolation at 0 <= t <= 3 between nodes 0, 1, 2, 3.
std::array<double, 4> cubic(double t)
{
  return { (1.0 - t) * (2.0 - t) * (3.0 - t) / 6.0, t * (2.0 - t) * (3.0 - t) / 2.0,
    t * (t - 1.0) * (3.0 - t) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0 };
}

/// Solves for the depth at which the force of the tool on a half-space has this value, from a first
/// guess.
double depthOfForce(const AxisymmetricTool& tool, double modulus, double force, double depth)
{
  for (int i = 0; i < 100; ++i)
  {
    const IndentationPoint at = tool.evaluate(depth, modulus);
    const double next = std::max(depth - (at.force - force) / at.stiffness, 0.1 * depth);
    if (std::abs(next - depth) < 1e-14 * depth)
    {
      return next;
    }
    depth = next;
  }
  return depth;
}
} // namespace

SplitReference::SplitReference(FiniteBodyPointer body, ToolPointer tool, int squares)
  : Body(std::move(body))
  , Tool(std::move(tool))
  , Across(squares)
{
  this->Body->globalCompliances();
  this->Body->regular();
}

std::size_t SplitReference::bytes() const
{
  return sizeof(double) *
    (static_cast<std::size_t>(this->Body->regular().size()) +
      this->Body->globalCompliances().size());
}

bool SplitReference::layOut(const Vector3& tip, double side, double extent)
{
  const FiniteBody& body = *this->Body;
  this->Middles.clear();
  std::vector<std::array<int, 2>> at;
  const auto half = static_cast<int>(std::ceil(extent / side));
  for (int j = -half; j < half; ++j)
  {
    for (int i = -half; i < half; ++i)
    {
      const Eigen::Vector2d middle(side * (i + 0.5), side * (j + 0.5));
      if (middle.norm() <= extent && std::isfinite(this->Tool->profile(middle.norm())))
      {
        this->Middles.push_back(middle);
        at.push_back({ i, j });
      }
    }
  }
  const auto count = static_cast<int>(this->Middles.size());
  Eigen::MatrixXd table(2 * half, 2 * half);
  const double scale = 1.0 / (Pi * body.scene().reducedModulus * side);
  for (int j = 0; j < 2 * half; ++j)
  {
    for (int i = 0; i < 2 * half; ++i)
    {
      table(i, j) = scale * loveSquare(i, j);
    }
  }
  this->Local.resize(count, count);
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i < count; ++i)
    {
      const auto& a = at[static_cast<std::size_t>(i)];
      const auto& b = at[static_cast<std::size_t>(j)];
      this->Local(i, j) = table(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
    }
  }

  const int coarse = body.coarseSide();
  const double spacing = body.coarseStride() * body.mesh().spacing;
  std::vector<Eigen::Triplet<double>> weights;
  for (int square = 0; square < count; ++square)
  {
    std::array<int, 2> first{};
    std::array<std::array<double, 4>, 2> values{};
    for (int axis = 0; axis < 2; ++axis)
    {
      const double place =
        (tip[axis] + this->Middles[static_cast<std::size_t>(square)][axis] + body.mesh().window) /
        spacing;
      if (!(place >= 0.0 && place <= coarse - 1))
      {
        return false;
      }
      const auto k = static_cast<std::size_t>(axis);
      first[k] = std::clamp(static_cast<int>(place) - 1, 0, coarse - 4);
      values[k] = cubic(place - first[k]);
    }
    for (int n = 0; n < 4; ++n)
    {
      for (int m = 0; m < 4; ++m)
      {
        weights.emplace_back(square, (first[1] + n) * coarse + first[0] + m,
          values[0][static_cast<std::size_t>(m)] * values[1][static_cast<std::size_t>(n)]);
      }
    }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> blend(count, coarse * coarse);
  blend.setFromTriplets(weights.begin(), weights.end());
  const Eigen::MatrixXd half1 = blend * body.regular();
  this->Whole = this->Local + half1 * blend.transpose();
  return true;
}

void SplitReference::press(
  const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces)
{
  const auto count = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd dense(count, count);
  Eigen::VectorXd right(count);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    for (Eigen::Index i = 0; i < count; ++i)
    {
      dense(i, j) =
        (*this->Matrix)(active[static_cast<std::size_t>(i)], active[static_cast<std::size_t>(j)]);
    }
    right[j] = wanted[active[static_cast<std::size_t>(j)]];
  }
  const Eigen::VectorXd found = dense.llt().solve(right);
  forces.setZero();
  for (Eigen::Index j = 0; j < count; ++j)
  {
    forces[active[static_cast<std::size_t>(j)]] = found[j];
  }
}

void SplitReference::move(
  const std::vector<int>&, const Eigen::VectorXd& forces, Eigen::VectorXd& moved)
{
  moved = *this->Matrix * forces;
}

double SplitReference::pressed(const Eigen::MatrixXd& matrix, double depth)
{
  Eigen::VectorXd wanted(static_cast<Eigen::Index>(this->Middles.size()));
  for (std::size_t i = 0; i < this->Middles.size(); ++i)
  {
    wanted[static_cast<Eigen::Index>(i)] = depth - this->Tool->profile(this->Middles[i].norm());
  }
  this->Matrix = &matrix;
  Eigen::VectorXd forces;
  if (!this->Contact.solve(*this, wanted, this->Active, forces))
  {
    return NotANumber;
  }
  this->Outermost = 0.0;
  for (const int i : this->Active)
  {
    this->Outermost = std::max(this->Outermost, this->Middles[static_cast<std::size_t>(i)].norm());
  }
  return forces.sum();
}

double SplitReference::solve(const Vector3& tip, double depth, double radius)
{
  const double modulus = this->Body->scene().reducedModulus;
  const double side = 2.0 * radius / this->Across;
  const double extent = Margin * radius;
  if (!this->layOut(tip, side, extent))
  {
    return NotANumber;
  }
  this->Active.clear();
  for (std::size_t i = 0; i < this->Middles.size(); ++i)
  {
    if (this->Middles[i].norm() <= radius)
    {
      this->Active.push_back(static_cast<int>(i));
    }
  }
  double missed = 0.0;
  for (int i = 0; i < 20; ++i)
  {
    const double force = this->pressed(this->Whole, depth - missed);
    const bool reached = this->Outermost > extent - 1.5 * side;
    if (reached && std::isfinite(this->Tool->profile(extent + side)))
    {
      return this->solve(tip, depth, Margin * radius); // the contact is wider than the squares
    }
    const double local = depthOfForce(*this->Tool, modulus, force, depth);
    const double coarse = this->pressed(this->Local, local);
    const double last = missed;
    missed = (coarse - force) / this->Tool->stiffness(local, modulus);
    if (!(std::abs(missed - last) > Settled * depth))
    {
      return force;
    }
  }
  return NotANumber;
}

Vector3 SplitReference::force(const Vector3& tip)
{
  const double depth = -tip.z();
  if (!(depth > 0.0))
  {
    return Vector3::Zero();
  }
  const double compliance = this->Body->globalCompliance(tip.x(), tip.y());
  const SeriesPoint guess =
    seriesResponse(*this->Tool, this->Body->scene().reducedModulus, compliance, depth);
  const double radius = this->Tool->contactRadius(guess.stable ? guess.localDeflection : depth);
  const double force = std::isfinite(radius) ? this->solve(tip, depth, radius) : NotANumber;
  return std::isfinite(force) ? Vector3(0.0, 0.0, force)
                              : Vector3(NotANumber, NotANumber, NotANumber);
}

} // namespace palpate::testing
