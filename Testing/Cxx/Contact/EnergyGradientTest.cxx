// SPDX-License-Identifier: BSD-3-Clause
// The force as the gradient of an energy, compared with finite differences of the closest point's
// area coordinates and of the energy.
#include "Contact/EnergyGradient.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

using palpate::EnergyGradient;
using palpate::projectOnTriangle;
using palpate::TriangleFeature;
using palpate::TriangleProjection;
using palpate::Vector3;

namespace
{
const Vector3 FirstCorner(0.1, -0.2, 0.3);
const Vector3 SecondCorner(4.2, 0.5, 0.9);
const Vector3 ThirdCorner(1.3, 3.1, -0.4);
constexpr double Offset = 1e-6;

Vector3 weightsAt(const Vector3& tip)
{
  return projectOnTriangle(tip, FirstCorner, SecondCorner, ThirdCorner).weights;
}

Vector3 anyTip(std::mt19937& random)
{
  std::uniform_real_distribution<double> place(-3.0, 7.0);
  const double x = place(random);
  const double y = place(random);
  return { x, y, place(random) };
}

/// f_i = k_i δ^1.5 and its work.
struct Law
{
  Vector3 factor;
  Vector3 force(double depth) const { return this->factor * std::pow(depth, 1.5); }
  Vector3 energy(double depth) const { return this->factor * std::pow(depth, 2.5) / 2.5; }
};

double energyAt(const Vector3& tip, const Law& law)
{
  const TriangleProjection at = projectOnTriangle(tip, FirstCorner, SecondCorner, ThirdCorner);
  return at.weights.dot(law.energy(std::sqrt(at.squaredDistance)));
}
} // namespace

TEST(EnergyGradient, WeightGradientsOfEveryFeature)
{
  std::mt19937 random(1);
  std::array<int, 7> seen{};
  for (int i = 0; i < 4000; ++i)
  {
    const Vector3 tip = anyTip(random);
    const TriangleFeature feature =
      projectOnTriangle(tip, FirstCorner, SecondCorner, ThirdCorner).feature;
    const Eigen::Matrix3d found =
      EnergyGradient::facetWeightGradients(feature, FirstCorner, SecondCorner, ThirdCorner);
    bool sameFeature = true;
    Eigen::Matrix3d expected;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const Vector3 step = Offset * Vector3::Unit(k);
      expected.row(k) = (weightsAt(tip + step) - weightsAt(tip - step)) / (2.0 * Offset);
      sameFeature = sameFeature &&
        projectOnTriangle(tip + step, FirstCorner, SecondCorner, ThirdCorner).feature == feature &&
        projectOnTriangle(tip - step, FirstCorner, SecondCorner, ThirdCorner).feature == feature;
    }
    if (sameFeature)
    {
      // The weights are linear within a feature, so the error is the rounding divided by the
      // offset.
      EXPECT_LE((found - expected).norm(), 1e-9);
      ++seen[static_cast<std::size_t>(feature)];
    }
  }
  for (const int count : seen)
  {
    EXPECT_GT(count, 100);
  }
}

TEST(EnergyGradient, ForceIsMinusTheGradientOfTheEnergy)
{
  const Law law{ Vector3(10.0, 3.0, 25.0) };
  std::mt19937 random(2);
  for (int i = 0; i < 4000; ++i)
  {
    const Vector3 tip = anyTip(random);
    const TriangleProjection at = projectOnTriangle(tip, FirstCorner, SecondCorner, ThirdCorner);
    const double depth = std::sqrt(at.squaredDistance);
    const Vector3 normal = (at.point - tip) / depth;
    const Vector3 force = at.weights.dot(law.force(depth)) * normal -
      EnergyGradient::ofEnergies(
        EnergyGradient::facetWeightGradients(at.feature, FirstCorner, SecondCorner, ThirdCorner),
        law.energy(depth));
    Vector3 expected;
    bool sameFeature = true;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const Vector3 step = Offset * Vector3::Unit(k);
      expected[k] = -(energyAt(tip + step, law) - energyAt(tip - step, law)) / (2.0 * Offset);
      sameFeature = sameFeature &&
        projectOnTriangle(tip + step, FirstCorner, SecondCorner, ThirdCorner).feature ==
          at.feature &&
        projectOnTriangle(tip - step, FirstCorner, SecondCorner, ThirdCorner).feature == at.feature;
    }
    if (sameFeature)
    {
      // Rounding of an energy divided by the offset, relative to the force: 1e-16 δ / offset.
      EXPECT_LE((force - expected).norm(), 1e-8 * (1.0 + force.norm()));
    }
  }
}

TEST(EnergyGradient, EqualEnergiesHaveNoGradient)
{
  const Eigen::Matrix3d gradients = EnergyGradient::facetWeightGradients(
    TriangleFeature::Face, FirstCorner, SecondCorner, ThirdCorner);
  const Vector3 gradient =
    EnergyGradient::ofEnergies(gradients, Vector3::Constant(1e6 + 1.0 / 3.0));
  EXPECT_EQ(gradient, Vector3(Vector3::Zero())); // exact to the last bit, for any energies
}
