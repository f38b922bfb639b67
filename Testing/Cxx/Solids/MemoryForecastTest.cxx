// SPDX-License-Identifier: BSD-3-Clause
// Forecast of the memory of finite elements: the estimate from counts of nodes against the symbolic
// analysis, and the symbolic analysis against the memory of the factorisation.
#include "Mechanics/Numerics/AvailableMemory.h"
#include "ElasticBlocks.h"
#include "Solids/FiniteElements/MemoryForecast.h"
#include "ProcessMemory.h"
#include "Sanitized.h"
#include "ScratchFile.h"

#include <gtest/gtest.h>

#include <malloc.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

namespace palpate::testing
{
namespace
{
ElasticBodyInput blockInput(int nx, int ny, int nz)
{
  ElasticBodyInput input;
  input.mesh = hexahedronBlock(nx, ny, nz, 1.0);
  input.fixed = heldBelow(input.mesh);
  input.materials = { { 1.0, 0.3 } };
  return input;
}
} // namespace

TEST(MemoryForecast, IsThatOfTheSymbolicAnalysisWithinItsError)
{
  if (!StiffnessFactor::make(StiffnessFactor::Kind::Supernodal))
  {
    GTEST_SKIP() << "built without CHOLMOD";
  }
  // Cubes, plates and bars, which differ by a factor of 40 in the number of nodes and of 8 in
  // thickness.
  const std::array<std::array<int, 3>, 6> sizes = { { { 10, 10, 10 }, { 16, 16, 16 },
    { 24, 24, 24 }, { 60, 60, 4 }, { 40, 40, 8 }, { 6, 6, 200 } } };
  for (const auto& [nx, ny, nz] : sizes)
  {
    ElasticBody body;
    ASSERT_EQ(body.assemble(blockInput(nx, ny, nz)), "");
    ASSERT_EQ(body.analyse(StiffnessFactor::Kind::Supernodal), "");
    const double told = body.memoryForecast().factor;
    EXPECT_LT(
      std::abs(std::log(told / body.memoryEstimate())), std::log(MemoryForecast::ForecastError))
      << nx << " " << ny << " " << nz << ": " << told << " for " << body.memoryEstimate();
  }
}

TEST(MemoryForecast, TheEstimateIsWhatTheFactorisationTakes)
{
#ifdef PALPATE_SANITIZED
  GTEST_SKIP() << "the sanitizer has a malloc of its own";
#endif
  ElasticBody body;
  ASSERT_EQ(body.assemble(blockInput(18, 18, 18)), "");
  ASSERT_EQ(body.analyse(StiffnessFactor::Kind::Automatic), "");
  malloc_trim(0);
  resetPeakMemory();
  const double before = peakMemory();
  ASSERT_EQ(body.factorise(), "");
  // 110 MB, plus blocks packed by BLAS and memory that malloc keeps.
  EXPECT_NEAR((peakMemory() - before) / body.memoryEstimate(), 1.0, 0.2);
}

TEST(MemoryForecast, GrowsAsTheFourThirdsPowerOfACube)
{
  const auto factorOf = [](double side)
  { return forecastMemory(std::pow(side, 3), 6.0 * side * side).factor; };
  EXPECT_NEAR(factorOf(80.0) / factorOf(40.0), std::pow(8.0, 4.0 / 3.0), 1e-9);
  EXPECT_FALSE(forecastMemory(1e6, 6e4).exceeds(std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(forecastMemory(1e12, 6e8).exceeds(1e15));
  EXPECT_FALSE(forecastMemory(0.0, 0.0).exceeds(1.0));
}

TEST(AvailableMemory, IsWhatTheKernelSays)
{
  const ScratchFile file(".meminfo");
  std::ofstream(file.path()) << "MemTotal:       24600000 kB\nMemFree:        1000 kB\n"
                                "MemAvailable:   123456 kB\nHugePages_Total:       0\n";
  EXPECT_EQ(availableMemory(file.path()), 123456.0 * 1024.0);
  const double machine =
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  EXPECT_EQ(availableMemory("/nowhere/meminfo"), 0.5 * machine);
  EXPECT_GT(availableMemory(), 0.0);
  EXPECT_LE(availableMemory(), machine);
}
} // namespace palpate::testing
