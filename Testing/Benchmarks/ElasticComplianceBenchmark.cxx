// SPDX-License-Identifier: BSD-3-Clause
// Structural compliance of a body of 95 thousand unknowns, a block of 31 × 31 × 31 hexahedra.
// Measured are the factorisation, and the compliance at all points of the surface with both
// patches. `ratio`: time relative to the factorisation of the same run. `cut_s`: patches and
// cut-outs; `self_s`: self-terms; `body_s`: half-solves. Irregular: the same block with moved
// nodes, so that no two cut-outs are equal.
//
// Ways to compute bᵀK⁻¹b, measured on such a block on two cores (9736 loads; factorisation 3.7 to
// 3.9 s):
//   forward along the elimination tree, blocks of 64 loads shared among threads, BLAS single 5.5 s
//   the same with blocks of 128 / 256                                                 7.2 / 6.0 s
//   blocks of 128, one after the other, OpenBLAS on two threads                            12.0 s
//   full solutions, one by one: 94 ms each                                           15 minutes
#include "Solids/FiniteElements/PatchCompliance.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <numeric>

namespace
{
using namespace palpate;

constexpr int Side = 31;

ElasticBodyInput block(double irregularity)
{
  ElasticBodyInput input;
  VolumeMesh& mesh = input.mesh;
  mesh.nodes.resize(3, (Side + 1) * (Side + 1) * (Side + 1));
  const auto id = [](int i, int j, int k) { return (k * (Side + 1) + j) * (Side + 1) + i; };
  for (int k = 0; k <= Side; ++k)
  {
    for (int j = 0; j <= Side; ++j)
    {
      for (int i = 0; i <= Side; ++i)
      {
        const double t = id(i, j, k);
        mesh.nodes.col(id(i, j, k)) << i + irregularity * std::sin(1.1 * t),
          j + irregularity * std::sin(1.7 * t), k + irregularity * std::sin(2.3 * t);
        input.fixed.push_back(k == 0 ? 7 : 0);
        if (i < Side && j < Side && k < Side)
        {
          VolumeElement element;
          element.nodes = { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
            id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1) };
          mesh.elements.push_back(element);
        }
      }
    }
  }
  input.materials = { { 0.1, 0.45 } };
  return input;
}

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void elasticCompliance(benchmark::State& state, double irregularity)
{
  for (auto _ : state)
  {
    ElasticBody body;
    std::string error = body.assemble(block(irregularity));
    error += body.analyse(StiffnessFactor::Kind::Automatic);
    const double start = now();
    error += body.factorise();
    const double factorised = now();
    if (!error.empty())
    {
      state.SkipWithError(error.c_str());
      return;
    }
    std::vector<std::int32_t> points(static_cast<std::size_t>(body.surface().pointTotal()));
    std::iota(points.begin(), points.end(), 0);
    double cut = 0.0;
    double self = 0.0;
    const PatchCompliances found = patchCompliances(body, points, 0.0,
      [&](double done)
      {
        cut = done <= 0.1 ? now() : cut;
        self = done <= 0.3 ? now() : self;
        return true;
      });
    const double end = now();
    benchmark::DoNotOptimize(found.compliance.data());
    state.SetIterationTime(end - factorised);
    state.counters["unknowns"] = body.unknowns();
    state.counters["points"] = body.surface().pointTotal();
    state.counters["factorise_s"] = factorised - start;
    state.counters["cut_s"] = cut - factorised;
    state.counters["self_s"] = self - cut;
    state.counters["body_s"] = end - self;
    state.counters["ratio"] = (end - factorised) / (factorised - start);
    state.counters["memory_MiB"] = body.memoryEstimate() / 1024.0 / 1024.0;
  }
}

void ElasticComplianceOfAllPoints(benchmark::State& state)
{
  elasticCompliance(state, 0.0);
}
void ElasticComplianceIrregular(benchmark::State& state)
{
  elasticCompliance(state, 0.1);
}
} // namespace

BENCHMARK(ElasticComplianceOfAllPoints)->UseManualTime()->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK(ElasticComplianceIrregular)->UseManualTime()->Unit(benchmark::kSecond)->Iterations(1);
