// SPDX-License-Identifier: BSD-3-Clause
// The cost of relaxation in a tick. A tip moves over a plate of 500 thousand triangles and is
// pressed up and down, on elastic and on relaxing bodies. Parameters: k branches and N elements.
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

std::unique_ptr<ContactBody> makeBody(int branches)
{
  const Surface surface = openPlate(50.0, 500);
  const ResponseStore store(surface.points.size());
  ResponseArrays arrays = store.arrays();
  for (int i = 0; i < branches; ++i)
  {
    arrays.relaxation.series.add(0.5, 0.02 * std::pow(10.0, i));
  }
  arrays.relaxation.exponent = 1.5;
  arrays.relaxation.radius = 2.5;
  return std::make_unique<ContactBody>(surface.points.front().data(), surface.points.size(),
    surface.triangles.front().data(), surface.triangles.size(), arrays);
}

/// The depth varies from 1 to 1.9 mm in a range of 2 mm. The tip moves by 0.1 mm per tick along the
/// surface, at 1 kHz.
void tick(benchmark::State& state)
{
  const auto body = makeBody(static_cast<int>(state.range(0)));
  ContactSettings settings;
  settings.relaxationElements = static_cast<int>(state.range(1));
  ToolContact contact(*body, settings);
  long i = 0;
  double sum = 0.0;
  contact.update({ 5.0, 25.0, 0.1 }, 1e-3);
  for (auto _ : state)
  {
    const double x = 15.0 + 0.1 * static_cast<double>(std::abs(i % 200 - 100));
    const double depth = 1.0 + 0.001 * static_cast<double>(i % 900);
    ++i;
    sum += contact.update({ x, 25.03, -depth }, 1e-3).normalForce;
  }
  benchmark::DoNotOptimize(sum);
}
} // namespace

BENCHMARK(tick)
  ->Name("TickOfRelaxingBody")
  ->ArgNames({ "branches", "elements" })
  ->Args({ 0, 16 })
  ->Args({ 2, 0 })
  ->Args({ 2, 8 })
  ->Args({ 2, 16 })
  ->Args({ 4, 16 })
  ->Args({ 2, 32 });
