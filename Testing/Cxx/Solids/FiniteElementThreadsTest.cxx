// SPDX-License-Identifier: BSD-3-Clause
// The number of threads, of the kernels or of OpenBLAS, changes no bit of a finite-element result.
#include "ElasticBlocks.h"
#include "Solids/FiniteElements/PatchCompliance.h"
#include "Sanitized.h"
#include "Mechanics/ThreadCount.h"

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

// Functions of OpenBLAS; null if another BLAS is linked.
extern "C"
{
  __attribute__((weak)) int openblas_get_num_threads();
  __attribute__((weak)) void openblas_set_num_threads(int count);
}

namespace
{
using namespace palpate;

#ifdef PALPATE_SANITIZED
constexpr int Side = 4; // side of the block, mm
#else
constexpr int Side = 8;
#endif

bool always(double)
{
  return true;
}

/// Sets the number of threads of OpenBLAS and restores it in the destructor.
class BlasThreads
{
public:
  explicit BlasThreads(int count)
    : Before(isThere() ? openblas_get_num_threads() : 0)
  {
    set(count);
  }
  ~BlasThreads() { set(this->Before); }
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

  static bool isThere()
  {
    return openblas_get_num_threads != nullptr && openblas_set_num_threads != nullptr;
  }

private:
  static void set(int count)
  {
    if (isThere())
    {
      openblas_set_num_threads(count);
    }
  }

  int Before;
};

/// A bonded block with the compliances at all surface points, and a solution.
struct Block
{
  ElasticBodyInput input;

  Block()
  {
    this->input.mesh = palpate::testing::hexahedronBlock(Side, Side, 4, 1.0);
    this->input.fixed = palpate::testing::heldBelow(this->input.mesh);
    this->input.materials = { { 1.0, 0.3 } };
  }

  std::vector<double> solved() const
  {
    ElasticBody body;
    EXPECT_EQ(body.assemble(ElasticBodyInput(this->input)), "");
    EXPECT_EQ(body.analyse(StiffnessFactor::Kind::Automatic), "");
    EXPECT_EQ(body.factorise(), "");
    std::vector<std::int32_t> points;
    for (std::int32_t i = 0; i < body.surface().pointTotal(); ++i)
    {
      points.push_back(i);
    }
    const PatchCompliances found = patchCompliances(body, points, 0.0, always);
    std::vector<double> numbers = found.compliance;
    const Eigen::Matrix3Xd moved = body.displacement(patchForces(body, points.back(), 0.0));
    numbers.insert(numbers.end(), moved.data(), moved.data() + moved.size());
    return numbers;
  }
};

bool sameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), 8 * a.size()) == 0;
}
} // namespace

TEST(FiniteElementThreads, SameBitsForAnyNumber)
{
  const Block block;
  std::vector<double> alone;
  for (const int threads : { 1, 2, 8 })
  {
    const ThreadLimit limit(static_cast<std::size_t>(threads));
    const BlasThreads blas(threads);
    const std::vector<double> found = block.solved();
    alone = threads == 1 ? found : alone;
    ASSERT_GT(found.size(), 400U);
    EXPECT_TRUE(sameBits(found, alone)) << threads << " threads";
    if (BlasThreads::isThere())
    {
      EXPECT_EQ(openblas_get_num_threads(), threads); // the setting of the host is restored
    }
  }
}

TEST(FiniteElementThreads, TwoBodiesAtOnceLeaveTheSettingOfTheHost)
{
  const Block block;
  const std::vector<double> alone = block.solved();
  const BlasThreads blas(2);
  std::vector<double> beside;
  std::thread other([&] { beside = block.solved(); });
  const std::vector<double> here = block.solved();
  other.join();
  EXPECT_TRUE(sameBits(here, alone) && sameBits(beside, alone));
  if (BlasThreads::isThere())
  {
    EXPECT_EQ(openblas_get_num_threads(), 2);
  }
}
