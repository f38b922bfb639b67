// SPDX-License-Identifier: BSD-3-Clause
#include "SampleBodies.h"

#include <cmath>
#include <map>
#include <utility>

namespace palpate::testing
{
BodyMesh Surface::mesh() const
{
  std::vector<double> xyz;
  for (const Vector3& p : this->points)
  {
    xyz.insert(xyz.end(), p.data(), p.data() + 3);
  }
  std::vector<std::int32_t> corners;
  for (const auto& t : this->triangles)
  {
    corners.insert(corners.end(), t.begin(), t.end());
  }
  return BodyMesh(xyz.data(), this->points.size(), corners.data(), this->triangles.size());
}

PackedMesh Surface::packed() const
{
  static_assert(sizeof(Vector3) == 3 * sizeof(double), "points lie side by side");
  return PackedMesh(this->points.empty() ? nullptr : this->points.front().data(),
    this->points.size(), this->triangles.empty() ? nullptr : this->triangles.front().data(),
    this->triangles.size());
}

Surface Surface::rounded() const
{
  const PackedMesh mesh = this->packed();
  Surface kept = *this;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
  {
    const auto triangle = static_cast<std::int32_t>(t);
    for (int k = 0; k < 3; ++k)
    {
      const std::int32_t point =
        mesh.inputPoint(mesh.corners(triangle)[static_cast<std::size_t>(k)]);
      kept.points[static_cast<std::size_t>(point)] = mesh.centre() + mesh.corner(triangle, k);
    }
  }
  return kept;
}

Surface subdivided(Surface body, int times)
{
  for (; times > 0; --times)
  {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b)
    {
      const auto [found, isNew] =
        middles.emplace(std::minmax(a, b), static_cast<std::int32_t>(body.points.size()));
      if (isNew)
      {
        const Vector3 at = 0.5 *
          (body.points[static_cast<std::size_t>(a)] + body.points[static_cast<std::size_t>(b)]);
        body.points.push_back(at);
      }
      return found->second;
    };
    std::vector<std::array<std::int32_t, 3>> finer;
    for (const auto& t : body.triangles)
    {
      const std::int32_t ab = middle(t[0], t[1]);
      const std::int32_t bc = middle(t[1], t[2]);
      const std::int32_t ca = middle(t[2], t[0]);
      finer.insert(
        finer.end(), { { t[0], ab, ca }, { ab, t[1], bc }, { ca, bc, t[2] }, { ab, bc, ca } });
    }
    body.triangles = std::move(finer);
  }
  return body;
}

Surface icosphere(double radius, int times)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  Surface body;
  body.points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
    { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
  body.triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  for (; times >= 0; --times)
  {
    for (Vector3& p : body.points)
    {
      p *= radius / p.norm();
    }
    if (times > 0)
    {
      body = subdivided(std::move(body), 1);
    }
  }
  return body;
}

Surface torus(double majorRadius, double minorRadius, int around, int across)
{
  Surface body;
  const double step = 2.0 * 3.14159265358979323846;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = step * i / around;
      const double v = step * j / across;
      const double r = majorRadius + minorRadius * std::cos(v);
      body.points.emplace_back(r * std::cos(u), r * std::sin(u), minorRadius * std::sin(v));
      const auto at = [&](int ii, int jj) { return (ii % around) * across + jj % across; };
      body.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      body.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return body;
}

Surface prism(const std::vector<Eigen::Vector2d>& polygon,
  const std::vector<std::array<std::int32_t, 3>>& caps, double height)
{
  Surface body;
  const auto n = static_cast<std::int32_t>(polygon.size());
  for (const double z : { 0.0, height })
  {
    for (const Eigen::Vector2d& p : polygon)
    {
      body.points.emplace_back(p.x(), p.y(), z);
    }
  }
  for (const auto& t : caps)
  {
    body.triangles.push_back({ t[2], t[1], t[0] });
    body.triangles.push_back({ t[0] + n, t[1] + n, t[2] + n });
  }
  for (std::int32_t i = 0; i < n; ++i)
  {
    const std::int32_t j = (i + 1) % n;
    body.triangles.push_back({ i, j, j + n });
    body.triangles.push_back({ i, j + n, i + n });
  }
  return body;
}

Surface block(double x, double y, double z)
{
  return prism({ { 0, 0 }, { x, 0 }, { x, y }, { 0, y } }, { { 0, 1, 2 }, { 0, 2, 3 } }, z);
}

Surface angleBlock()
{
  return prism({ { 0, 0 }, { 20, 0 }, { 20, 8 }, { 8, 8 }, { 8, 20 }, { 0, 20 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 } }, 10.0);
}

Surface grooveBlock()
{
  return prism({ { -20, 0 }, { 20, 0 }, { 20, 10 }, { 5, 10 }, { 0, 5 }, { -5, 10 }, { -20, 10 } },
    { { 0, 4, 5 }, { 0, 5, 6 }, { 0, 1, 4 }, { 1, 3, 4 }, { 1, 2, 3 } }, 40.0);
}

Surface triangleSoup(const Surface& body)
{
  Surface apart;
  for (std::size_t t = 0; t < body.triangles.size(); ++t)
  {
    const auto first = static_cast<std::int32_t>(apart.points.size());
    for (std::size_t k = 0; k < 3; ++k)
    {
      apart.points.push_back(body.corner(static_cast<std::int32_t>(t), k));
    }
    apart.triangles.push_back({ first, first + 1, first + 2 });
  }
  return apart;
}

Surface together(Surface one, const Surface& other, const Vector3& by)
{
  const auto shift = static_cast<std::int32_t>(one.points.size());
  for (const Vector3& p : other.points)
  {
    one.points.push_back(p + by);
  }
  for (const auto& t : other.triangles)
  {
    one.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  return one;
}

Surface openPlate(double size, int cells)
{
  Surface body;
  for (int i = 0; i <= cells; ++i)
  {
    for (int j = 0; j <= cells; ++j)
    {
      body.points.emplace_back(size * i / cells, size * j / cells, 0.0);
      if (i < cells && j < cells)
      {
        const std::int32_t at = i * (cells + 1) + j;
        const std::int32_t next = at + cells + 1;
        body.triangles.push_back({ at, next, next + 1 });
        body.triangles.push_back({ at, next + 1, at + 1 });
      }
    }
  }
  return body;
}
} // namespace palpate::testing
