// SPDX-License-Identifier: BSD-3-Clause
#include "ContinuityMeasures.h"

#include "BumpySphere.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace palpate::testing
{
namespace
{
Vector3 tipUnder(const SmoothBody& body, const Vector3& direction, double depth)
{
  return body.point(direction) - depth * body.normal(direction);
}

Vector3 anyDirection(std::mt19937& random)
{
  std::normal_distribution<double> gauss;
  const double x = gauss(random);
  const double y = gauss(random);
  return Vector3(x, y, gauss(random)).normalized();
}

/// A contact with its history, and its last result. Copies have separate histories.
class Follower
{
public:
  explicit Follower(const ToolContact& contact)
    : Touch(contact)
  {
  }
  Follower(const Follower& other) = default;
  Follower& operator=(const Follower& other)
  {
    this->Touch.emplace(*other.Touch);
    this->last = other.last;
    return *this;
  }
  ~Follower() = default;

  void to(const Vector3& tip) { this->last = this->Touch->update(tip); }

  Contact last;

private:
  std::optional<ToolContact> Touch;
};

/// Jump of the force at the first change of triangle between two places on the path. `before`: the
/// contact at the first place.
double jumpBetween(const std::function<Vector3(double)>& tipAt, double low, double high,
  Follower before, Follower after)
{
  while ((tipAt(high) - tipAt(low)).norm() > 1e-9)
  {
    const double middle = 0.5 * (low + high);
    Follower there = before;
    there.to(tipAt(middle));
    const bool same = there.last.triangle == before.last.triangle;
    (same ? low : high) = middle;
    (same ? before : after) = there;
  }
  return (after.last.force - before.last.force).norm();
}
struct Work
{
  double work = 0.0;
  double scale = 0.0;
};

/// Adds ∫F·dx and ∫|F||dx| of a part of a path, by the trapezoidal rule. A part in which the
/// triangle changes is halved until it is 1e-8 mm long, since the force may jump there.
void addWork(const std::function<Vector3(double)>& tipAt, double low, double high,
  Follower& follower, Work& sum)
{
  const Vector3 way = tipAt(high) - tipAt(low);
  Follower next = follower;
  next.to(tipAt(high));
  if (next.last.triangle != follower.last.triangle && way.norm() > 1e-8)
  {
    const double middle = 0.5 * (low + high);
    addWork(tipAt, low, middle, follower, sum);
    addWork(tipAt, middle, high, follower, sum);
    return;
  }
  sum.work += 0.5 * (follower.last.force + next.last.force).dot(way);
  sum.scale += 0.5 * (follower.last.force.norm() + next.last.force.norm()) * way.norm();
  follower = next;
}
} // namespace

SmoothBody smoothSphere(double radius)
{
  return { "sphere", [radius](const Vector3& d) -> Vector3 { return radius * d; },
    [](const Vector3& d) -> Vector3 { return d; }, radius, radius };
}

SmoothBody smoothEllipsoid(const Vector3& axes)
{
  const Vector3 inverse = axes.cwiseInverse();
  return { "ellipsoid", [axes](const Vector3& d) -> Vector3 { return axes.cwiseProduct(d); },
    [inverse](const Vector3& d) -> Vector3 { return inverse.cwiseProduct(d).normalized(); },
    axes.minCoeff() * axes.minCoeff() / axes.maxCoeff(), axes.mean() };
}

SmoothBody smoothBumpySphere()
{
  return { "bumpy", bumpyPoint, bumpyNormal, 1.0 / bumpyCurvatures(20000).greatest, 100.0 };
}

double responseForce(double depth)
{
  return 10.0 * std::pow(depth, 1.5);
}

double uniform(const Vector3& /*direction*/)
{
  return 1.0;
}

double varied(const Vector3& d)
{
  return 1.0 + 0.5 * std::sin(2.0 * d.x() + 0.3) * std::cos(2.0 * d.y()) * std::cos(d.z() - 0.4);
}

MeshedBody::MeshedBody(const SmoothBody& body, int cuts, const Stiffening& stiffening,
  MeshNormals normals, const EdgeTerms& edges)
  : shape(body)
  , factor(stiffening)
  , meanEdge(0.0)
  , longestEdge(0.0)
{
  Surface surface = bumpySphere(cuts);
  std::vector<Vector3> directions;
  for (Vector3& p : surface.points)
  {
    directions.push_back(p.normalized());
    p = body.point(directions.back());
  }
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface.triangles.size()); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double edge = (surface.corner(t, k) - surface.corner(t, (k + 1) % 3)).norm();
      this->meanEdge += edge / (3.0 * static_cast<double>(surface.triangles.size()));
      this->longestEdge = std::max(this->longestEdge, edge);
    }
  }
  ResponseStore store(surface.points.size());
  store.edges = edges;
  takeMeshNormals(store, surface);
  for (std::size_t p = 0; p < directions.size(); ++p)
  {
    if (normals == MeshNormals::Exact)
    {
      Eigen::Map<Eigen::Vector3f>(store.normal.data() + 3 * p) =
        body.normal(directions[p]).cast<float>();
    }
    const auto scale = static_cast<float>(stiffening(directions[p]));
    for (std::size_t i = 8 * p; i < 8 * (p + 1); ++i)
    {
      store.force[i] *= scale;
      store.stiffness[i] *= scale;
    }
  }
  this->contact = contactBody(surface, store);
}

double forceJump(
  const MeshedBody& body, const ContactSettings& settings, double depth, double length)
{
  // A circle that does not meet a corner or follow an edge of the octahedron's grid.
  const Vector3 axis = Vector3(0.31, -0.47, 0.83).normalized();
  const Vector3 start = axis.unitOrthogonal();
  const auto tipAt = [&](double along) -> Vector3
  {
    const double angle = along / body.shape.meanRadius;
    const Vector3 turned = Eigen::AngleAxisd(angle, axis) * start;
    return tipUnder(body.shape, Eigen::AngleAxisd(0.037 * angle, start) * turned, depth);
  };
  const double step = body.meanEdge / 40.0;
  Follower follower(ToolContact(*body.contact, settings));
  follower.to(tipAt(0.0));
  double greatest = 0.0;
  for (double along = 0.0; along < length; along += step)
  {
    Follower next = follower;
    next.to(tipAt(along + step));
    if (next.last.triangle != follower.last.triangle)
    {
      greatest = std::max(greatest,
        jumpBetween(tipAt, along, along + step, follower, next) / follower.last.force.norm());
    }
    follower = next;
  }
  return greatest;
}

double loopEnergy(
  const MeshedBody& body, const ContactSettings& settings, double reaching, int loops)
{
  std::mt19937 random(11);
  double greatest = 0.0;
  for (int loop = 0; loop < loops; ++loop)
  {
    const Vector3 middle = anyDirection(random);
    const Vector3 x = middle.unitOrthogonal();
    const Vector3 y = middle.cross(x);
    const auto tipAt = [&](double turn) -> Vector3
    {
      const double angle = 6.283185307179586 * turn;
      const double wide = 3.0 * (1.0 + 0.3 * std::cos(angle + 0.5)) / body.shape.meanRadius;
      const Vector3 direction = middle + wide * (std::cos(angle) * x + 0.7 * std::sin(angle) * y);
      // A third of the path is outside. The deepest point is not in the middle of the other part.
      const double depth = 0.6 * std::sin(angle) + 0.2 * std::sin(2.0 * angle + 0.4) + 0.2;
      return tipUnder(body.shape, direction.normalized(), reaching * depth);
    };
    constexpr int steps = 4000;
    Follower follower(ToolContact(*body.contact, settings));
    follower.to(tipAt(0.75)); // starts outside
    Work sum;
    for (int i = 0; i < steps; ++i)
    {
      addWork(tipAt, 0.75 + static_cast<double>(i) / steps,
        0.75 + static_cast<double>(i + 1) / steps, follower, sum);
    }
    greatest = std::max(greatest, std::abs(sum.work) / sum.scale);
  }
  return greatest;
}

ForceError forceError(
  const MeshedBody& body, const ContactSettings& settings, double depth, int tips)
{
  std::mt19937 random(12);
  ToolContact contact(*body.contact, settings);
  ForceError worst;
  for (int i = 0; i < tips; ++i)
  {
    const Vector3 direction = anyDirection(random);
    contact.reset();
    const Vector3 force = contact.update(tipUnder(body.shape, direction, depth)).force;
    const Vector3 normal = body.shape.normal(direction);
    const double expected = body.factor(direction) * responseForce(depth);
    worst.size = std::max(worst.size, std::abs(force.norm() / expected - 1.0));
    worst.direction =
      std::max(worst.direction, std::atan2(force.cross(normal).norm(), force.dot(normal)));
  }
  return worst;
}
} // namespace palpate::testing
