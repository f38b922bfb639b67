// SPDX-License-Identifier: BSD-3-Clause
// The cost of a tilted tool in a tick, compared with a tool without an axis and an upright tool.
// The tool moves over a plate of 60 mm (20 thousand triangles) at a depth of 1 mm. The response is
// one curve. The tilt data are one law for all points, or several laws with weights at each point.
#include "Contact/ToolContact.h"
#include "SampleResponses.h"
#include "SampleTilts.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace
{
using namespace palpate;
using namespace palpate::testing;

enum Kind : int
{
  NoAxis,
  Upright,
  Leaning
};

/// A plate under a ball of 5 mm that tilts up to 0.6 rad. With several laws, each law has its own
/// factor.
std::unique_ptr<ContactBody> plateOf(std::size_t laws)
{
  std::vector<TiltStore::Factor> factors;
  for (std::size_t law = 0; law < laws; ++law)
  {
    const double share = 0.5 + 0.5 * static_cast<double>(law) / static_cast<double>(laws);
    factors.emplace_back([share](double depth, double angle)
      { return 1.0 + share * angle * angle * (0.8 + 0.5 * depth); });
  }
  const TiltStore tilts(factors, dropOfSphere(5.0), 2.0, 0.6);
  const Surface surface = openPlate(60.0, 100);
  const ResponseStore store(surface.points.size());
  const std::vector<float> weight(
    laws * surface.points.size(), static_cast<float>(1.0 / static_cast<double>(laws)));
  ResponseArrays arrays = store.arrays();
  arrays.tilt = tilts.views;
  arrays.tilt.weight = laws > 1 ? weight.data() : nullptr;
  return std::make_unique<ContactBody>(surface.points.front().data(), surface.points.size(),
    surface.triangles.front().data(), surface.triangles.size(), arrays);
}

/// The pose moves by 0.1 mm at each tick.
ToolPose poseAt(long tick, Kind kind)
{
  const double along = 0.1 * static_cast<double>(std::abs(tick % 400 - 200));
  const Vector3 tip(20.0 + along, 31.3, -1.0);
  return kind == NoAxis ? ToolPose(tip)
    : kind == Upright   ? ToolPose(tip, Vector3::UnitZ())
                        : ToolPose(tip, Vector3(std::sin(0.2), 0.0, std::cos(0.2)));
}

void tick(benchmark::State& state)
{
  const auto kind = static_cast<Kind>(state.range(0));
  const auto body = plateOf(static_cast<std::size_t>(state.range(1)));
  ToolContact contact(*body);
  long i = 0;
  double sum = 0.0;
  for (auto _ : state)
  {
    sum += contact.update(poseAt(i++, kind)).normalForce;
  }
  benchmark::DoNotOptimize(sum);
  if (!(sum > 0.0))
  {
    state.SkipWithError("nothing was felt");
  }
  state.SetLabel(kind == NoAxis ? "no axis" : kind == Upright ? "upright" : "leaning");
}
} // namespace

BENCHMARK(tick)
  ->Name("TickOfLeaningTool")
  ->ArgNames({ "kind", "laws" })
  ->ArgsProduct({ { NoAxis, Upright, Leaning }, { 1, 4, 16 } });
