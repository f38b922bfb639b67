// SPDX-License-Identifier: BSD-3-Clause
// The error of a response stored in 8 float32 samples: the closed forms of the reference sheet in
// series with a global compliance are stored and evaluated over 1 … 100 % of δ_max = 2 mm.
#include "Contact/ResponseField.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

using palpate::Pi;

namespace
{
struct Local
{
  double depth, force, stiffness; ///< mm, N, N/mm
};

/// The law of a tool as a function of a parameter p >= 0 that grows with depth. E* = 3.45 MPa.
struct Tool
{
  std::string name;
  double exponent;
  double parameterEnd; ///< p at a depth beyond 2 mm
  std::function<Local(double p)> law;
};

std::vector<Tool> tools()
{
  constexpr double E = 3.45;
  const auto flat = [](double a) {
    return [a](double p) { return Local{ p, 2.0 * a * E * p, 2.0 * a * E }; };
  };
  const auto paraboloid = [](double R)
  {
    return [R](double p) {
      return Local{ p, 4.0 / 3.0 * E * std::sqrt(R) * std::pow(p, 1.5),
        2.0 * E * std::sqrt(R * p) };
    };
  };
  // p = artanh(a/R): δ = R p tanh p, F = E*[(a²+R²) p - a R].
  const auto sphere = [](double R)
  {
    return [R](double p)
    {
      const double t = std::tanh(p);
      return Local{ R * p * t, E * R * R * ((t * t + 1.0) * p - t), 2.0 * E * R * t };
    };
  };
  const double c = std::tan(Pi / 3.0);
  const auto cone = [c](double p) {
    return Local{ p, 2.0 / Pi * E * c * p * p, 4.0 / Pi * E * c * p };
  };
  return { { "flat 1.6", 1.0, 3.0, flat(1.6) }, { "paraboloid 6.35", 1.5, 3.0, paraboloid(6.35) },
    { "sphere 6.35", 1.5, 1.0, sphere(6.35) }, { "sphere 1.6", 1.5, 3.0, sphere(1.6) },
    { "cone 60", 2.0, 3.0, cone } };
}

/// The point of the series curve at δ, by bisection on p: δ_local + C F = δ.
Local series(const Tool& tool, double compliance, double depth)
{
  double low = 0.0;
  double high = tool.parameterEnd;
  for (int i = 0; i < 100; ++i)
  {
    const double middle = 0.5 * (low + high);
    const Local local = tool.law(middle);
    (local.depth + compliance * local.force < depth ? low : high) = middle;
  }
  const Local local = tool.law(0.5 * (low + high));
  return { depth, local.force, local.stiffness / (1.0 + compliance * local.stiffness) };
}

constexpr double StoredRange = 2.0;
constexpr int StoredSamples = 8;

/// Largest relative error of the force over 1 … 100 % of the range.
double storageError(const Tool& tool, double compliance, double exponent)
{
  std::vector<float> force;
  std::vector<float> stiffness;
  for (int i = 1; i <= StoredSamples; ++i)
  {
    const Local point =
      series(tool, compliance, StoredRange * i * i / (StoredSamples * StoredSamples));
    force.push_back(static_cast<float>(point.force));
    stiffness.push_back(static_cast<float>(point.stiffness));
  }
  const float normal[3] = { 0.0F, 0.0F, 1.0F };
  const auto range = static_cast<float>(StoredRange);
  const std::uint8_t status = 0;
  palpate::ResponseArrays arrays;
  arrays.points = 1;
  arrays.samples = StoredSamples;
  arrays.exponent = exponent;
  arrays.force = force.data();
  arrays.stiffness = stiffness.data();
  arrays.normal = normal;
  arrays.range = &range;
  arrays.status = &status;
  const palpate::ResponseField field(arrays);
  double worst = 0.0;
  for (int i = 100; i <= 10000; ++i)
  {
    const double depth = 1e-4 * i * StoredRange;
    const double exact = series(tool, compliance, depth).force;
    worst = std::max(worst, std::abs(field.evaluate(0, depth).force / exact - 1.0));
  }
  return worst;
}

double betterError(const Tool& tool, double compliance)
{
  return std::min(
    storageError(tool, compliance, tool.exponent), storageError(tool, compliance, 1.0));
}
} // namespace

TEST(StorageError, WithinTheBoundsOfTheReferenceSheet)
{
  std::printf("largest relative error of the stored force, 1 ... 100 %% of 2 mm, n = 8, float32\n"
              "%-16s %12s %12s %12s\n",
    "tool", "C_g = 0", "1 mm/N", "10 mm/N");
  for (const Tool& tool : tools())
  {
    std::printf("%-16s", tool.name.c_str());
    for (const double compliance : { 0.0, 1.0, 10.0 })
    {
      const double error = betterError(tool, compliance);
      std::printf(" %12.3g", error);
      std::string key = tool.name + " C" + std::to_string(static_cast<int>(compliance));
      std::replace_if(
        key.begin(), key.end(), [](char character) { return std::isalnum(character) == 0; }, '_');
      RecordProperty(key, std::to_string(1e6 * error) + "e-6");
      // The reference sheet, section 7, states 5e-4 in general and 1.4e-2 for a sphere in series
      // with 10 mm/N. It states no bound for a cone in series, whose exponent differs most from 1:
      // 2e-2 here.
      const double inSeries = tool.exponent == 2.0 ? 2e-2 : 1.4e-2;
      const double bound = compliance > 0.0 ? inSeries : 5e-4;
      EXPECT_LE(error, bound) << tool.name << ", C_g = " << compliance;
    }
    std::printf("\n");
  }
}

TEST(StorageError, TableOneIsExactToSinglePrecision)
{
  // Flat end, paraboloid and cone follow their power exactly. The only error is that of float32,
  // 6e-8 for each F and K. The slope of r contributes 2m s n/4 times the interval.
  for (const Tool& tool : tools())
  {
    if (tool.name.substr(0, 6) != "sphere")
    {
      EXPECT_LE(storageError(tool, 0.0, tool.exponent), 3e-7) << tool.name;
    }
  }
}

TEST(StorageError, FlatStaysLinearInSeries)
{
  for (const double compliance : { 1.0, 10.0 })
  {
    EXPECT_LE(storageError(tools().front(), compliance, 1.0), 3e-7);
  }
}
