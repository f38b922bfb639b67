// SPDX-License-Identifier: BSD-3-Clause
// Forces of several tools on a half-space, against a boundary-element solution for two tools and
// against a direct solution of the equations.
#include "Contact/Coupled/CoupledContacts.h"

#include "CoupledPlate.h"
#include "ReferenceTable.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace palpate;
using palpate::Pi;
using namespace palpate::testing;

namespace
{
/// Tips on a grid with this spacing, each moved slightly at random, with depths in a range.
std::vector<PressedTip> scattered(std::size_t count, double spacing, double least, double most)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<PressedTip> tips;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = 8.0 + spacing * static_cast<double>(i % 5) + 0.3 * share(random);
    const double y = 8.0 + spacing * static_cast<double>(i / 5) + 0.3 * share(random);
    tips.push_back({ x, y, least + (most - least) * share(random) });
  }
  return tips;
}

/// Boussinesq's matrix C with the given diagonal.
Eigen::MatrixXd matrixOf(const std::vector<PressedTip>& tips, double modulus, double diagonal)
{
  const auto n = static_cast<Eigen::Index>(tips.size());
  Eigen::MatrixXd matrix = diagonal * Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    for (Eigen::Index j = 0; j < n; ++j)
    {
      const PressedTip& a = tips[static_cast<std::size_t>(i)];
      const PressedTip& b = tips[static_cast<std::size_t>(j)];
      if (i != j)
      {
        matrix(i, j) = 1.0 / (Pi * modulus * std::hypot(a.x - b.x, a.y - b.y));
      }
    }
  }
  return matrix;
}

Eigen::VectorXd depthsOf(const std::vector<PressedTip>& tips)
{
  Eigen::VectorXd depths(static_cast<Eigen::Index>(tips.size()));
  for (std::size_t i = 0; i < tips.size(); ++i)
  {
    depths[static_cast<Eigen::Index>(i)] = tips[i].depth;
  }
  return depths;
}
} // namespace

TEST(CoupledForces, TwoBallsAgreeWithBoundaryElements)
{
  const CoupledPlate plate;
  const auto body = plate.body();
  const ReferenceTable table("tilt/two_contacts_halfspace.csv");
  int compared = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const std::string& kind = table.text(row, "case");
    if (kind.rfind("sphere", 0) != 0)
    {
      continue;
    }
    const double deep = 0.25;
    const double second = kind == "sphere_d2=1" ? deep : 0.5 * deep;
    const double apart = table.number(row, "r_over_a") * std::sqrt(CoupledPlate::Radius * deep);
    CoupledContacts contacts(*body, {}, 2);
    const auto poses = posesOf({ { 25.0, 29.3, deep }, { 25.0 + apart, 29.3, second } });
    const auto& felt = contacts.settle(poses.data());
    const bool isFirst = table.text(row, "quantity") == "F1/F01";
    const double ratio =
      felt[isFirst ? 0 : 1].normalForce / (10.0 * std::pow(isFirst ? deep : second, 1.5));
    // The law of a point force has an error of at most 0.4 % of the force for two real contacts
    // (bound of the reference sheet).
    EXPECT_NEAR(ratio / table.number(row, "BEM"), 1.0, 4e-3) << kind << " " << apart;
    // The stated error is at least this error, except for the rounding of floats. It is largest for
    // the weaker of two unequal contacts.
    const double stated = contacts.pointForceError(isFirst ? 0 : 1);
    EXPECT_LE(std::abs(ratio / table.number(row, "BEM") - 1.0), stated + 3e-4) << kind << apart;
    EXPECT_LT(stated, kind == "sphere_d2=1" ? 0.01 : 0.05);
    // The same law by another code, to six digits and to the rounding of floats.
    EXPECT_NEAR(ratio, table.number(row, "point"), 3e-4) << kind << " " << apart;
    ++compared;
  }
  EXPECT_EQ(compared, 36);
}

TEST(CoupledForces, TwoFlatEndsAgreeWithBoundaryElements)
{
  const CoupledPlate plate(true);
  const auto body = plate.body();
  const ReferenceTable table("tilt/two_contacts_halfspace.csv");
  int compared = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    if (table.text(row, "case") != "flat_equal_depth")
    {
      continue;
    }
    const double over = table.number(row, "r_over_a");
    CoupledContacts contacts(*body, {}, 2);
    const auto poses =
      posesOf({ { 20.0, 29.3, 0.5 }, { 20.0 + over * CoupledPlate::Flat, 29.3, 0.5 } });
    const auto& felt = contacts.settle(poses.data());
    const double alone = 2.0 * CoupledPlate::Flat * 0.5;
    // The closed form, to the rounding of floats.
    EXPECT_NEAR(felt[0].normalForce / alone, 1.0 / (1.0 + 2.0 / (Pi * over)), 1e-6) << over;
    EXPECT_NEAR(felt[1].normalForce, felt[0].normalForce, 1e-6 * alone);
    // The law of a point force has an error of 0.8 % at twice the radius, less at larger distances.
    // The boundary elements make flat ends 1.4 % too small, an error of the same size and opposite
    // sign.
    EXPECT_NEAR(felt[0].normalForce / alone, table.number(row, "BEM"), 0.01) << over;
    EXPECT_LE(std::abs(table.number(row, "point") / table.number(row, "BEM") - 1.0),
      contacts.pointForceError(0))
      << over;
    // Stiffness for opposite motion, which is exact for two tools.
    EXPECT_NEAR(contacts.stiffening(), 1.0 / (1.0 - 2.0 / (Pi * over)), 1e-5) << over;
    ++compared;
  }
  EXPECT_GE(compared, 9);
}

TEST(CoupledForces, OfFlatEndsSolveTheLinearSystem)
{
  const CoupledPlate plate(true);
  const auto body = plate.body();
  for (const std::size_t count : { std::size_t{ 5 }, std::size_t{ 20 } })
  {
    const auto tips = scattered(count, 9.0, 1.2, 1.6);
    const Eigen::VectorXd forces =
      matrixOf(tips, plate.terms.modulus, 1.0 / (2.0 * CoupledPlate::Flat))
        .ldlt()
        .solve(depthsOf(tips));
    ASSERT_GT(forces.minCoeff(), 0.0);
    CoupledContacts contacts(*body, {}, count);
    const auto& felt = contacts.settle(posesOf(tips).data());
    for (std::size_t i = 0; i < count; ++i)
    {
      // Curves and coordinates are floats.
      EXPECT_NEAR(felt[i].normalForce / forces[static_cast<Eigen::Index>(i)], 1.0, 2e-6);
      EXPECT_NEAR(felt[i].deflection, tips[i].depth - contacts.sunk(i), 1e-12);
    }
  }
}

// Reference: Newton's method on closed forms, from above.
TEST(CoupledForces, OfBallsSolveTheEquations)
{
  const CoupledPlate plate;
  const auto body = plate.body();
  for (const std::size_t count : { std::size_t{ 5 }, std::size_t{ 20 } })
  {
    const auto tips = scattered(count, 10.0, 0.8, 1.2);
    const Eigen::MatrixXd others = matrixOf(tips, plate.terms.modulus, 0.0);
    const Eigen::VectorXd depths = depthsOf(tips);
    Eigen::VectorXd local = 0.5 * depths;
    for (int step = 0; step < 50; ++step)
    {
      const Eigen::VectorXd force = 10.0 * local.array().pow(1.5).matrix();
      Eigen::MatrixXd slope = others * (15.0 * local.array().sqrt()).matrix().asDiagonal();
      slope += Eigen::MatrixXd::Identity(slope.rows(), slope.cols());
      local -= slope.lu().solve(local + others * force - depths);
      local = local.cwiseMax(1e-3);
    }
    CoupledContacts contacts(*body, {}, count);
    const auto& felt = contacts.settle(posesOf(tips).data());
    for (std::size_t i = 0; i < count; ++i)
    {
      const double expected = 10.0 * std::pow(local[static_cast<Eigen::Index>(i)], 1.5);
      EXPECT_NEAR(felt[i].normalForce / expected, 1.0, 2e-6) << i; // 2e-6: stored as floats
    }
  }
}

// Tools that the others lift off have no force. The reference is, of all subsets of tools, the one
// without a negative force and without an indented tool that has no force.
TEST(CoupledForces, WhoIsLiftedOffHasNoForce)
{
  const CoupledPlate plate(true);
  const auto body = plate.body();
  auto tips = scattered(5, 5.0, 1.0, 1.6);
  tips[1].depth = 0.15;
  tips[3].depth = 0.2;
  const Eigen::MatrixXd matrix =
    matrixOf(tips, plate.terms.modulus, 1.0 / (2.0 * CoupledPlate::Flat));
  const Eigen::VectorXd depths = depthsOf(tips);
  std::vector<Eigen::VectorXd> solutions;
  for (unsigned subset = 0; subset < 32; ++subset)
  {
    std::vector<Eigen::Index> in;
    for (Eigen::Index i = 0; i < 5; ++i)
    {
      if ((subset >> i & 1U) != 0)
      {
        in.push_back(i);
      }
    }
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(5);
    const Eigen::MatrixXd part = matrix(in, in);
    const Eigen::VectorXd solved = part.ldlt().solve(Eigen::VectorXd(depths(in)));
    for (std::size_t k = 0; k < in.size(); ++k)
    {
      forces[in[k]] = solved[static_cast<Eigen::Index>(k)];
    }
    const Eigen::VectorXd left = depths - matrix * forces;
    bool holds = true;
    for (Eigen::Index i = 0; i < 5; ++i)
    {
      holds = holds && ((subset >> i & 1U) != 0 ? forces[i] > 0.0 : left[i] <= 0.0);
    }
    if (holds)
    {
      solutions.push_back(forces);
    }
  }
  ASSERT_EQ(solutions.size(), 1U);
  ASSERT_EQ((solutions[0].array() == 0.0).count(), 2);
  CoupledContacts contacts(*body, {}, 5);
  const auto& felt = contacts.settle(posesOf(tips).data());
  for (std::size_t i = 0; i < 5; ++i)
  {
    const double expected = solutions[0][static_cast<Eigen::Index>(i)];
    // stored as floats
    EXPECT_NEAR(felt[i].normalForce, expected, 2e-6 * solutions[0].maxCoeff()) << i;
    EXPECT_EQ(felt[i].state, expected > 0.0 ? ContactState::Slide : ContactState::None) << i;
  }
  // After the other tools have moved out, the tool has a force again at once, without having been
  // outside.
  for (const std::size_t i : { 0U, 2U, 4U })
  {
    tips[i].depth = -0.5;
  }
  EXPECT_NEAR(contacts.settle(posesOf(tips).data())[1].normalForce, 0.54, 0.1);
}

// At 200 mm/s and 1 kHz two rounds per tick have an error of a thousandth of the force for ten
// tools (as in the reference sheet), and of five thousandths for twenty.
TEST(CoupledForces, TwoRoundsFollowAFastHand)
{
  const CoupledPlate plate;
  const auto body = plate.body();
  for (const std::size_t count : { std::size_t{ 2 }, std::size_t{ 10 }, std::size_t{ 20 } })
  {
    CoupledContacts moving(*body, {}, count);
    CoupledContacts still(*body, {}, count);
    double worst = 0.0;
    for (int tick = 0; tick < 300; ++tick)
    {
      auto tips = scattered(count, 10.0, 0.9, 1.1);
      for (std::size_t i = 0; i < count; ++i)
      {
        // Up and down by 0.9 mm with at most 200 mm/s.
        tips[i].depth += 0.9 * std::sin(200.0 / 0.9 * 1e-3 * tick + static_cast<double>(i));
      }
      const auto poses = posesOf(tips);
      const auto& fast = moving.update(poses.data());
      const auto& exact = still.settle(poses.data());
      for (std::size_t i = 0; i < count && tick > 10; ++i)
      {
        worst = std::max(worst, std::abs(fast[i].normalForce - exact[i].normalForce));
      }
    }
    const double scale = 10.0 * std::pow(1.9, 1.5);
    EXPECT_LT(worst / scale, count > 10 ? 5e-3 : 1e-3) << count;
    EXPECT_GT(worst, 0.0);
  }
}

// Any number of adjacent flat ends is at most 2.75 times as stiff as one (charges on touching
// spheres). Seven ends in a hexagon have a factor of 1.75.
TEST(CoupledForces, OfAHexagonAreBounded)
{
  const CoupledPlate plate(true);
  const auto body = plate.body();
  std::vector<PressedTip> tips = { { 29.0, 29.3, 0.5 } };
  for (int k = 0; k < 6; ++k)
  {
    const double angle = Pi / 3.0 * k;
    const double apart = 2.0 * CoupledPlate::Flat;
    tips.push_back({ 29.0 + apart * std::cos(angle), 29.3 + apart * std::sin(angle), 1.0 });
  }
  const Eigen::MatrixXd matrix = matrixOf(tips, 1.0, 1.0 / (2.0 * CoupledPlate::Flat));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  const double largest = 1.0 / solver.eigenvalues()[0] / (2.0 * CoupledPlate::Flat);
  EXPECT_NEAR(largest, 1.75, 0.01); // value of the reference sheet
  tips[0].depth = 1.0;
  CoupledContacts contacts(*body, {}, 7);
  contacts.settle(posesOf(tips).data());
  EXPECT_GE(contacts.stiffening(), largest - 1e-6);
  EXPECT_LE(contacts.stiffening(), std::pow(7.0, 1.0 / 16.0) * largest + 1e-6);
  const double share = contacts.cappedShare(1, 2.0);
  EXPECT_NEAR(share, 2.0 / (2.0 * CoupledPlate::Flat) / contacts.stiffening(), 1e-6);
}
