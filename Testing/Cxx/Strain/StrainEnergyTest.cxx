// SPDX-License-Identifier: BSD-3-Clause
// Strain energies against their textbook forms in long double, and their derivatives against
// differences.
#include "Strain/StrainEnergy.h"

#include "Agreement.h"

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <random>

using palpate::SecondOrder;
using palpate::StrainEnergy;
using palpate::StrainModel;
using palpate::testing::agrees;

namespace
{
using Real = long double;
using Gradient = StrainEnergy::Gradient<double>;
constexpr double Mu = 0.7;

struct Case
{
  StrainModel model;
  double parameter;
};
constexpr std::array<Case, 7> Cases = { { { StrainModel::NeoHooke, 0.0 },
  { StrainModel::Ogden, 2.0 }, { StrainModel::Ogden, 9.0 }, { StrainModel::Ogden, -5.0 },
  { StrainModel::Demiray, 0.5 }, { StrainModel::Demiray, 8.0 }, { StrainModel::Linear, 0.0 } } };

/// Energy in textbook form, from the stretches of F = 1 + H.
Real fromStretches(const Case& energy, const Gradient& h)
{
  Eigen::Matrix<Real, 3, 3> f = Eigen::Matrix<Real, 3, 3>::Identity();
  f(0, 0) += h[0];
  f(0, 2) += h[1];
  f(2, 0) += h[2];
  f(2, 2) += h[3];
  f(1, 1) += h[4];
  const Real j = f.determinant();
  const Eigen::Matrix<Real, 3, 3> c = f.transpose() * f;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 3, 3>> solver(c);
  Real first = 0.0L;
  Real ogden = 0.0L;
  for (int i = 0; i < 3; ++i)
  {
    const Real stretch = std::sqrt(solver.eigenvalues()[i]) * std::pow(j, -1.0L / 3.0L);
    first += stretch * stretch;
    ogden += std::pow(stretch, static_cast<Real>(energy.parameter));
  }
  const Real b = energy.parameter;
  switch (energy.model)
  {
    case StrainModel::NeoHooke:
      return Mu / 2.0L * (first - 3.0L);
    case StrainModel::Ogden:
      return 2.0L * Mu / (b * b) * (ogden - 3.0L);
    case StrainModel::Demiray:
      return Mu / (2.0L * b) * (std::exp(b * (first - 3.0L)) - 1.0L);
    case StrainModel::Linear:
      break;
  }
  const Eigen::Matrix<Real, 3, 3> strain =
    0.5L * (f + f.transpose()) - Eigen::Matrix<Real, 3, 3>::Identity();
  const Eigen::Matrix<Real, 3, 3> deviator =
    strain - strain.trace() / 3.0L * Eigen::Matrix<Real, 3, 3>::Identity();
  return Mu * deviator.squaredNorm();
}

double valueAt(const StrainEnergy& energy, const Gradient& h)
{
  return energy.isochoric(h, energy.volumeChange(h));
}

SecondOrder<5> differentiate(const StrainEnergy& energy, const Gradient& h)
{
  StrainEnergy::Gradient<SecondOrder<5>> x;
  for (int i = 0; i < 5; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    x[k] = SecondOrder<5>::variable(h[k], i);
  }
  return energy.isochoric(x, energy.volumeChange(x));
}

Gradient randomGradient(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> component(-size, size);
  Gradient h;
  for (double& value : h)
  {
    value = component(random);
  }
  return h;
}
} // namespace

TEST(StrainEnergy, IsTheOneOfTheBook)
{
  std::mt19937 random(7);
  for (const Case& each : Cases)
  {
    const StrainEnergy energy(each.model, Mu, each.parameter);
    for (int i = 0; i < 200; ++i)
    {
      const Gradient h = randomGradient(random, 0.3);
      // Cancellation in long double leaves an error of about 1e-18 of the terms.
      EXPECT_TRUE(agrees(valueAt(energy, h), static_cast<double>(fromStretches(each, h)), 1e-12))
        << static_cast<int>(each.model) << " " << each.parameter;
    }
  }
}

TEST(StrainEnergy, KeepsItsDigitsAtTinyStrains)
{
  // Tiny strains, as far from a contact, where a difference of large numbers would lose all digits.
  // Every model is Hooke's law here, except for terms of the next order, which are 1e-8 of the
  // energy.
  std::mt19937 random(8);
  const StrainEnergy linear(StrainModel::Linear, Mu);
  for (const Case& each : Cases)
  {
    const StrainEnergy energy(each.model, Mu, each.parameter);
    for (int i = 0; i < 50; ++i)
    {
      const Gradient h = randomGradient(random, 1e-9);
      EXPECT_TRUE(agrees(valueAt(energy, h), valueAt(linear, h), 1e-6));
      const auto stress = differentiate(energy, h).gradient;
      const auto hooke = differentiate(linear, h).gradient;
      EXPECT_LT((stress - hooke).norm(), 1e-6 * hooke.norm());
    }
  }
}

TEST(StrainEnergy, StressAndTangentAreItsDerivatives)
{
  std::mt19937 random(9);
  // Includes two nearly or exactly equal stretches in the plane.
  const std::array<double, 4> sizes = { 0.25, 0.03, 1e-4, 0.0 };
  for (const Case& each : Cases)
  {
    const StrainEnergy energy(each.model, Mu, each.parameter);
    for (const double size : sizes)
    {
      const Gradient h = randomGradient(random, size);
      const SecondOrder<5> at = differentiate(energy, h);
      for (std::size_t i = 0; i < 5; ++i)
      {
        constexpr double step = 1e-4;
        const auto moved = [&](double by)
        {
          Gradient other = h;
          other[i] += by;
          return differentiate(energy, other);
        };
        // Five-point differences have an error of step⁴.
        const auto derivative = [&](auto&& part)
        {
          return ((8.0 * (part(moved(step)) - part(moved(-step))) - part(moved(2.0 * step)) +
                    part(moved(-2.0 * step))) /
            (12.0 * step));
        };
        const auto row = static_cast<Eigen::Index>(i);
        const double slope = derivative([](const SecondOrder<5>& x) { return x.value; });
        EXPECT_NEAR(at.gradient[row], slope, 1e-9);
        for (Eigen::Index k = 0; k < 5; ++k)
        {
          const double bend = derivative([k](const SecondOrder<5>& x) { return x.gradient[k]; });
          EXPECT_NEAR(at.hessian(row, k), bend, 1e-8 * (1.0 + std::abs(bend)));
        }
      }
    }
  }
}

TEST(StrainEnergy, NamesAWrongParameter)
{
  EXPECT_EQ(palpate::checkStrainEnergy(StrainModel::NeoHooke, 0.0), "");
  EXPECT_NE(palpate::checkStrainEnergy(StrainModel::Ogden, 0.0).find("Ogden"), std::string::npos);
  EXPECT_NE(palpate::checkStrainEnergy(StrainModel::Ogden, NAN), "");
  EXPECT_NE(palpate::checkStrainEnergy(StrainModel::Demiray, -1.0).find("-1"), std::string::npos);
}
