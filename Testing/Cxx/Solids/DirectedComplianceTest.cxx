// SPDX-License-Identifier: BSD-3-Clause
// The compliance of a region for each direction: the matrix found from motions, and kernels between
// landmarks against a beam, which is soft in bending and stiff along its axis.
#include "ShapedBodies.h"

#include "Solids/TrueShape/DirectedCompliance.h"
#include "Solids/TrueShape/LandmarkKernels.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace palpate;

Eigen::Vector3d tilted(double degrees)
{
  const double angle = degrees * Pi / 180.0;
  return { 0.0, std::sin(angle), std::cos(angle) };
}
} // namespace

// Six normals determine the whole matrix Γ, except for the damping of a thousandth.
TEST(DirectedCompliance, IsFoundFromMotions)
{
  Eigen::Matrix3d truth;
  truth << 9.0, 2.0, -1.0, 2.0, 4.0, 0.5, -1.0, 0.5, 0.3;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Eigen::Matrix3Xd normals(3, 6);
  for (Eigen::Index i = 0; i < normals.cols(); ++i)
  {
    normals.col(i) = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  }
  const DirectedCompliance found(normals, truth * normals, Eigen::VectorXd::Constant(6, 1.0 / 6.0));
  EXPECT_LT((found.matrix() - truth).norm(), 0.02 * truth.norm());
  EXPECT_EQ(found.matrix(), found.matrix().transpose());
}

// The motion at one normal determines the change of the compliance with rotation to first order: 2
// Δ·g.
TEST(DirectedCompliance, TurnsByTheMotionOfOneNormal)
{
  const Eigen::Vector3d normal(0.0, 0.0, 1.0);
  const Eigen::Vector3d motion(0.4, -0.2, 1.5);
  const DirectedCompliance found(normal, motion, Eigen::VectorXd::Ones(1));
  EXPECT_NEAR(found.along(normal), motion.dot(normal), 2e-3);
  const double turn = 1e-3;
  const Eigen::Vector3d turned = (normal + Eigen::Vector3d(turn, 0.0, 0.0)).normalized();
  EXPECT_NEAR((found.along(turned) - found.along(normal)) / turn, 2.0 * motion[0], 3e-3);
}

TEST(DirectedCompliance, OfNoMotionIsNone)
{
  const DirectedCompliance none(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd(3, 0), Eigen::VectorXd(0));
  EXPECT_TRUE(none.matrix().isZero());
}

// A beam that is four times as wide as thick, held at one end. Along a normal tilted by θ its
// compliance is cos²θ, plus a sixteenth of sin²θ, which motions along the normals of the flat side
// do not contain.
TEST(DirectedCompliance, TurnsTheKernelsOfABeam)
{
  VolumeMesh mesh = palpate::testing::hexahedronBlock(20, 8, 2, 1.0);
  std::vector<unsigned char> fixed;
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    fixed.push_back(mesh.nodes(0, i) == 0.0 ? 7 : 0);
  }
  const Eigen::Vector3d place(17.0, 4.0, 2.0);
  const palpate::testing::ShapedBody beam(
    { std::move(mesh), { { 0.1, 0.45 } }, fixed }, place, 1.5);
  const BodySurface& surface = beam.body.surface();
  const RegularGreen& green = *beam.green;
  const std::int32_t point = palpate::testing::pointAt(surface, place);
  const double self = green.at(point, point);
  EXPECT_NEAR(green.motion(point).dot(surface.normal(point)), self, 1e-12 * self);
  EXPECT_TRUE(green.motion(-1).hasNaN());

  const LandmarkKernels landmarks(green);
  const std::vector<std::int32_t>& points = landmarks.points();
  const auto at = std::find(points.begin(), points.end(), point);
  ASSERT_NE(at, points.end());
  const std::vector<std::size_t> around = { static_cast<std::size_t>(at - points.begin()) };
  const auto along = [&](const Eigen::Vector3d& normal) {
    return BlendedKernels(landmarks, { place, normal, {} }, around).at(1.0).coefficients(0, 0);
  };
  const double level = along(tilted(0.0));
  // On the flat side within 1.5 mm of the place, only the damping has an effect.
  EXPECT_NEAR(level, beam.fit->at(1.0).coefficients(0, 0), 2e-3 * level);
  for (const double degrees : { 10.0, 25.0, 40.0 })
  {
    const double cosine = std::cos(degrees * Pi / 180.0);
    const double stiff = (1.0 - cosine * cosine) / 16.0;
    EXPECT_NEAR(along(tilted(degrees)) / level, cosine * cosine, stiff + 0.01) << degrees;
  }
}
