// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/SmoothTriangle.h"

#include <Eigen/Geometry>

#include <cmath>

namespace palpate
{
namespace
{
using Vector4 = Eigen::Vector4d;
/// Four doubles that are processed together, or two at a time on a processor without AVX.
using Four [[gnu::vector_size(32)]] = double;
/// The same type for the memory of an Eigen::Vector4d, whose address need not be a multiple of 32.
/// (This type must not be used as a template argument, which would lose the attributes.)
using StoredFour [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

Vector4 padded(const Vector3& v)
{
  return { v.x(), v.y(), v.z(), 0.0 };
}

/// Computes one step of de Casteljau's algorithm, from the control points of degree `order` to
/// those of degree order-1.
template <int order>
[[gnu::always_inline]] inline void cut(const StoredFour* from, const Vector3& u, Four* to) noexcept
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

/// xy(x-y)/(x+y) and its derivatives. This factor interpolates between the interior points of the
/// two edges of a corner.
struct Blend
{
  double value = 0.0;
  double x = 0.0, y = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;

  [[gnu::always_inline]] Blend(double a, double b) noexcept
  {
    const double sum = a + b;
    if (std::abs(sum) < 1e-30)
    {
      // At the corner, the value and the slopes are 0; the second derivatives have no limit there
      // and are set to 0.
      return;
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

// The function executes the same instructions in the same order with vectors of two or four
// doubles, so that the results are the same bit for bit. The code that selects one of the two
// versions cannot run under a thread sanitizer.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
[[gnu::target_clones("avx", "default")]]
#endif
[[gnu::hot]] SurfaceJet
evaluatePatch(const StoredFour* control, const StoredFour* twists, const Vector3& u) noexcept
{
  std::array<Four, 10> cubic;
  std::array<Four, 6> c; // indices j, r of the points: 00 10 20 01 11 02
  std::array<Four, 3> d;
  cut<4>(control, u, cubic.data());
  cut<3>(cubic.data(), u, c.data());
  cut<2>(c.data(), u, d.data());
  Four point = u[0] * d[0] + u[1] * d[1] + u[2] * d[2];
  Four dv = 4.0 * (d[1] - d[0]);
  Four dw = 4.0 * (d[2] - d[0]);
  Four dvv = 12.0 * (c[2] - 2.0 * c[1] + c[0]);
  Four dvw = 12.0 * (c[4] - c[1] - c[3] + c[0]);
  Four dww = 12.0 * (c[5] - 2.0 * c[3] + c[0]);
  // Adds Gregory's term of each corner i, with the next two corners j and k: 12 u_i² g(u_j, u_k).
  // The three corners are written out, because a loop over them is slower.
  const auto add =
    [&](const StoredFour& twist, double value, double v, double w, double vv, double vw, double ww)
  {
    point += value * twist;
    dv += v * twist;
    dw += w * twist;
    dvv += vv * twist;
    dvw += vw * twist;
    dww += ww * twist;
  };
  { // corner 0: j = 1, k = 2
    const Blend g(u[1], u[2]);
    const double s = 12.0 * u[0] * u[0];
    const double t = 24.0 * u[0];
    const double v = t * g.value;
    const double second = 24.0 * g.value;
    add(twists[0], s * g.value, s * g.x - v, s * g.y - v, s * g.xx - 2.0 * (t * g.x) + second,
      s * g.xy - t * g.x - t * g.y + second, s * g.yy - 2.0 * (t * g.y) + second);
  }
  { // corner 1: j = 2, k = 0
    const Blend g(u[2], u[0]);
    const double s = 12.0 * u[1] * u[1];
    const double t = 24.0 * u[1];
    add(twists[1], s * g.value, t * g.value - s * g.y, s * g.x - s * g.y,
      24.0 * g.value - 2.0 * (t * g.y) + s * g.yy, t * g.x - t * g.y - s * g.xy + s * g.yy,
      s * g.xx - 2.0 * (s * g.xy) + s * g.yy);
  }
  { // corner 2: j = 0, k = 1
    const Blend g(u[0], u[1]);
    const double s = 12.0 * u[2] * u[2];
    const double t = 24.0 * u[2];
    add(twists[2], s * g.value, s * g.y - s * g.x, t * g.value - s * g.x,
      s * g.yy - 2.0 * (s * g.xy) + s * g.xx, t * g.y - s * g.xy - t * g.x + s * g.xx,
      24.0 * g.value - 2.0 * (t * g.x) + s * g.xx);
  }
  const auto three = [](const Four& f) { return Vector3(f[0], f[1], f[2]); };
  return { three(point), three(dv), three(dw), three(dvv), three(dvw), three(dww) };
}
} // namespace

Vector3 SurfaceJet::across() const noexcept
{
  return this->dv.cross(this->dw);
}

/// The cubic curve over an edge, and the directions across the edge at its ends and in its middle.
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
    // The length of each end tangent is 2l/(1 + cos θ), with cos θ = projected/l.
    const Vector3 unitA = alongA / projectedA;
    const Vector3 unitB = alongB / projectedB;
    const double square = 2.0 * length * length;
    this->curve = { a, a + (square / (length + projectedA) / 3.0) * unitA,
      b - (square / (length + projectedB) / 3.0) * unitB, b };
    this->across[0] = na.cross(unitA);
    this->across[2] = nb.cross(unitB);
    const Vector3 sum = this->across[0] + this->across[2];
    const double norm = sum.norm();
    if (!(norm > 1e-3)) // the directions across the edge at its two ends are opposite
    {
      return;
    }
    this->across[1] = sum / norm;
    this->isSound = true;
  }

  Vector3 leg(std::size_t i) const noexcept { return this->curve[i + 1] - this->curve[i]; }
  /// Returns control point `step` of the same curve after degree elevation to four.
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

/// Returns the index of the control point at step 0..4 from corner `edge` to the next corner.
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

/// Returns the index of the interior control point nearest to corner `edge` (step 0) or to the next
/// corner (step 1).
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
  std::array<std::array<Vector3, 2>, 3> inside; // indices: [edge][step]
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
    // The derivative across the edge is λ(t) times the tangent plus μ(t) times the direction across
    // the edge, with λ and μ linear. The values at the ends follow from the neighbouring edges.
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
  return evaluatePatch(reinterpret_cast<const StoredFour*>(this->Control.data()),
    reinterpret_cast<const StoredFour*>(this->Twist.data()), u);
}
} // namespace palpate
