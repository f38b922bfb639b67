// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/SmoothTriangle.h"

#include <Eigen/Geometry>

#include <cmath>

namespace palpate
{
namespace
{
using Vector4 = Eigen::Vector4d;

Vector4 padded(const Vector3& v)
{
  return { v.x(), v.y(), v.z(), 0.0 };
}

/// One step of de Casteljau's algorithm: from the control points of `order` to those of order-1.
template <int order>
void cut(const Vector4* from, const Vector3& u, Vector4* to) noexcept
{
  int next = 0;
  for (int r = 0; r < order; ++r)
  {
    const int row = r * (order + 1) - r * (r - 1) / 2;
    const int above = row + order + 1 - r;
    for (int j = 0; j < order - r; ++j)
    {
      to[next++] = u[0] * from[row + j] + u[1] * from[row + j + 1] + u[2] * from[above + j];
    }
  }
}

/// xy(x-y)/(x+y) and its derivatives: the factor that blends the interior points of the two edges
/// of a corner into one another.
struct Blend
{
  double value = 0.0;
  double x = 0.0, y = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;

  Blend(double a, double b) noexcept
  {
    const double sum = a + b;
    if (std::abs(sum) < 1e-30)
    {
      return; // at the corner: value and slopes are 0; the second derivatives have no limit and
              // count as 0
    }
    const double p = a / sum;
    const double q = b / sum;
    value = p * q * (p - q) * sum * sum;
    x = q * (p * p + 2.0 * p * q - q * q) * sum;
    y = p * (p * p - 2.0 * p * q - q * q) * sum;
    xx = 4.0 * q * q * q;
    yy = -4.0 * p * p * p;
    xy = (p - q) * (p * p + 4.0 * p * q + q * q);
  }
};
} // namespace

Vector3 SurfaceJet::across() const noexcept
{
  return this->dv.cross(this->dw);
}

/// The cubic over an edge, and the directions across it at its ends and in its middle.
struct SmoothTriangle::Edge
{
  std::array<Vector3, 4> curve;
  std::array<Vector3, 3> across;
  bool isSound = false;

  Edge(const Vector3& a, const Vector3& b, const Vector3& na, const Vector3& nb) noexcept
  {
    const Vector3 chord = b - a;
    const double length = chord.norm();
    const Vector3 alongA = chord - chord.dot(na) * na;
    const Vector3 alongB = chord - chord.dot(nb) * nb;
    const double projectedA = alongA.norm();
    const double projectedB = alongB.norm();
    if (!(projectedA > 0.0) || !(projectedB > 0.0))
    {
      return;
    }
    // Length 2l/(1 + cos θ), cos θ = projected/l.
    const Vector3 unitA = alongA / projectedA;
    const Vector3 unitB = alongB / projectedB;
    const double square = 2.0 * length * length;
    this->curve = { a, a + (square / (length + projectedA) / 3.0) * unitA,
      b - (square / (length + projectedB) / 3.0) * unitB, b };
    this->across[0] = na.cross(unitA);
    this->across[2] = nb.cross(unitB);
    const Vector3 sum = this->across[0] + this->across[2];
    const double norm = sum.norm();
    if (!(norm > 1e-3)) // the directions across the edge at its ends are opposite
    {
      return;
    }
    this->across[1] = sum / norm;
    this->isSound = true;
  }

  Vector3 leg(std::size_t i) const noexcept { return this->curve[i + 1] - this->curve[i]; }
  /// Control point `step` of the same curve raised to degree four.
  Vector3 quartic(int step) const noexcept
  {
    switch (step)
    {
      case 0:
        return this->curve[0];
      case 1:
        return 0.25 * this->curve[0] + 0.75 * this->curve[1];
      case 2:
        return 0.5 * (this->curve[1] + this->curve[2]);
      case 3:
        return 0.75 * this->curve[2] + 0.25 * this->curve[3];
      default:
        return this->curve[3];
    }
  }
};

/// Index of the control point at step 0..4 from corner `edge` to the next corner.
int SmoothTriangle::alongEdge(int edge, int step) noexcept
{
  switch (edge)
  {
    case 0:
      return index(step, 0);
    case 1:
      return index(Order - step, step);
    default:
      return index(0, Order - step);
  }
}

/// Index of the interior point nearest to corner `edge` (step 0) or to the next corner (step 1).
int SmoothTriangle::insideEdge(int edge, int step) noexcept
{
  switch ((edge + step) % 3)
  {
    case 0:
      return index(1, 1);
    case 1:
      return index(2, 1);
    default:
      return index(1, 2);
  }
}

SmoothTriangle::SmoothTriangle() noexcept
{
  this->Control.fill(Vector4::Zero());
  this->Twist.fill(Vector4::Zero());
}

bool SmoothTriangle::build(
  const std::array<Vector3, 3>& points, const std::array<Vector3, 3>& normals) noexcept
{
  const Vector3 facet = (points[1] - points[0]).cross(points[2] - points[0]);
  const double area = facet.norm();
  std::array<Vector3, 3> unit;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double length = normals[k].norm();
    if (!(length > 0.0) || !(facet.dot(normals[k]) > SmallestCosine * area * length))
    {
      return false;
    }
    unit[k] = normals[k] / length;
  }
  const std::array<Edge, 3> edges = { Edge(points[0], points[1], unit[0], unit[1]),
    Edge(points[1], points[2], unit[1], unit[2]), Edge(points[2], points[0], unit[2], unit[0]) };
  std::array<std::array<Vector3, 2>, 3> inside; // [edge][step]
  for (int e = 0; e < 3; ++e)
  {
    const Edge& edge = edges[static_cast<std::size_t>(e)];
    const Edge& next = edges[static_cast<std::size_t>((e + 1) % 3)];
    const Edge& last = edges[static_cast<std::size_t>((e + 2) % 3)];
    if (!edge.isSound)
    {
      return false;
    }
    for (int step = 0; step < Order; ++step)
    {
      this->Control[static_cast<std::size_t>(alongEdge(e, step))] = padded(edge.quartic(step));
    }
    // The derivative across the edge is λ(t) times the tangent plus μ(t) times the direction
    // across, with λ and μ linear. The neighbouring edges determine the derivative at the ends.
    const Vector3 first = last.quartic(3) - 0.5 * (edge.quartic(0) + edge.quartic(1));
    const Vector3 end = next.quartic(1) - 0.5 * (edge.quartic(3) + edge.quartic(4));
    const double lambda0 = first.dot(edge.leg(0)) / edge.leg(0).squaredNorm();
    const double lambda1 = end.dot(edge.leg(2)) / edge.leg(2).squaredNorm();
    const double mu0 = first.dot(edge.across[0]);
    const double mu1 = end.dot(edge.across[2]);
    const Vector3 d1 = (lambda1 * edge.leg(0) + 2.0 * lambda0 * edge.leg(1) + mu1 * edge.across[0] +
                         2.0 * mu0 * edge.across[1]) /
      3.0;
    const Vector3 d2 = (2.0 * lambda1 * edge.leg(1) + lambda0 * edge.leg(2) +
                         2.0 * mu1 * edge.across[1] + mu0 * edge.across[2]) /
      3.0;
    inside[static_cast<std::size_t>(e)] = { d1 + 0.5 * (edge.quartic(1) + edge.quartic(2)),
      d2 + 0.5 * (edge.quartic(2) + edge.quartic(3)) };
  }
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vector3& here = inside[static_cast<std::size_t>(corner)][0];
    const Vector3& there = inside[static_cast<std::size_t>((corner + 2) % 3)][1];
    this->Control[static_cast<std::size_t>(insideEdge(corner, 0))] = padded(0.5 * (here + there));
    this->Twist[static_cast<std::size_t>(corner)] = padded(0.5 * (here - there));
  }
  return true;
}

SurfaceJet SmoothTriangle::evaluate(const Vector3& u) const noexcept
{
  std::array<Vector4, 10> cubic;
  std::array<Vector4, 6> c; // j, r: 00 10 20 01 11 02
  std::array<Vector4, 3> d;
  cut<4>(this->Control.data(), u, cubic.data());
  cut<3>(cubic.data(), u, c.data());
  cut<2>(c.data(), u, d.data());
  Vector4 point = u[0] * d[0] + u[1] * d[1] + u[2] * d[2];
  Vector4 dv = 4.0 * (d[1] - d[0]);
  Vector4 dw = 4.0 * (d[2] - d[0]);
  Vector4 dvv = 12.0 * (c[2] - 2.0 * c[1] + c[0]);
  Vector4 dvw = 12.0 * (c[4] - c[1] - c[3] + c[0]);
  Vector4 dww = 12.0 * (c[5] - 2.0 * c[3] + c[0]);
  // Gregory's part: at corner i, with j and k the next two, 12 u_i² g(u_j, u_k).
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const Blend g(u[j], u[k]);
    const double s = 12.0 * u[i] * u[i];
    const double t = 24.0 * u[i];
    Vector3 slope;
    slope[i] = t * g.value;
    slope[j] = s * g.x;
    slope[k] = s * g.y;
    Eigen::Matrix3d second;
    second(i, i) = 24.0 * g.value;
    second(j, j) = s * g.xx;
    second(k, k) = s * g.yy;
    second(i, j) = second(j, i) = t * g.x;
    second(i, k) = second(k, i) = t * g.y;
    second(j, k) = second(k, j) = s * g.xy;
    const Vector4& twist = this->Twist[static_cast<std::size_t>(i)];
    point += (s * g.value) * twist;
    dv += (slope[1] - slope[0]) * twist;
    dw += (slope[2] - slope[0]) * twist;
    dvv += (second(1, 1) - 2.0 * second(0, 1) + second(0, 0)) * twist;
    dvw += (second(1, 2) - second(0, 1) - second(0, 2) + second(0, 0)) * twist;
    dww += (second(2, 2) - 2.0 * second(0, 2) + second(0, 0)) * twist;
  }
  return { point.head<3>(), dv.head<3>(), dw.head<3>(), dvv.head<3>(), dvw.head<3>(),
    dww.head<3>() };
}
} // namespace palpate
