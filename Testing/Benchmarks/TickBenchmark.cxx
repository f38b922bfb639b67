// SPDX-License-Identifier: BSD-3-Clause
// One tick: a tip slides 1 mm deep along a bumpy sphere of 100 mm, 0.1 mm per tick; and the first
// tick of a contact, which searches the whole body.
#include "ToolContact.h"

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>

#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace
{
using palpate::Vector3;

constexpr double Radius = 100.0;
constexpr double Depth = 1.0;
constexpr int Samples = 8;

/// Distance of the surface from the centre along a unit vector: bumps 1 mm high, 20 mm apart, none
/// as sharp as the depth.
double bumpyRadius(const Vector3& d)
{
  return Radius + std::sin(30.0 * d.x()) * std::sin(30.0 * d.y()) * std::cos(30.0 * d.z());
}

/// An octahedron with its faces cut in `cuts`² triangles, pushed out to the bumpy sphere. The
/// points are in the order of a grid over each octant, as a mesher would leave them.
class BumpySphere
{
public:
  explicit BumpySphere(int cuts)
  {
    for (const double x : { 1.0, -1.0 })
    {
      for (const double y : { 1.0, -1.0 })
      {
        for (const double z : { 1.0, -1.0 })
        {
          this->addOctant({ x, y, z }, cuts);
        }
      }
    }
  }

  std::unique_ptr<palpate::ContactBody> makeBody() const
  {
    const std::size_t count = this->Points.size() / 3;
    const palpate::ResponseSampling sampling(Samples, 1.5);
    std::vector<float> force(count * Samples);
    std::vector<float> stiffness(count * Samples);
    std::vector<float> normal(3 * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (int k = 0; k < Samples; ++k)
      {
        const double depth = sampling.depth(k, 2.0);
        force[i * Samples + static_cast<std::size_t>(k)] = static_cast<float>(std::pow(depth, 1.5));
        stiffness[i * Samples + static_cast<std::size_t>(k)] =
          static_cast<float>(1.5 * std::sqrt(depth));
      }
      const Vector3 radial = Eigen::Map<const Vector3>(this->Points.data() + 3 * i).normalized();
      Eigen::Map<Eigen::Vector3f>(normal.data() + 3 * i) = radial.cast<float>();
    }
    const std::vector<float> range(count, 2.0F);
    const std::vector<std::uint8_t> status(count, 0);
    palpate::ResponseArrays arrays;
    arrays.points = count;
    arrays.samples = Samples;
    arrays.exponent = 1.5;
    arrays.force = force.data();
    arrays.stiffness = stiffness.data();
    arrays.normal = normal.data();
    arrays.range = range.data();
    arrays.status = status.data();
    return std::make_unique<palpate::ContactBody>(
      palpate::BodyMesh(
        this->Points.data(), count, this->Triangles.data(), this->Triangles.size() / 3),
      palpate::ResponseField(arrays));
  }

private:
  void addOctant(const Vector3& sign, int cuts)
  {
    // Point (i, j) of a face, i + j <= cuts; points on shared edges have the same coordinates.
    std::map<std::pair<int, int>, std::int32_t> ids;
    for (int i = 0; i <= cuts; ++i)
    {
      for (int j = 0; j <= cuts - i; ++j)
      {
        const Vector3 flat(sign.x() * i, sign.y() * j, sign.z() * (cuts - i - j));
        ids[{ i, j }] = this->pointAt(flat.cast<int>().cast<double>());
      }
    }
    const bool turn = sign.prod() < 0.0;
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
      this->Triangles.insert(this->Triangles.end(), { a, turn ? c : b, turn ? b : c });
    };
    for (int i = 0; i < cuts; ++i)
    {
      for (int j = 0; j < cuts - i; ++j)
      {
        add(ids[{ i, j }], ids[{ i + 1, j }], ids[{ i, j + 1 }]);
        if (i + j + 1 < cuts)
        {
          add(ids[{ i + 1, j }], ids[{ i + 1, j + 1 }], ids[{ i, j + 1 }]);
        }
      }
    }
  }

  std::int32_t pointAt(const Vector3& lattice)
  {
    const auto key = std::make_tuple(lattice.x(), lattice.y(), lattice.z());
    const bool shared = lattice.x() == 0.0 || lattice.y() == 0.0 || lattice.z() == 0.0;
    if (shared)
    {
      const auto found = this->Shared.find(key);
      if (found != this->Shared.end())
      {
        return found->second;
      }
    }
    const auto id = static_cast<std::int32_t>(this->Points.size() / 3);
    const Vector3 direction = lattice.normalized();
    const Vector3 point = bumpyRadius(direction) * direction;
    this->Points.insert(this->Points.end(), { point.x(), point.y(), point.z() });
    if (shared)
    {
      this->Shared.emplace(key, id);
    }
    return id;
  }

  std::vector<double> Points;
  std::vector<std::int32_t> Triangles;
  std::map<std::tuple<double, double, double>, std::int32_t> Shared;
};

/// The body with 8 cuts² triangles, kept until another size is asked for.
const palpate::ContactBody& bodyOf(int cuts, double& buildSeconds)
{
  static std::unique_ptr<palpate::ContactBody> body;
  static int current = 0;
  static double seconds = 0.0;
  if (current != cuts)
  {
    body.reset();
    const BumpySphere sphere(cuts);
    const auto start = std::chrono::steady_clock::now();
    body = sphere.makeBody();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    current = cuts;
  }
  buildSeconds = seconds;
  return *body;
}

Vector3 tipAlong(const Vector3& direction)
{
  return (bumpyRadius(direction) - Depth) * direction;
}

/// A path that winds around the sphere, a new strip of it at each turn.
std::vector<Vector3> slidingTips(std::size_t count)
{
  std::vector<Vector3> tips;
  const double step = 0.1 / Radius;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double angle = step * static_cast<double>(i);
    const Vector3 direction = Eigen::AngleAxisd(0.02 * angle, Vector3::UnitX()) *
      Vector3(std::cos(angle), std::sin(angle), 0.0);
    tips.push_back(tipAlong(direction));
  }
  return tips;
}

void describe(benchmark::State& state, const palpate::ContactBody& body, double buildSeconds,
  std::size_t contacts, std::size_t ticks)
{
  state.counters["triangles"] = static_cast<double>(body.surface.triangleCount());
  state.counters["build_ms"] = 1e3 * buildSeconds;
  state.counters["in_contact"] = static_cast<double>(contacts) / static_cast<double>(ticks);
}

void SlidingTick(benchmark::State& state)
{
  double buildSeconds = 0.0;
  const palpate::ContactBody& body = bodyOf(static_cast<int>(state.range(0)), buildSeconds);
  static const std::vector<Vector3> tips = slidingTips(200000);
  palpate::ToolContact contact(body);
  std::size_t i = 0;
  std::size_t contacts = 0;
  std::size_t ticks = 0;
  for (auto _ : state)
  {
    const palpate::ToolContactForce force = contact.update(tips[i]);
    contacts += force.state == palpate::ContactState::Slide;
    benchmark::DoNotOptimize(force.force);
    i = i + 1 < tips.size() ? i + 1 : 0;
    ++ticks;
  }
  describe(state, body, buildSeconds, contacts, ticks);
}

void ContactOnset(benchmark::State& state)
{
  double buildSeconds = 0.0;
  const palpate::ContactBody& body = bodyOf(static_cast<int>(state.range(0)), buildSeconds);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<Vector3> tips;
  for (int k = 0; k < 100000; ++k)
  {
    const double x = normal(random);
    const double y = normal(random);
    tips.push_back(tipAlong(Vector3(x, y, normal(random)).normalized()));
  }
  palpate::ToolContact contact(body);
  std::size_t i = 0;
  std::size_t contacts = 0;
  std::size_t ticks = 0;
  for (auto _ : state)
  {
    contact.reset();
    const palpate::ToolContactForce force = contact.update(tips[i]);
    contacts += force.state == palpate::ContactState::Slide;
    benchmark::DoNotOptimize(force.force);
    i = i + 1 < tips.size() ? i + 1 : 0;
    ++ticks;
  }
  describe(state, body, buildSeconds, contacts, ticks);
}
} // namespace

// 8 · 158² = 199 712 and 8 · 500² = 2 000 000 triangles.
BENCHMARK(SlidingTick)->Arg(158);
BENCHMARK(ContactOnset)->Arg(158);
BENCHMARK(SlidingTick)->Arg(500);
BENCHMARK(ContactOnset)->Arg(500);
