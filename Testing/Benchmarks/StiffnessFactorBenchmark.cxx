// SPDX-License-Identifier: BSD-3-Clause
// Compares two forward solutions of blocks with the same number of loads: a walk over CHOLMOD's
// supernodes that visits only the paths of the loads, and CHOLMOD's own solution. `ratio`:
// CHOLMOD's time divided by the time of the walk, in the same run, in one thread. For one load and
// for the loads of a face of a block of 31 × 31 × 31 hexahedra, 95 thousand unknowns.
//
//   OPENBLAS_NUM_THREADS=1 palpateBenchmarks --benchmark_filter=CompliancesOfLoads
//
// One load: walk 151 ms, CHOLMOD 446 ms, ratio 2.9. 900 loads: walk 10.8 s, CHOLMOD 70.7 s, ratio
// 6.6 (2.8 GHz, with a build running at the same time).
#include "Solids/FiniteElements/StiffnessFactor.h"
#include "Mechanics/ThreadCount.h"

#include "ElasticBlocks.h"

#include <benchmark/benchmark.h>
#include <cholmod.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace
{
using namespace palpate;

constexpr int Side = 31;
constexpr std::size_t Block = 64; // loads per block, as in StiffnessFactor

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A stiffness matrix with both factorisations. Each load acts on the nine nodes around a node of
/// its upper face.
struct Problem
{
  StiffnessMatrix stiffness;
  std::vector<SparseLoad> loads;
  std::unique_ptr<StiffnessFactor> own;
  cholmod_common common{};
  cholmod_factor* factor = nullptr;

  Problem()
  {
    const VolumeMesh mesh = palpate::testing::hexahedronBlock(Side, Side, Side, 1.0);
    MeshTopology topology;
    topology.build(mesh);
    assembleStiffness(
      mesh, topology, { { 0.1, 0.45 } }, palpate::testing::heldBelow(mesh), this->stiffness);
    this->own = StiffnessFactor::make(StiffnessFactor::Kind::Supernodal);
    this->own->analyse(this->stiffness.lower);
    this->own->factorise(this->stiffness.lower);
    cholmod_start(&this->common);
    this->common.supernodal = CHOLMOD_SUPERNODAL;
    this->common.final_ll = 1;
    this->common.nmethods = 1;
    this->common.method[0].ordering = CHOLMOD_METIS;
    auto& lower = this->stiffness.lower;
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(lower.rows());
    matrix.nzmax = static_cast<std::size_t>(lower.nonZeros());
    matrix.p = lower.outerIndexPtr();
    matrix.i = lower.innerIndexPtr();
    matrix.x = lower.valuePtr();
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.sorted = matrix.packed = 1;
    this->factor = cholmod_analyze(&matrix, &this->common);
    cholmod_factorize(&matrix, this->factor, &this->common);
    for (int j = 1; j < Side; ++j)
    {
      for (int i = 1; i < Side; ++i)
      {
        SparseLoad load;
        for (int around = 0; around < 9; ++around)
        {
          const int node =
            (Side * (Side + 1) + j + around / 3 - 1) * (Side + 1) + i + around % 3 - 1;
          load.emplace_back(this->stiffness.dof[static_cast<std::size_t>(3 * node + 2)], 1.0);
        }
        this->loads.push_back(load);
      }
    }
  }

  static Problem& get()
  {
    static Problem problem;
    return problem;
  }
};

/// Computes |L⁻¹ P b|² with CHOLMOD's solver, which visits all of L for each block.
std::vector<double> byCholmod(Problem& problem, const std::vector<SparseLoad>& loads)
{
  const auto n = problem.factor->n;
  std::vector<std::size_t> position(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    position[static_cast<std::size_t>(static_cast<const int*>(problem.factor->Perm)[i])] = i;
  }
  std::vector<double> result;
  for (std::size_t first = 0; first < loads.size(); first += Block)
  {
    const std::size_t count = std::min(Block, loads.size() - first);
    Eigen::MatrixXd right =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < count; ++k)
    {
      for (const auto& [unknown, force] : loads[first + k])
      {
        right(static_cast<Eigen::Index>(position[static_cast<std::size_t>(unknown)]),
          static_cast<Eigen::Index>(k)) += force;
      }
    }
    cholmod_dense b{};
    b.nrow = b.d = n;
    b.ncol = count;
    b.nzmax = n * count;
    b.x = right.data();
    b.xtype = CHOLMOD_REAL;
    cholmod_dense* x = cholmod_solve(CHOLMOD_L, problem.factor, &b, &problem.common);
    for (std::size_t k = 0; k < count; ++k)
    {
      result.push_back(Eigen::Map<const Eigen::VectorXd>(
        static_cast<const double*>(x->x) + k * n, static_cast<Eigen::Index>(n))
                         .squaredNorm());
    }
    cholmod_free_dense(&x, &problem.common);
  }
  return result;
}

void CompliancesOfLoads(benchmark::State& state)
{
  const ThreadLimit one(1);
  Problem& problem = Problem::get();
  const std::vector<SparseLoad> loads(
    problem.loads.begin(), state.range(0) == 1 ? problem.loads.begin() + 1 : problem.loads.end());
  double ours = 0.0;
  double theirs = 0.0;
  double difference = 0.0;
  for (auto _ : state)
  {
    const double start = now();
    const std::vector<double> found = problem.own->compliances(loads, [](double) { return true; });
    const double between = now();
    const std::vector<double> expected = byCholmod(problem, loads);
    const double end = now();
    ours += between - start;
    theirs += end - between;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      difference = std::max(difference, std::abs(found[i] / expected[i] - 1.0));
    }
    state.SetIterationTime(between - start);
  }
  state.counters["loads"] = static_cast<double>(loads.size());
  state.counters["cholmod_s"] = theirs / static_cast<double>(state.iterations());
  state.counters["ratio"] = theirs / ours;
  state.counters["difference"] = difference;
}
} // namespace

BENCHMARK(CompliancesOfLoads)
  ->Arg(1)
  ->Iterations(20)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(CompliancesOfLoads)
  ->Arg(2)
  ->Iterations(2)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
