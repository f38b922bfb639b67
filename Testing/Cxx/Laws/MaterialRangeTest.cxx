// SPDX-License-Identifier: BSD-3-Clause
// The range of materials for which a law is prepared, over all points of a body in one piece or in
// several.
#include "Laws/MaterialRange.h"

#include "Mechanics/Layers/LayerTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace palpate;

namespace
{
void expectSame(const MaterialRange& one, const MaterialRange& other)
{
  EXPECT_EQ(one.layers.thinnest, other.layers.thinnest);
  EXPECT_EQ(one.layers.thickest, other.layers.thickest);
  EXPECT_EQ(one.layers.poissonRatios, other.layers.poissonRatios);
  EXPECT_EQ(one.uncertain.thinnest, other.uncertain.thinnest);
  EXPECT_EQ(one.uncertain.thickest, other.uncertain.thickest);
  EXPECT_EQ(one.uncertain.poissonRatios, other.uncertain.poissonRatios);
  EXPECT_EQ(one.stiffens, other.stiffens);
  ASSERT_EQ(one.extremes.size(), other.extremes.size());
  for (std::size_t i = 0; i < one.extremes.size(); ++i)
  {
    EXPECT_EQ(one.extremes[i].compliance, other.extremes[i].compliance);
    EXPECT_EQ(one.extremes[i].thickness, other.extremes[i].thickness);
  }
}
} // namespace

TEST(MaterialRange, NoPointHasNoLayer)
{
  const MaterialRange none(LayerBase::Slip);
  EXPECT_FALSE(none.hasLayers());
  EXPECT_TRUE(none.extremes.empty());
  EXPECT_EQ(none.layers.base, LayerBase::Slip);
}

TEST(MaterialRange, FindsTheExtremes)
{
  MaterialRange range(LayerBase::Bonded);
  range.add({ 0.1, 0.45, 1.0, 0.0 });
  range.add({ 0.1, 0.30, -2.0, 3.0 });
  range.add({ 0.2, 0.45, 4.0, 7.0 });
  EXPECT_TRUE(range.hasLayers());
  EXPECT_EQ(range.layers.thinnest, 3.0);
  EXPECT_EQ(range.layers.thickest, 7.0);
  EXPECT_EQ(range.layers.poissonRatios, (std::vector<double>{ 0.30, 0.45 }));
  EXPECT_TRUE(range.stiffens);
  EXPECT_EQ(range.extremes[0].compliance, -2.0); // smallest E* C
  EXPECT_EQ(range.extremes[1].compliance, 4.0);
  EXPECT_EQ(range.extremes[2].thickness, 3.0);
  EXPECT_EQ(range.extremes[3].thickness, 0.0); // a half-space counts as thicker than any layer
}

TEST(MaterialRange, PiecesJoinToTheWhole)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  MaterialRange whole(LayerBase::Bonded);
  MaterialRange joined(LayerBase::Bonded);
  for (int piece = 0; piece < 5; ++piece)
  {
    MaterialRange own(LayerBase::Bonded);
    for (int i = 0; i < 6; ++i)
    {
      ContactSpot spot{ 0.1, 0.25 + 0.2 * any(random), any(random), 2.0 + any(random) };
      spot.thicknessError = std::max(0.0, any(random));
      whole.add(spot);
      own.add(spot);
    }
    joined.join(own);
  }
  expectSame(joined, whole);
  joined.join(MaterialRange(LayerBase::Bonded)); // a process without points
  expectSame(joined, whole);
}

/// 1/h of 2 mm and of a half-space, each with an error of 0.3/mm: 0.8/mm and 0.3/mm.
TEST(MaterialRange, ErrorsOfThicknessesHaveARangeOfTheirOwn)
{
  MaterialRange range(LayerBase::Bonded);
  ContactSpot spot{ 0.1, 0.45, 0.0, 5.0 };
  range.add(spot);
  EXPECT_FALSE(range.isUncertain());
  spot.thicknessError = 0.3;
  spot.thickness = 2.0;
  range.add(spot);
  spot.thickness = 0.0;
  range.add(spot);
  ASSERT_TRUE(range.isUncertain());
  EXPECT_DOUBLE_EQ(range.uncertain.thinnest, 1.0 / 0.8);
  EXPECT_DOUBLE_EQ(range.uncertain.thickest, 1.0 / 0.3);
  EXPECT_EQ(range.layers.thinnest, 2.0);
  EXPECT_EQ(range.layers.thickest, 5.0);
}

TEST(MaterialRange, OfManyRatiosTheRangeIsKept)
{
  MaterialRange range(LayerBase::Bonded);
  const int many = 3 * LayerTable::DistinctRatios;
  for (int i = 0; i <= many; ++i)
  {
    range.add({ 0.1, 0.5 * ((7 * i) % (many + 1)) / many, 0.0, 1.0 });
  }
  EXPECT_EQ(range.layers.poissonRatios.front(), 0.0);
  EXPECT_EQ(range.layers.poissonRatios.back(), 0.5);
  EXPECT_GT(static_cast<int>(range.layers.poissonRatios.size()), LayerTable::DistinctRatios);
}
