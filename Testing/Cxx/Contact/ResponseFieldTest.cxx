// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ResponseField.h"

#include "SampleResponses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using palpate::ResponseArrays;
using palpate::ResponseField;
using palpate::ResponseStatus;
using palpate::ResponseValue;
using palpate::Vector3;
using palpate::testing::ContractCurve;
using palpate::testing::ContractValue;
using palpate::testing::ResponseStore;

namespace
{
/// `points` responses in the compact form, which combine `laws` random curves.
struct Compact
{
  Compact(int laws, std::size_t points)
    : laws_(laws)
    , store(points)
  {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> share(0.1F, 1.0F);
    for (int k = 0; k < laws; ++k)
    {
      float force = 0.0F;
      for (int i = 0; i < 8; ++i)
      {
        force += share(random);
        this->basis.push_back(force);
      }
      for (int i = 0; i < 8; ++i)
      {
        this->basis.push_back(share(random));
      }
    }
    for (std::size_t i = 0; i < points * static_cast<std::size_t>(laws); ++i)
    {
      this->coefficient.push_back(share(random));
    }
  }
  ResponseArrays arrays() const
  {
    ResponseArrays arrays = this->store.arrays();
    arrays.force = nullptr;
    arrays.stiffness = nullptr;
    arrays.laws = this->laws_;
    arrays.basis = this->basis.data();
    arrays.coefficient = this->coefficient.data();
    return arrays;
  }
  int laws_;
  ResponseStore store;
  std::vector<float> basis;
  std::vector<float> coefficient;
};
} // namespace

TEST(ResponseField, EvaluatesEachPointsOwnCurve)
{
  ResponseStore store(40);
  store.randomize(12);
  const ResponseField field(store.arrays());
  EXPECT_EQ(field.pointCount(), 40u);
  for (std::size_t i = 0; i < 40; ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    EXPECT_TRUE(field.isValid(point));
    EXPECT_EQ(field.normal(point), store.normalOf(i));
    const ContractCurve contract = store.curveOf(i);
    for (const double depth : { -0.1, 0.0, 1e-4, 0.02, 0.3, 0.9, 1.4, 2.5, 7.0 })
    {
      const ResponseValue value = field.evaluate(point, depth);
      const ContractValue expected = contract.evaluate(depth);
      EXPECT_NEAR(value.force, expected.force, 1e-12 * (1.0 + std::abs(expected.force)));
      EXPECT_NEAR(
        value.stiffness, expected.stiffness, 1e-10 * (1.0 + std::abs(expected.stiffness)));
      EXPECT_EQ(value.beyondRange, expected.beyondRange);
    }
  }
}

TEST(ResponseField, CompactFormAgreesWithPerPointForm)
{
  for (const int laws : { 1, 2 })
  {
    const std::size_t points = 30;
    Compact compact(laws, points);
    ResponseStore expanded = compact.store;
    for (std::size_t i = 0; i < points; ++i)
    {
      for (std::size_t column = 0; column < 16; ++column)
      {
        double sum = 0.0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(laws); ++k)
        {
          sum += static_cast<double>(compact.coefficient[i * static_cast<std::size_t>(laws) + k]) *
            static_cast<double>(compact.basis[k * 16 + column]);
        }
        (column < 8 ? expanded.force[8 * i + column] : expanded.stiffness[8 * i + column - 8]) =
          static_cast<float>(sum);
      }
    }
    const ResponseField a(compact.arrays());
    const ResponseField b(expanded.arrays());
    EXPECT_EQ(a.pointCount(), points);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(points); ++i)
    {
      EXPECT_TRUE(a.isValid(i));
      EXPECT_EQ(a.normal(i), b.normal(i));
      for (const double depth : { 0.001, 0.1, 0.77, 1.3, 3.0 })
      {
        const ResponseValue va = a.evaluate(i, depth);
        const ResponseValue vb = b.evaluate(i, depth);
        // The expanded samples were rounded to float32 (6e-8). The interpolation multiplies this
        // error by up to 10, and for the stiffness by n² more.
        EXPECT_NEAR(va.force, vb.force, 1e-6 * vb.force + 1e-9);
        EXPECT_NEAR(va.stiffness, vb.stiffness, 3e-5 * (1.0 + std::abs(vb.stiffness)));
        EXPECT_EQ(va.beyondRange, vb.beyondRange);
      }
    }
  }
}

TEST(ResponseField, OneCoefficientForAllIsStoredOnce)
{
  Compact compact(1, 12);
  compact.coefficient.assign(12, 0.75F);
  const ResponseField shared(compact.arrays());
  EXPECT_EQ(shared.memory(), 12u * 4 * sizeof(float));
  compact.store.status[5] = 1; // without a response its coefficient has no effect
  compact.coefficient[5] = 0.0F;
  EXPECT_EQ(ResponseField(compact.arrays()).memory(), 12u * 4 * sizeof(float));
  compact.store.status[5] = 0;
  compact.coefficient[5] = 0.5F;
  const ResponseField apart(compact.arrays());
  EXPECT_EQ(apart.memory(), 12u * 5 * sizeof(float));
  for (const double depth : { 0.001, 0.1, 0.77, 1.3, 3.0 })
  {
    EXPECT_EQ(shared.evaluate(3, depth).force, apart.evaluate(3, depth).force);
    EXPECT_EQ(shared.energy(3, depth), apart.energy(3, depth));
  }
  EXPECT_TRUE(shared.haveSameCurve(3, 4));
  EXPECT_FALSE(apart.haveSameCurve(4, 5));
}

TEST(ResponseField, BlendedLawsAreTheBlendOfTheCurves)
{
  for (const bool isShared : { false, true })
  {
    for (const int laws : { 1, 3 })
    {
      Compact compact(laws, 9);
      if (isShared)
      {
        std::fill(compact.coefficient.begin(), compact.coefficient.end(), 0.6F);
      }
      const ResponseField field(compact.arrays());
      const palpate::TriangleCorners corners{ 1, 4, 8 };
      const Vector3 weights(0.2, 0.5, 0.3);
      const palpate::BlendedResponse blend(field, corners, weights);
      for (const double depth : { 0.001, 0.1, 0.77, 1.3, 3.0 })
      {
        double force = 0.0;
        double stiffness = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          const ResponseValue value = field.evaluate(corners[static_cast<std::size_t>(k)], depth);
          force += weights[k] * value.force;
          stiffness += weights[k] * value.stiffness;
        }
        const ResponseValue value = blend.evaluate(depth);
        // The sums have another order, and a cubic polynomial multiplies rounding by up to 100.
        EXPECT_NEAR(value.force, force, 1e-13 * force);
        EXPECT_NEAR(value.stiffness, stiffness, 1e-12 * std::abs(stiffness));
        EXPECT_EQ(value.beyondRange, depth > 2.0);
      }
    }
  }
}

TEST(ResponseField, OnlyValidAndEdgeCanBeUsed)
{
  ResponseStore store(6);
  store.status = { 0, 1, 2, 3, 4, 5 };
  const ResponseField field(store.arrays());
  EXPECT_EQ(static_cast<int>(ResponseStatus::Edge), 5);
  for (std::int32_t i = 0; i < 6; ++i)
  {
    EXPECT_EQ(field.isValid(i), i == 0 || i == 5) << i;
  }
}

TEST(ResponseField, WithoutARangeThereIsNoResponse)
{
  ResponseStore store(4);
  store.range = { 0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(), 1.0F };
  const ResponseField field(store.arrays());
  for (std::int32_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(field.isValid(i), i == 3) << i;
  }
}

TEST(ResponseField, IsACopy)
{
  ResponseStore store(2);
  const ResponseField field(store.arrays());
  const double before = field.evaluate(1, 0.3).force;
  store.force.assign(store.force.size(), 99.0F);
  store.range.assign(2, 0.01F);
  EXPECT_EQ(field.evaluate(1, 0.3).force, before);
  EXPECT_GT(before, 0.0);
}
