// SPDX-License-Identifier: BSD-3-Clause
#include "BumpySphere.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

namespace palpate::testing
{
namespace
{
constexpr double Radius = 100.0;
constexpr double Waves = 15.0;

/// Tilt of the plane of the path per rad around the sphere.
constexpr double Tilt = 0.09 / (2.0 * Pi);

double bump(const Vector3& u)
{
  return std::sin(Waves * u.x()) * std::sin(Waves * u.y()) * std::cos(Waves * u.z());
}

Vector3 bumpGradient(const Vector3& u)
{
  const Eigen::Array3d s = (Waves * u.array()).sin();
  const Eigen::Array3d c = (Waves * u.array()).cos();
  return Waves * Vector3(c.x() * s.y() * c.z(), s.x() * c.y() * c.z(), -s.x() * s.y() * s.z());
}

/// Ids of the lattice points |i| + |j| + |k| = cuts: first the upper half with the equator, then
/// the lower half.
class OctahedronLattice
{
public:
  explicit OctahedronLattice(int cuts)
    : Cuts(cuts)
  {
    for (auto& half : this->Ids)
    {
      half.resize(this->at(cuts, cuts) + 1, -1);
    }
  }

  void appendPoints(std::vector<Vector3>& points)
  {
    for (const int up : { 1, 0 })
    {
      for (int i = -this->Cuts; i <= this->Cuts; ++i)
      {
        const int reach = this->Cuts - std::abs(i);
        for (int j = -reach; j <= reach; ++j)
        {
          const int k = reach - std::abs(j);
          if (k > 0 || up == 1)
          {
            const auto id = static_cast<std::int32_t>(points.size());
            this->Ids[static_cast<std::size_t>(up)][this->at(i, j)] = id;
            points.push_back(bumpyPoint(Vector3(i, j, up == 1 ? k : -k).normalized()));
          }
          else
          {
            this->Ids[0][this->at(i, j)] = this->Ids[1][this->at(i, j)];
          }
        }
      }
    }
  }

  std::int32_t id(int i, int j, bool up) const { return this->Ids[up ? 1 : 0][this->at(i, j)]; }

private:
  std::size_t at(int i, int j) const
  {
    const auto side = static_cast<std::size_t>(2 * this->Cuts + 1);
    return static_cast<std::size_t>(i + this->Cuts) * side +
      static_cast<std::size_t>(j + this->Cuts);
  }

  int Cuts;
  std::array<std::vector<std::int32_t>, 2> Ids;
};
} // namespace

Vector3 bumpyPoint(const Vector3& direction)
{
  return (Radius + bump(direction)) * direction;
}

Vector3 bumpyNormal(const Vector3& direction)
{
  // Gradient of |p| - r(p/|p|).
  const Vector3 slope = bumpGradient(direction);
  const Vector3 tangential = slope - slope.dot(direction) * direction;
  return (direction - tangential / (Radius + bump(direction))).normalized();
}

int bumpyCuts(double triangles)
{
  return std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 8.0))));
}

Surface bumpySphere(int cuts)
{
  Surface body;
  const auto square = static_cast<std::size_t>(cuts) * static_cast<std::size_t>(cuts);
  body.points.reserve(4 * square + 2);
  body.triangles.reserve(8 * square);
  OctahedronLattice lattice(cuts);
  lattice.appendPoints(body.points);
  for (int octant = 0; octant < 8; ++octant)
  {
    const int x = (octant & 4) != 0 ? -1 : 1;
    const int y = (octant & 2) != 0 ? -1 : 1;
    const bool up = (octant & 1) == 0;
    const bool mirrored = x * y * (up ? 1 : -1) < 0;
    const auto add = [&](int i0, int j0, int i1, int j1, int i2, int j2)
    {
      const std::int32_t a = lattice.id(x * i0, y * j0, up);
      const std::int32_t b = lattice.id(x * i1, y * j1, up);
      const std::int32_t c = lattice.id(x * i2, y * j2, up);
      body.triangles.push_back({ a, mirrored ? c : b, mirrored ? b : c });
    };
    for (int i = 0; i < cuts; ++i)
    {
      for (int j = 0; j < cuts - i; ++j)
      {
        add(i, j, i + 1, j, i, j + 1);
        if (i + j + 1 < cuts)
        {
          add(i + 1, j, i + 1, j + 1, i, j + 1);
        }
      }
    }
  }
  return body;
}

std::vector<Vector3> bumpyNormals(const Surface& body)
{
  std::vector<Vector3> normals;
  normals.reserve(body.points.size());
  for (const Vector3& p : body.points)
  {
    normals.push_back(bumpyNormal(p.normalized()));
  }
  return normals;
}

CurvatureRange bumpyCurvatures(int samples)
{
  CurvatureRange range{ 1e300, -1e300 };
  const double golden = Pi * (3.0 - std::sqrt(5.0));
  constexpr double h = 1e-4; // central differences have an error of h² Waves² = 2e-6
  for (int i = 0; i < samples; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / samples;
    const double r = std::sqrt(1.0 - z * z);
    const Vector3 u(r * std::cos(golden * i), r * std::sin(golden * i), z);
    const Vector3 normal = bumpyNormal(u);
    Eigen::Matrix<double, 3, 2> basis;
    basis.col(0) = normal.unitOrthogonal();
    basis.col(1) = normal.cross(basis.col(0));
    Eigen::Matrix2d moved;
    Eigen::Matrix2d turned;
    for (Eigen::Index k = 0; k < 2; ++k)
    {
      const Vector3 ahead = (u + h * basis.col(k)).normalized();
      const Vector3 behind = (u - h * basis.col(k)).normalized();
      moved.col(k) = basis.transpose() * (bumpyPoint(ahead) - bumpyPoint(behind));
      turned.col(k) = basis.transpose() * (bumpyNormal(ahead) - bumpyNormal(behind));
    }
    const Eigen::Matrix2d shape = turned * moved.inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(
      0.5 * (shape + shape.transpose()), Eigen::EigenvaluesOnly);
    range.least = std::min(range.least, solver.eigenvalues()[0]);
    range.greatest = std::max(range.greatest, solver.eigenvalues()[1]);
  }
  return range;
}

Vector3 windingDirection(double along, double across)
{
  const double a = along / Radius;
  const double b = across / Radius;
  const Vector3 level(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
  return Eigen::AngleAxisd(Tilt * a, Vector3::UnitX()) * level;
}

Vector3 windingTip(double depth, double along, double across)
{
  const Vector3 direction = windingDirection(along, across);
  return bumpyPoint(direction) - depth * bumpyNormal(direction);
}

std::vector<Vector3> windingTips(std::size_t count, double depth, double step)
{
  std::vector<Vector3> tips;
  tips.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    tips.push_back(windingTip(depth, step * static_cast<double>(i)));
  }
  return tips;
}

Surface shuffled(const Surface& body, unsigned seed, std::vector<std::int32_t>* pointOf,
  std::vector<std::int32_t>* triangleOf)
{
  std::mt19937 random(seed);
  const auto randomOrder = [&](std::size_t count)
  {
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    return order;
  };
  std::vector<std::int32_t> points = randomOrder(body.points.size());
  std::vector<std::int32_t> triangles = randomOrder(body.triangles.size());

  Surface mixed;
  mixed.points.reserve(points.size());
  mixed.triangles.reserve(triangles.size());
  std::vector<std::int32_t> newId(points.size());
  for (const std::int32_t old : points)
  {
    newId[static_cast<std::size_t>(old)] = static_cast<std::int32_t>(mixed.points.size());
    mixed.points.push_back(body.points[static_cast<std::size_t>(old)]);
  }
  for (const std::int32_t old : triangles)
  {
    const auto& corners = body.triangles[static_cast<std::size_t>(old)];
    const std::size_t first = random() % 3;
    const auto corner = [&](std::size_t k)
    { return newId[static_cast<std::size_t>(corners[(first + k) % 3])]; };
    mixed.triangles.push_back({ corner(0), corner(1), corner(2) });
  }
  if (pointOf != nullptr)
  {
    *pointOf = std::move(points);
  }
  if (triangleOf != nullptr)
  {
    *triangleOf = std::move(triangles);
  }
  return mixed;
}
} // namespace palpate::testing
