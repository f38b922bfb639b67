// SPDX-License-Identifier: BSD-3-Clause
// Reduced responses whose smallest number of values is known. Errors are computed with a separate
// implementation of the contract.
#include "Contact/Reduction/ResponseReduction.h"

#include "SampleResponses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using palpate::ReducedForm;
using palpate::ReducedResponse;
using palpate::reduceResponse;
using palpate::ReductionSettings;
using palpate::ResponseArrays;
using palpate::ResponseField;
using palpate::testing::ContractCurve;
using palpate::testing::ResponseStore;

namespace
{
constexpr std::size_t Samples = 8;
constexpr double Range = 2.0; // range of ResponseStore, mm
// A float has an error of 6e-8; a cubic polynomial between samples multiplies it by up to 10.
constexpr double Storage = 1e-6;

/// Force and stiffness of point p at depth δ.
using Law = std::function<std::pair<double, double>(std::size_t p, double depth)>;

ResponseStore storeOf(std::size_t points, const Law& law)
{
  ResponseStore store(points);
  for (std::size_t p = 0; p < points; ++p)
  {
    for (std::size_t i = 0; i < Samples; ++i)
    {
      const double s = static_cast<double>(i + 1) / Samples;
      const auto [force, stiffness] = law(p, Range * s * s);
      store.force[Samples * p + i] = static_cast<float>(force);
      store.stiffness[Samples * p + i] = static_cast<float>(stiffness);
    }
  }
  return store;
}

/// a_p δ^1.5 + b_p δ^2 + c_p δ^2.5.
ResponseStore powers(std::size_t points, int terms)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.5, 2.0);
  std::vector<double> factors(3 * points, 0.0);
  for (std::size_t p = 0; p < points; ++p)
  {
    for (int k = 0; k < terms; ++k)
    {
      factors[3 * p + static_cast<std::size_t>(k)] = share(random);
    }
  }
  return storeOf(points,
    [factors](std::size_t p, double depth)
    {
      double force = 0.0;
      double stiffness = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double q = 1.5 + 0.5 * static_cast<double>(k);
        force += factors[3 * p + k] * std::pow(depth, q);
        stiffness += factors[3 * p + k] * q * std::pow(depth, q - 1.0);
      }
      return std::pair(force, stiffness);
    });
}

/// The arrays with the curves in the reduced form.
ResponseArrays arraysOf(const ResponseStore& store, const ReducedResponse& reduced)
{
  ResponseArrays arrays = store.arrays();
  arrays.samples = reduced.samples;
  const bool isCompact = reduced.laws > 0;
  arrays.force = isCompact ? nullptr : reduced.force.data();
  arrays.stiffness = isCompact ? nullptr : reduced.stiffness.data();
  arrays.laws = reduced.laws;
  arrays.basis = isCompact ? reduced.basis.data() : nullptr;
  arrays.coefficient = isCompact ? reduced.coefficient.data() : nullptr;
  return arrays;
}

/// Largest relative error at five times as many depths as the reduction checks.
double largestError(
  const ResponseStore& store, const ReducedResponse& reduced, std::size_t stride = 1)
{
  const ResponseField field(arraysOf(store, reduced));
  double largest = 0.0;
  for (std::size_t p = 0; p < store.range.size(); p += stride)
  {
    if (store.status[p] != 0)
    {
      continue;
    }
    const ContractCurve curve = store.curveOf(p);
    const double range = store.range[p];
    const double least = curve.evaluate(range / (Samples * Samples)).force;
    for (int step = 1; step <= 160; ++step)
    {
      const double depth = range * step * step / (160.0 * 160.0);
      const double right = curve.evaluate(depth).force;
      const double found = field.evaluate(static_cast<std::int32_t>(p), depth).force;
      largest = std::max(largest, std::abs(found - right) / std::max(right, least));
    }
  }
  return largest;
}

/// Expects that `tolerance` holds at all depths and that the reported error is that of brute force.
/// Between the checked depths an error may be larger: the bump of a cubic polynomial over two
/// thirds of an interval, a parabola of half-width 1/3, is sampled at most 1/8 from its top, which
/// misses 14 % at worst and usually half of this.
void expectKept(const ResponseStore& store, const ReducedResponse& reduced, double tolerance)
{
  const double found = largestError(store, reduced);
  EXPECT_LE(reduced.largestError, tolerance);
  EXPECT_LE(found, 1.14 * reduced.largestError + 1e-9);
  EXPECT_GE(found, reduced.largestError - 1e-9);
}

ReductionSettings within(double tolerance, int mostLaws = 8)
{
  ReductionSettings settings;
  settings.tolerance = tolerance;
  settings.mostLaws = mostLaws;
  return settings;
}
} // namespace

TEST(ResponseReduction, OneLawForAHomogeneousBody)
{
  const ResponseStore store(50);
  const ReducedResponse reduced = reduceResponse(store.arrays(), within(1e-5));
  EXPECT_EQ(reduced.form, ReducedForm::OneLaw);
  EXPECT_EQ(reduced.numbersPerPoint, 0);
  expectKept(store, reduced, Storage);
  EXPECT_TRUE(std::all_of(
    reduced.coefficient.begin(), reduced.coefficient.end(), [](float c) { return c == 1.0F; }));
  // The kernel's records then contain only range and normal.
  EXPECT_EQ(ResponseField(arraysOf(store, reduced)).memory(), 50u * 4 * sizeof(float));
}

TEST(ResponseReduction, OneLawWhereTheSpreadIsWithinTheTolerance)
{
  // Factors within 3 % of the middle law.
  const ResponseStore store = storeOf(61,
    [](std::size_t p, double depth)
    {
      const double scale = 0.97 + 0.06 * static_cast<double>(p) / 60.0;
      return std::pair(scale * std::pow(depth, 1.5), 1.5 * scale * std::sqrt(depth));
    });
  const ReducedResponse one = reduceResponse(store.arrays(), within(0.0301));
  EXPECT_EQ(one.form, ReducedForm::OneLaw);
  EXPECT_NEAR(one.largestError, 0.03, 1e-5);
  expectKept(store, one, 0.0301);
  const ReducedResponse scale = reduceResponse(store.arrays(), within(0.0299));
  EXPECT_EQ(scale.form, ReducedForm::Scale);
  EXPECT_EQ(scale.numbersPerPoint, 1);
  expectKept(store, scale, Storage);
}

TEST(ResponseReduction, AsManyLawsAsTheCurvesAreMadeOf)
{
  for (const int terms : { 1, 2, 3 })
  {
    const ResponseStore store = powers(60, terms);
    const ReducedResponse reduced = reduceResponse(store.arrays(), within(1e-5));
    EXPECT_EQ(reduced.form, terms == 1 ? ReducedForm::Scale : ReducedForm::Basis);
    EXPECT_EQ(reduced.laws, terms);
    EXPECT_EQ(reduced.numbersPerPoint, terms);
    expectKept(store, reduced, 10.0 * Storage); // sums of laws that nearly cancel
    EXPECT_LT(reduced.largestSlopeError, 1e-4); // n times as large as the error of the force
  }
}

TEST(ResponseReduction, FewerLawsForALargerTolerance)
{
  const ResponseStore store = powers(60, 3);
  int before = 16;
  for (const double tolerance : { 1e-5, 1e-3, 1e-2, 0.1, 1.0 })
  {
    const ReducedResponse reduced = reduceResponse(store.arrays(), within(tolerance));
    EXPECT_LE(reduced.numbersPerPoint, before);
    expectKept(store, reduced, tolerance);
    before = reduced.numbersPerPoint;
  }
  EXPECT_LE(before, 1);
}

TEST(ResponseReduction, FewerSamplesWhereNoLawsAreAllowed)
{
  const ResponseStore store = powers(60, 2);
  const ReducedResponse reduced = reduceResponse(store.arrays(), within(0.02, 1));
  ASSERT_EQ(reduced.form, ReducedForm::Samples);
  EXPECT_LT(reduced.samples, 8);
  EXPECT_EQ(reduced.numbersPerPoint, 2 * reduced.samples);
  expectKept(store, reduced, 0.02);
  // With half of the error allowed, more numbers are needed.
  EXPECT_GT(reduceResponse(store.arrays(), within(0.5 * reduced.largestError, 1)).numbersPerPoint,
    reduced.numbersPerPoint);
}

TEST(ResponseReduction, UnchangedWhereNothingLessWillDo)
{
  ResponseStore store(300);
  store.randomize(3);
  const ReducedResponse reduced = reduceResponse(store.arrays(), within(1e-4, 4));
  EXPECT_EQ(reduced.form, ReducedForm::Unchanged);
  EXPECT_EQ(reduced.numbersPerPoint, 16);
  EXPECT_EQ(reduced.samples, 8);
  EXPECT_TRUE(reduced.basis.empty() && reduced.coefficient.empty() && reduced.force.empty());
}

TEST(ResponseReduction, PointsWithoutResponseTakeNoPart)
{
  ResponseStore store = powers(100, 1);
  for (std::size_t p = 0; p < 100; p += 7)
  {
    store.status[p] = 2;
    std::fill_n(store.force.begin() + static_cast<std::ptrdiff_t>(Samples * p), Samples,
      std::numeric_limits<float>::quiet_NaN());
  }
  const ReducedResponse reduced = reduceResponse(store.arrays(), within(1e-5));
  EXPECT_EQ(reduced.form, ReducedForm::Scale);
  for (std::size_t p = 0; p < 100; p += 7)
  {
    EXPECT_EQ(reduced.coefficient[p], 0.0F);
  }
  expectKept(store, reduced, Storage);
}

TEST(ResponseReduction, CurvesThatAreNoCurvesStayAsTheyAre)
{
  ResponseStore zero = storeOf(20, [](std::size_t, double) { return std::pair(0.0, 0.0); });
  EXPECT_EQ(reduceResponse(zero.arrays(), within(0.01)).form, ReducedForm::Unchanged);
  ResponseStore broken = powers(20, 1);
  broken.force[40] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(reduceResponse(broken.arrays(), within(0.01)).form, ReducedForm::Unchanged);
  ResponseStore none(5);
  none.status.assign(5, 1);
  EXPECT_EQ(reduceResponse(none.arrays(), within(0.01)).form, ReducedForm::Unchanged);
}

TEST(ResponseReduction, ACompactResponseIsReducedFurther)
{
  const ResponseStore store = powers(60, 3);
  const ReducedResponse fine = reduceResponse(store.arrays(), within(1e-5));
  const ReducedResponse coarse = reduceResponse(arraysOf(store, fine), within(0.1));
  EXPECT_LT(coarse.numbersPerPoint, fine.numbersPerPoint);
  EXPECT_LE(largestError(store, coarse), 0.1 * 1.14 + 1e-5);
}

TEST(ResponseReduction, ManyPoints)
{
  // With more than a few thousand points, forms are first tried on a part of the points, and sums
  // use several threads.
  const ResponseStore store = powers(20000, 2);
  const ReducedResponse reduced = reduceResponse(store.arrays(), within(1e-5));
  EXPECT_EQ(reduced.laws, 2);
  EXPECT_LE(reduced.largestError, 10.0 * Storage);
  EXPECT_LE(largestError(store, reduced, 499), 10.0 * Storage);
  const ReducedResponse again = reduceResponse(store.arrays(), within(1e-5));
  EXPECT_EQ(reduced.basis, again.basis);
  EXPECT_EQ(reduced.coefficient, again.coefficient);
}
