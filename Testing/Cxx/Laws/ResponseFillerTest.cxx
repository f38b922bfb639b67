// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a response, point by point: neighbours are left alone.
#include "Laws/ResponseFiller.h"

#include "Paraboloid.h"
#include "Laws/ResponseLaw.h"

#include <gtest/gtest.h>

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
  std::vector<float> force = std::vector<float>(Points * Samples, Untouched);
  std::vector<float> stiffness = force;
  std::vector<float> range = std::vector<float>(Points, Untouched);
  std::vector<float> validity = range;
  std::vector<unsigned char> status = std::vector<unsigned char>(Points, 0);
  std::vector<unsigned char> limit = std::vector<unsigned char>(Points, 99);

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
