// SPDX-License-Identifier: BSD-3-Clause
#include "StudyTips.h"

#include "Contact/ContactTracker.h"

#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

namespace palpate::testing
{
namespace
{
constexpr double Shallowest = 0.05; // share of the range
constexpr double Step = 0.1;        // mm per tick

double depthOnPath(std::size_t i, double range)
{
  const double wave = 0.5 + 0.5 * std::sin(0.013 * static_cast<double>(i));
  return range * (Shallowest + (1.0 - Shallowest) * wave);
}

/// Checks whether a body is gently curved at a place.
class GentleBody
{
public:
  explicit GentleBody(const PackedMesh& mesh)
    : Mesh(mesh)
    , Known(mesh.pointCount(), Unknown)
  {
  }

  bool isGentle(std::int32_t triangle)
  {
    bool gentle = true;
    for (const std::int32_t corner : this->Mesh.corners(triangle))
    {
      char& known = this->Known[static_cast<std::size_t>(corner)];
      if (known == Unknown)
      {
        known = this->look(corner) ? Gentle : Rough;
      }
      gentle = gentle && known == Gentle;
    }
    return gentle;
  }

private:
  static constexpr char Unknown = 0;
  static constexpr char Gentle = 1;
  static constexpr char Rough = 2;
  static constexpr double Around = 4.0; // mm
  static constexpr double Turn = 0.35;  // rad

  bool look(std::int32_t centre) const
  {
    const Vector3 normal = this->Mesh.pointNormal(centre);
    std::set<std::int32_t> seen{ centre };
    std::vector<std::int32_t> queue{ centre };
    Vector3 origin = Vector3::Zero();
    bool isFirst = true;
    bool gentle = true;
    for (std::size_t i = 0; i < queue.size() && gentle; ++i)
    {
      gentle = this->Mesh.pointNormal(queue[i]).dot(normal) > std::cos(Turn);
      this->Mesh.visitAround(queue[i],
        [&](std::int32_t triangle)
        {
          for (int k = 0; k < 3; ++k)
          {
            const std::int32_t point = this->Mesh.corners(triangle)[static_cast<std::size_t>(k)];
            const Vector3 place = this->Mesh.corner(triangle, k);
            if (point == centre && isFirst)
            {
              origin = place;
              isFirst = false;
            }
          }
          for (int k = 0; k < 3; ++k)
          {
            const std::int32_t point = this->Mesh.corners(triangle)[static_cast<std::size_t>(k)];
            gentle = gentle && this->Mesh.neighbour(triangle, k) >= 0;
            if ((this->Mesh.corner(triangle, k) - origin).norm() < Around &&
              seen.insert(point).second)
            {
              queue.push_back(point);
            }
          }
        });
    }
    return gentle;
  }

  const PackedMesh& Mesh;
  std::vector<char> Known;
};

struct Foot
{
  Vector3 point;
  Vector3 normal;
};

Foot footAt(const PackedMesh& mesh, std::int32_t triangle, const Vector3& weights)
{
  Foot foot{ mesh.centre(), Vector3::Zero() };
  for (int k = 0; k < 3; ++k)
  {
    foot.point += weights[k] * mesh.corner(triangle, k);
    foot.normal +=
      weights[k] * mesh.pointNormal(mesh.corners(triangle)[static_cast<std::size_t>(k)]);
  }
  foot.normal.normalize();
  return foot;
}

Vector3 randomWeights(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double root = std::sqrt(unit(random));
  const double share = unit(random);
  return { 1.0 - root, root * (1.0 - share), root * share };
}
} // namespace

StudyTips flatTips(double half, double range, std::size_t sites, std::size_t path)
{
  StudyTips tips;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> aside(-half, half);
  std::uniform_real_distribution<double> share(Shallowest, 1.0);
  for (std::size_t i = 0; i < sites; ++i)
  {
    const double x = aside(random);
    const double y = aside(random);
    tips.sites.push_back({ { x, y, -range * share(random) }, true });
  }
  for (std::size_t i = 0; i < path; ++i)
  {
    // A Lissajous figure that does not close; 0.1 mm per tick in the middle.
    const double way = Step * static_cast<double>(i) / half;
    tips.path.push_back(
      { { half * std::sin(0.8 * way), half * std::sin(0.6 * way + 1.0), -depthOnPath(i, range) },
        i == 0 });
  }
  return tips;
}

StudyTips ballTips(double radius, double range, std::size_t sites)
{
  StudyTips tips;
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(Shallowest, 1.0);
  while (tips.sites.size() < sites)
  {
    const double x = normal(random);
    const double y = normal(random);
    const Vector3 direction = Vector3(x, y, normal(random)).normalized();
    tips.sites.push_back({ (radius - range * share(random)) * direction, true });
  }
  return tips;
}

StudyTips bodyTips(const StudyBody& body, double range, std::size_t sites, std::size_t path)
{
  const PackedMesh& mesh = body.packed();
  GentleBody gentle(mesh);
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> anyTriangle(
    0, static_cast<std::int32_t>(mesh.triangleCount()) - 1);
  const auto gentleTriangle = [&]
  {
    for (int i = 0; i < 100000; ++i)
    {
      const std::int32_t triangle = anyTriangle(random);
      if (gentle.isGentle(triangle))
      {
        return triangle;
      }
    }
    throw std::runtime_error("the body is nowhere gently curved");
  };
  StudyTips tips;
  std::uniform_real_distribution<double> share(Shallowest, 1.0);
  while (tips.sites.size() < sites)
  {
    const Foot foot = footAt(mesh, gentleTriangle(), randomWeights(random));
    tips.sites.push_back({ foot.point - range * share(random) * foot.normal, true });
  }
  ContactTracker tracker(mesh, body.contact().tree);
  bool isNew = true;
  Foot foot{};
  Vector3 ahead = Vector3::Zero();
  while (tips.path.size() < path)
  {
    if (isNew)
    {
      foot = footAt(mesh, gentleTriangle(), randomWeights(random));
      ahead = foot.normal.unitOrthogonal();
      tracker.reset();
    }
    ahead = (ahead - ahead.dot(foot.normal) * foot.normal).normalized();
    const double depth = depthOnPath(tips.path.size(), range);
    const Vector3 tip = foot.point + Step * ahead - depth * foot.normal;
    const ContactTracker::Result contact = tracker.update(tip);
    const bool isOn =
      contact.outcome == ContactTracker::Outcome::Inside && gentle.isGentle(contact.place.triangle);
    if (isOn)
    {
      tips.path.push_back({ tip, isNew });
      foot = footAt(mesh, contact.place.triangle, contact.place.projection.weights);
    }
    isNew = !isOn;
  }
  return tips;
}
} // namespace palpate::testing
