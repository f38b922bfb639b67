// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a response are filled point by point; neighbouring entries stay unchanged.
#include "Laws/ResponseFiller.h"

#include "Paraboloid.h"
#include "Laws/BodyMaterial.h"
#include "Laws/ResponseLaw.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr std::size_t Points = 3;
constexpr int Samples = 8;
constexpr float Untouched = -7.0F;

struct Arrays
{
  std::size_t points = Points;
  std::vector<float> force = std::vector<float>(points * Samples, Untouched);
  std::vector<float> stiffness = force;
  std::vector<float> range = std::vector<float>(points, Untouched);
  std::vector<float> validity = range;
  std::vector<unsigned char> status = std::vector<unsigned char>(points, 0);
  std::vector<unsigned char> limit = std::vector<unsigned char>(points, 99);

  ResponseSpans spans()
  {
    return { Samples, this->force.data(), this->stiffness.data(), this->range.data(),
      this->validity.data(), this->status.data(), this->limit.data() };
  }
};

class Filling : public ::testing::Test
{
protected:
  void fill(std::size_t point, double curvature)
  {
    const ResponseLaw law(*this->Tool, 2.0, Samples);
    ResponseFiller(*this->Tool, law, 2.0, 100.0, this->Into.spans())
      .fill(point, { 0.06, 0.45, 0.0, 0.0 }, curvature);
  }

  Paraboloid Shape;
  std::unique_ptr<AxisymmetricTool> Tool = Shape.make();
  Arrays Into;
};
} // namespace

TEST_F(Filling, OnePointAndNoOther)
{
  this->fill(1, 0.0);
  EXPECT_EQ(this->Into.status[1], 0);
  EXPECT_FLOAT_EQ(this->Into.force[2 * Samples - 1], static_cast<float>(Shape.force(2.0, 0.06)));
  EXPECT_EQ(this->Into.range[1], 2.0F);
  EXPECT_FLOAT_EQ(this->Into.validity[1], static_cast<float>(Shape.depthAt(0.4 * Shape.radius)));
  EXPECT_EQ(this->Into.limit[1], static_cast<unsigned char>(ResponseLimit::Strain));
  EXPECT_EQ(this->Into.force[Samples - 1], Untouched);
  EXPECT_EQ(this->Into.force[2 * Samples], Untouched);
  EXPECT_EQ(this->Into.range[0], Untouched);
  EXPECT_EQ(this->Into.limit[2], 99);
}

TEST_F(Filling, WhereTheNormalIsWrongThereIsNoCurve)
{
  this->Into.status[0] = static_cast<unsigned char>(ResponseStatus::NotFinite);
  this->fill(0, 0.0);
  EXPECT_EQ(this->Into.status[0], static_cast<unsigned char>(ResponseStatus::NotFinite));
  EXPECT_EQ(this->Into.force[0], 0.0F);
  EXPECT_EQ(this->Into.validity[0], 0.0F);
  EXPECT_EQ(this->Into.limit[0], 0);
  EXPECT_EQ(this->Into.range[0], 2.0F);
}

TEST_F(Filling, WhereNoTriangleHasAnAreaItIsDegenerate)
{
  this->fill(2, -1.0);
  EXPECT_EQ(this->Into.status[2], static_cast<unsigned char>(ResponseStatus::Degenerate));
  EXPECT_EQ(this->Into.force[2 * Samples], 0.0F);
}

TEST_F(Filling, AWholeBodyOfManyModuli)
{
  constexpr std::size_t count = 40000; // enough for several threads and blocks
  BodyMaterial::Values values;
  values.youngsModulus.name = "E";
  for (std::size_t i = 0; i < count; ++i)
  {
    values.youngsModulus.values.push_back(0.1 + 1e-6 * static_cast<double>(i));
  }
  BodyMaterial material({ 0.1, 0.0, 0.0, LayerBase::Bonded, false });
  ASSERT_EQ(material.take(std::move(values), count), "");
  Arrays into{ count };
  into.status[7] = static_cast<unsigned char>(ResponseStatus::NotFinite);
  double last = 0.0;
  const MadeResponse made = response(*this->Tool, material, 2.0, count,
    { 100.0, [](std::size_t i) { return i == 9 ? -1.0 : 0.0; }, {} }, {}, into.spans(),
    [&last](double share)
    {
      EXPECT_GT(share, last);
      last = share;
      return true;
    });
  EXPECT_TRUE(made.complete);
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(made.without, 2U);
  EXPECT_EQ(made.exponent, 1.5); // a paraboloid is stored without error
  for (std::size_t i = 0; i < count; ++i)
  {
    const double wanted = i == 7 || i == 9 ? 0.0 : Shape.force(2.0, 0.1 + 1e-6 * i);
    ASSERT_NEAR(into.force[(i + 1) * Samples - 1], wanted, 1e-6 * wanted) << i;
  }
}

TEST_F(Filling, IsGivenUpWhenToldTo)
{
  BodyMaterial material({ 0.1, 0.0, 0.0, LayerBase::Bonded, false });
  ASSERT_EQ(material.take({}, Points), "");
  const MadeResponse made =
    response(*this->Tool, material, 2.0, Points, { 100.0, [](std::size_t) { return 0.0; }, {} }, {},
      this->Into.spans(), [](double) { return false; });
  EXPECT_FALSE(made.complete);
}
