// SPDX-License-Identifier: BSD-3-Clause
// The cost of sharp edges in a tick. A tip moves over a block of 40 mm (200 thousand triangles)
// with and without the edge law: in the middle, where the edges have no effect; near an edge; and
// near a blunt edge (of a hexagonal prism).
#include "SampleResponses.h"
#include "Contact/ContactBody.h"
#include "Contact/ToolContact.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

namespace
{
using namespace palpate;
using namespace palpate::testing;

enum Place : int
{
  OutOfReach,
  BesideSharp,
  BesideBlunt
};

std::unique_ptr<ContactBody> makeBody(Place place, bool hasEdges)
{
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < (place == BesideBlunt ? 6 : 4); ++i)
  {
    const double angle = place == BesideBlunt ? M_PI / 3.0 * i : M_PI / 2.0 * (i + 0.5);
    corners.emplace_back(28.0 * std::cos(angle), 28.0 * std::sin(angle));
  }
  std::vector<std::array<std::int32_t, 3>> caps;
  for (std::int32_t i = 2; i < static_cast<std::int32_t>(corners.size()); ++i)
  {
    caps.push_back({ 0, i - 1, i });
  }
  const Surface surface = subdivided(prism(corners, caps, 40.0), 7);
  ResponseStore store(surface.points.size());
  takeMeshNormals(store, surface);
  ResponseArrays arrays = store.arrays();
  if (hasEdges)
  {
    arrays.edges = sphereOverEdges();
    arrays.edges.extent = 9.0; // mm, as on a layer of 7 mm; the middle is 20 mm from the edges
  }
  return std::make_unique<ContactBody>(surface.points.front().data(), surface.points.size(),
    surface.triangles.front().data(), surface.triangles.size(), arrays);
}

/// The tip is 1 mm deep and moves back and forth along z, 0.1 mm per tick.
void tick(benchmark::State& state)
{
  const auto place = static_cast<Place>(state.range(0));
  const auto body = makeBody(place, state.range(1) != 0);
  ToolContact contact(*body);
  const double face = place == BesideBlunt ? 28.0 * std::cos(M_PI / 6.0) : 28.0 / std::sqrt(2.0);
  const double turn = place == BesideBlunt ? M_PI / 6.0 : 0.0;
  const double away = place == OutOfReach ? 0.3
    : place == BesideSharp                ? 28.0 / std::sqrt(2.0) - 1.0
                                          : 13.5;
  const Vector3 out(std::cos(turn), std::sin(turn), 0.0);
  const Vector3 along(-std::sin(turn), std::cos(turn), 0.0);
  long i = 0;
  double sum = 0.0;
  contact.update((face + 0.1) * out + away * along + Vector3(0.0, 0.0, 15.0));
  for (auto _ : state)
  {
    const double z = 15.0 + 0.1 * static_cast<double>(std::abs(i++ % 200 - 100));
    sum += contact.update((face - 1.0) * out + away * along + Vector3(0.0, 0.0, z)).normalForce;
  }
  benchmark::DoNotOptimize(sum);
  state.SetLabel(place == OutOfReach ? "out of reach"
      : place == BesideSharp         ? "beside a sharp edge"
                                     : "beside a blunt edge");
}

void bodyBuild(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(makeBody(BesideSharp, state.range(0) != 0));
  }
}
} // namespace

BENCHMARK(tick)
  ->Name("TickNearEdges")
  ->ArgNames({ "place", "edges" })
  ->ArgsProduct({ { OutOfReach, BesideSharp, BesideBlunt }, { 0, 1 } });
BENCHMARK(bodyBuild)
  ->Name("BuildWithEdges")
  ->ArgName("edges")
  ->Arg(0)
  ->Arg(1)
  ->Unit(benchmark::kMillisecond);
