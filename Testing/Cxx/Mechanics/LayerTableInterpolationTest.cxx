// SPDX-License-Identifier: BSD-3-Clause
// Curves interpolated over thickness and Poisson's ratio, against the exact layer of each thickness
// and ratio.
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Layers/LayerTable.h"

#include "Agreement.h"
#include "TestTools.h"

#include <limits>
#include <map>
#include <random>

using palpate::LayerBase;
using palpate::LayerContact;
using palpate::LayerKernel;
using palpate::LayerTable;
using palpate::testing::agrees;
using palpate::testing::tool;

namespace
{
const std::vector<double> Depths = { 0.03, 0.5, 2.0 };

/// Returns a kernel from a cache, because a kernel takes 20 ms to build.
std::shared_ptr<const LayerKernel> kernelOf(double nu, LayerBase base)
{
  static std::map<std::pair<double, LayerBase>, std::shared_ptr<const LayerKernel>> kernels;
  auto& kernel = kernels[{ nu, base }];
  if (!kernel)
  {
    kernel = std::make_shared<const LayerKernel>(nu, base);
  }
  return kernel;
}

void expectExact(const palpate::AxisymmetricTool& pressed, const LayerTable& table, LayerBase base,
  double thickness, double nu, double tolerance)
{
  const LayerContact contact(pressed, kernelOf(nu, base), thickness);
  const LayerTable::Curve curve = table.sample(thickness, nu);
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    const auto exact = contact.evaluate(Depths[static_cast<std::size_t>(i)], 1.0);
    EXPECT_TRUE(agrees(curve(i, 2), exact.contactRadius, tolerance)) << "h = " << thickness;
    EXPECT_TRUE(agrees(curve(i, 0), exact.force, tolerance)) << "h = " << thickness;
    EXPECT_TRUE(agrees(curve(i, 1), exact.stiffness, tolerance)) << "h = " << thickness;
  }
}
} // namespace

TEST(LayerTable, AnyThickness)
{
  std::mt19937 random(7);
  for (const char* name : { "flat:1.6", "paraboloid:6.35", "sphere:6.35", "cone:60" })
  {
    const auto pressed = tool(name);
    for (const double nu : { 0.0, 0.45, 0.5 })
    {
      SCOPED_TRACE(std::string(name) + ", nu = " + std::to_string(nu));
      const LayerTable table(*pressed, { LayerBase::Bonded, 0.01, 200.0, { nu } }, Depths);
      EXPECT_FALSE(table.answers(0.01)); // a/h > 10
      int answered = 0;
      for (int i = 0; i < 12; ++i)
      {
        const double thickness =
          0.1 * std::exp(std::uniform_real_distribution<double>(0.0, 7.6)(random));
        if (table.answers(thickness))
        {
          // 1e-7: guaranteed error
          expectExact(*pressed, table, LayerBase::Bonded, thickness, nu, 1e-7);
          ++answered;
        }
      }
      EXPECT_GT(answered, 6);
    }
  }
}

TEST(LayerTable, OneThicknessAndInfinite)
{
  const auto pressed = tool("sphere:6.35");
  const LayerTable one(*pressed, { LayerBase::Slip, 3.0, 3.0, { 0.3 } }, Depths);
  expectExact(*pressed, one, LayerBase::Slip, 3.0, 0.3, 1e-9);

  const double infinity = std::numeric_limits<double>::infinity();
  const LayerTable wide(*pressed, { LayerBase::Bonded, 3.0, infinity, { 0.3 } }, Depths);
  expectExact(*pressed, wide, LayerBase::Bonded, 1e5, 0.3, 1e-7);
  EXPECT_TRUE(agrees(wide.sample(infinity, 0.3)(2, 0), pressed->force(2.0, 1.0), 1e-7));
}

TEST(LayerTable, SeveralPoissonsRatios)
{
  const auto pressed = tool("paraboloid:6.35");
  const LayerTable distinct(*pressed, { LayerBase::Bonded, 2.0, 9.0, { 0.1, 0.3, 0.499 } }, Depths);
  for (const double nu : { 0.1, 0.3, 0.499 })
  {
    expectExact(*pressed, distinct, LayerBase::Bonded, 4.4, nu, 1e-7);
  }
  EXPECT_TRUE(std::isnan(distinct.sample(4.4, 0.2)(0, 0))); // this ratio was not in the list

  std::vector<double> many;
  for (int i = 0; i <= 100; ++i)
  {
    many.push_back(0.005 * i);
  }
  const LayerTable continuous(*pressed, { LayerBase::Bonded, 2.0, 9.0, many }, Depths);
  for (const double nu : { 0.0, 0.123, 0.4, 0.49, 0.5 })
  {
    expectExact(*pressed, continuous, LayerBase::Bonded, 2.0, nu, 1e-5); // a/h up to 2.2
    expectExact(*pressed, continuous, LayerBase::Bonded, 6.1, nu, 1e-7);
  }
}

TEST(LayerTable, TooThin)
{
  const auto pressed = tool("flat:2");
  const LayerTable table(*pressed, { LayerBase::Bonded, 0.05, 5.0, { 0.3 } }, Depths);
  EXPECT_FALSE(table.answers(0.199));
  EXPECT_TRUE(table.answers(0.201));
  EXPECT_TRUE(std::isnan(table.sample(0.1, 0.3)(0, 0)));
  expectExact(*pressed, table, LayerBase::Bonded, 0.201, 0.3, 1e-7);
}
