// SPDX-License-Identifier: BSD-3-Clause
// The cost of a tick for N coupled tools compared with N uncoupled tools. The tools move over a
// plate of 60 mm (20 thousand triangles) at a depth of 1 mm, on a half-space and on a layer.
#include "CoupledPlate.h"

#include "Contact/Coupled/CoupledContacts.h"
#include "Contact/ToolContact.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

namespace
{
using namespace palpate;
using namespace palpate::testing;

enum Kind : int
{
  Alone,
  OnHalfSpace,
  OnLayer
};

const ContactBody& bodyOf(Kind kind)
{
  static const auto make = [](Kind of)
  {
    CoupledPlate plate;
    plate.surface = openPlate(60.0, 100);
    plate.store = ResponseStore(plate.surface.points.size());
    const CouplingLaw law(LayerKernel(0.45, LayerBase::Bonded));
    plate.terms.thickness = of == OnLayer ? 10.0 : 0.0;
    plate.terms.knots = of == OnLayer ? law.knots().data() : nullptr;
    return plate.body(of != Alone);
  };
  static const std::unique_ptr<ContactBody> bodies[] = { make(Alone), make(OnHalfSpace),
    make(OnLayer) };
  return *bodies[kind];
}

/// Pose of tool i. It moves by 0.1 mm per tick.
ToolPose poseOf(std::size_t i, long tick)
{
  const double along = 0.1 * static_cast<double>(std::abs(tick % 80 - 40));
  return ToolPose(Vector3(6.0 + 11.0 * static_cast<double>(i % 5) + along,
    8.0 + 11.0 * static_cast<double>(i / 5), -1.0));
}

void tick(benchmark::State& state)
{
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto kind = static_cast<Kind>(state.range(1));
  const ContactBody& body = bodyOf(kind);
  CoupledContacts together(body, {}, count);
  std::vector<ToolContact> alone(count, ToolContact(body));
  std::vector<ToolPose> poses(count, ToolPose(Vector3::Zero()));
  long i = 0;
  double sum = 0.0;
  for (auto _ : state)
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      poses[k] = poseOf(k, i);
    }
    ++i;
    if (kind == Alone)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        sum += alone[k].update(poses[k]).normalForce;
      }
    }
    else
    {
      sum += together.update(poses.data())[0].normalForce;
    }
  }
  benchmark::DoNotOptimize(sum);
  state.SetLabel(kind == Alone ? "single"
      : kind == OnHalfSpace    ? "coupled, half-space"
                               : "coupled, layer");
}

void bound(benchmark::State& state)
{
  const auto count = static_cast<std::size_t>(state.range(0));
  CoupledContacts together(bodyOf(OnHalfSpace), {}, count);
  std::vector<ToolPose> poses;
  for (std::size_t k = 0; k < count; ++k)
  {
    poses.push_back(poseOf(k, 0));
  }
  together.settle(poses.data());
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(together.stiffening());
  }
}
} // namespace

BENCHMARK(tick)
  ->Name("TickOfSeveral")
  ->ArgNames({ "tools", "kind" })
  ->ArgsProduct({ { 2, 5, 20 }, { Alone, OnHalfSpace, OnLayer } });
BENCHMARK(bound)->Name("StiffnessOfSeveral")->ArgName("tools")->Arg(2)->Arg(5)->Arg(20);
