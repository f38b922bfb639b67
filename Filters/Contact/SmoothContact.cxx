// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/SmoothContact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
using Matrix2 = Eigen::Matrix2d;

/// Newton's method ends after a step of the parameters below this value. The remaining error is of
/// the order of the square of the step.
constexpr double LastStep = 1e-6;
/// A minimum beyond an edge by at most this value counts as a minimum on the edge.
constexpr double OnEdge = 1e-9;

/// Derivatives of half the squared distance to the surface with respect to the parameters.
struct Distance
{
  Eigen::Vector2d slope;
  /// If the Hessian is not that of a minimum, a multiple of the metric is added to it, so that the
  /// step reduces the distance.
  Matrix2 hessian;
  bool isConvex;

  Distance(const SurfaceJet& jet, const Vector3& tip) noexcept
  {
    const Vector3 offset = jet.point - tip;
    const double vv = jet.dv.squaredNorm();
    const double vw = jet.dv.dot(jet.dw);
    const double ww = jet.dw.squaredNorm();
    double hvv = vv + jet.dvv.dot(offset);
    double hvw = vw + jet.dvw.dot(offset);
    double hww = ww + jet.dww.dot(offset);
    const double metric = vv * ww - vw * vw;
    const double share = (hvv * hww - hvw * hvw) / metric;
    isConvex = hvv > 0.0 && share > SmoothContact::FocalShare;
    if (!isConvex)
    {
      const double halfTrace = 0.5 * (hvv * ww + hww * vv - 2.0 * hvw * vw) / metric;
      const double least =
        halfTrace - std::sqrt(std::max(0.0, halfTrace * halfTrace - share)); // equals 1 - δ/R
      constexpr double enough = 0.25;
      hvv += (enough - least) * vv;
      hvw += (enough - least) * vw;
      hww += (enough - least) * ww;
    }
    slope = { jet.dv.dot(offset), jet.dw.dot(offset) };
    hessian << hvv, hvw, hvw, hww;
  }

  Matrix2 inverse() const noexcept
  {
    const double determinant = hessian(0, 0) * hessian(1, 1) - hessian(0, 1) * hessian(0, 1);
    Matrix2 result;
    result << hessian(1, 1), -hessian(0, 1), -hessian(0, 1), hessian(0, 0);
    return result / determinant;
  }
};

/// Returns the changes of the three area coordinates for a change of the two parameters.
Vector3 asWeights(const Eigen::Vector2d& step)
{
  return { -step[0] - step[1], step[0], step[1] };
}

/// Returns whether a point is close enough to the triangle for the search. Weights may leave the
/// triangle slightly, but less near corners, where the patch ends.
bool isNearby(const Vector3& weights)
{
  Eigen::Index least = 0;
  const double smallest = weights.minCoeff(&least);
  const double other = std::min(weights[(least + 1) % 3], weights[(least + 2) % 3]);
  return smallest >= 0.0 || -smallest <= 0.25 * other;
}

Vector3 clamped(const Vector3& weights)
{
  const Vector3 positive = weights.cwiseMax(0.0);
  return positive / positive.sum();
}
} // namespace

/// Whether the triangle is folded and its normals are the means of the triangles around its
/// corners. Other normals are those of a surface that the user means to be round.
bool SmoothContact::isFlat(std::int32_t triangle) const noexcept
{
  constexpr double leastCosine = 0.99; // 8°: means with other weights are closer than that
  const auto& corners = this->Mesh.corners(triangle);
  return this->Mesh.isFolded(triangle) &&
    std::all_of(corners.begin(), corners.end(),
      [this](std::int32_t point)
      { return this->Response.normal(point).dot(this->Mesh.pointNormal(point)) > leastCosine; });
}

bool SmoothContact::load(std::int32_t triangle) noexcept
{
  if (triangle != this->Loaded)
  {
    const auto& corners = this->Mesh.corners(triangle);
    this->Loaded = triangle;
    this->IsSound = !this->isFlat(triangle) &&
      this->Patch.build({ this->Mesh.corner(triangle, 0), this->Mesh.corner(triangle, 1),
                          this->Mesh.corner(triangle, 2) },
        { this->Response.normal(corners[0]), this->Response.normal(corners[1]),
          this->Response.normal(corners[2]) });
  }
  return this->IsSound;
}

/// State of the search for the closest point.
class SmoothContact::Descent
{
public:
  Descent(SmoothContact& contact, const Vector3& tip, std::int32_t triangle, const Vector3& weights)
    : Contact(contact)
    , Tip(tip)
    , Triangle(triangle)
    , Weights(isNearby(weights) ? weights : clamped(weights))
  {
  }

  SmoothPoint run() noexcept
  {
    for (int i = 0; i < MaximumSteps && this->Contact.load(this->Triangle); ++i)
    {
      this->Jet = this->Contact.Patch.evaluate(this->Weights);
      const Distance distance(this->Jet, this->Tip);
      const Eigen::Vector2d step = -(distance.inverse() * distance.slope);
      if (!step.allFinite())
      {
        break;
      }
      const Vector3 next = this->Weights + asWeights(step);
      const bool isLast = step.cwiseAbs().maxCoeff() < LastStep;
      if (isLast && next.minCoeff() >= -OnEdge)
      {
        return this->finish(distance, step);
      }
      if (this->HeldEdge < 0 && !isLast && isNearby(next))
      {
        this->Weights = next;
      }
      else if (!this->leave(distance, next, isLast))
      {
        return this->Result;
      }
    }
    return this->Result;
  }

private:
  SmoothPoint finish(const Distance& distance, const Eigen::Vector2d& step) const noexcept
  {
    return distance.isConvex ? this->describe(SmoothPoint::Outcome::Found, distance, step)
                             : SmoothPoint{};
  }

  /// Sets the result. The last step needs no new derivatives, because its remaining error is of the
  /// order of its square.
  SmoothPoint describe(SmoothPoint::Outcome outcome, const Distance& distance,
    const Eigen::Vector2d& step) const noexcept
  {
    SmoothPoint found;
    found.outcome = outcome;
    ContactPlace& place = found.place;
    place.isSmooth = true;
    place.triangle = this->Triangle;
    place.projection.weights = clamped(this->Weights + asWeights(step));
    const SurfaceJet& jet = this->Jet;
    place.projection.point = jet.point + step[0] * jet.dv + step[1] * jet.dw;
    const Vector3 dv = jet.dv + step[0] * jet.dvv + step[1] * jet.dvw;
    const Vector3 dw = jet.dw + step[0] * jet.dvw + step[1] * jet.dww;
    place.normal = dv.cross(dw).normalized();
    place.signedDistance = (this->Tip - place.projection.point).dot(place.normal);
    const Matrix2 inverse = distance.inverse();
    place.weightGradients.col(1) = inverse(0, 0) * dv + inverse(0, 1) * dw;
    place.weightGradients.col(2) = inverse(1, 0) * dv + inverse(1, 1) * dw;
    place.weightGradients.col(0) = -place.weightGradients.col(1) - place.weightGradients.col(2);
    return found;
  }

  /// Moves towards `next` up to the first edge, and to the triangle across this edge. Returns false
  /// if the search ends at the edge.
  bool leave(const Distance& distance, const Vector3& next, bool isMinimum) noexcept
  {
    if (this->HeldEdge >= 0)
    {
      return this->slide(distance);
    }
    const auto [corner, share] = this->firstEdge(next);
    const int edge = (corner + 1) % 3;
    const std::int32_t across = this->Contact.Mesh.neighbour(this->Triangle, edge);
    if (across == PackedMesh::Seam)
    {
      return false;
    }
    Vector3 at = this->Weights + share * (next - this->Weights);
    at[corner] = 0.0;
    at = clamped(at);
    const bool isBack = across == this->Previous && (this->IsSettled || !isMinimum);
    if (across < 0 || isBack)
    {
      this->HeldEdge = edge;
      this->Weights = at;
      return true;
    }
    this->cross(across, edge, at);
    this->IsSettled = isMinimum;
    return true;
  }

  /// Moves along an edge to the minimum on this edge, if the search leads to the edge from both
  /// sides or if the edge is a border. At that minimum, both sides agree (except for rounding) on
  /// the triangle in which the search continues.
  bool slide(const Distance& distance) noexcept
  {
    const int edge = this->HeldEdge;
    Vector3 along = Vector3::Zero();
    along[edge] = -1.0;
    along[(edge + 1) % 3] = 1.0;
    const Eigen::Vector2d direction = along.tail<2>();
    const double step =
      -direction.dot(distance.slope) / direction.dot(distance.hessian * direction);
    const Vector3 next = clamped(this->Weights + step * along);
    const Vector3 change = next - this->Weights;
    if (change.cwiseAbs().maxCoeff() >= LastStep)
    {
      this->Weights = next;
      return true;
    }
    this->HeldEdge = -1;
    const int corner = (edge + 2) % 3;
    const Eigen::Vector2d whole = -(distance.inverse() * distance.slope);
    if (asWeights(whole)[corner] >= 0.0)
    {
      return true; // the minimum is inside the triangle
    }
    const std::int32_t across = this->Contact.Mesh.neighbour(this->Triangle, edge);
    if (across < 0)
    {
      this->Result = this->describe(
        across == PackedMesh::Crease ? SmoothPoint::Outcome::Crease : SmoothPoint::Outcome::Border,
        distance, change.tail<2>());
      this->Result.place.onCrease = across == PackedMesh::Crease;
      this->Result.place.onBorder = across != PackedMesh::Crease;
      return false;
    }
    if (this->IsSettled)
    {
      if (whole.cwiseAbs().maxCoeff() < LastStep)
      {
        this->Result = this->finish(distance, change.tail<2>());
      }
      return false; // not found: the search alternates between two sides that are not convex
    }
    this->cross(across, edge, next);
    this->IsSettled = true;
    return true;
  }

  struct Exit
  {
    int corner; ///< corner opposite the edge
    double share;
  };
  /// Returns the fraction of the step to `next` at which the first weight becomes 0. Weights that
  /// are already negative come first.
  Exit firstEdge(const Vector3& next) const noexcept
  {
    Exit first{ 0, 2.0 };
    for (int k = 0; k < 3; ++k)
    {
      if (next[k] < 0.0 && (next[k] < this->Weights[k] || this->Weights[k] < 0.0))
      {
        const double share = this->Weights[k] > 0.0
          ? this->Weights[k] / (this->Weights[k] - next[k])
          : std::min(0.0, this->Weights[k]);
        if (share < first.share)
        {
          first = { k, share };
        }
      }
    }
    first.share = std::max(first.share, 0.0);
    return first;
  }

  /// Converts the point to the area coordinates of the neighbouring triangle.
  void cross(std::int32_t across, int edge, const Vector3& at) noexcept
  {
    const TriangleCorners& from = this->Contact.Mesh.corners(this->Triangle);
    const TriangleCorners& to = this->Contact.Mesh.corners(across);
    this->Weights.setZero();
    for (int k = 0; k < 3; ++k)
    {
      for (const int end : { edge, (edge + 1) % 3 })
      {
        if (to[static_cast<std::size_t>(k)] == from[static_cast<std::size_t>(end)])
        {
          this->Weights[k] = at[end];
        }
      }
    }
    this->Previous = this->Triangle;
    this->Triangle = across;
  }

  SmoothContact& Contact;
  const Vector3& Tip;
  std::int32_t Triangle;
  std::int32_t Previous = -1; ///< the triangle before the current one
  bool IsSettled = false;     ///< whether the minimum is known not to be in Previous
  int HeldEdge = -1; ///< the edge to which the search is confined; -1 if it is not confined
  Vector3 Weights;
  SurfaceJet Jet;
  SmoothPoint Result;
};

SmoothPoint SmoothContact::follow(
  const Vector3& tip, std::int32_t triangle, const Vector3& weights) noexcept
{
  return Descent(*this, tip, triangle, weights).run();
}
} // namespace palpate
