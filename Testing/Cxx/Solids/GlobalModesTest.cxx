// SPDX-License-Identifier: BSD-3-Clause
// The modes of bodies that bend, against full solutions at points that are not landmarks, against
// C_g and beam theory. Also the subtracted dent, and bodies with few or no points to press, of
// several parts, or held along one whole side. TestElasticComplianceModes tests plate and filter.
#include "Agreement.h"
#include "ElasticBlocks.h"
#include "Solids/FiniteElements/GlobalModes.h"
#include "Solids/FiniteElements/RegularField.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace global_modes
{
namespace
{
using namespace palpate;
using palpate::Pi;
using palpate::testing::agrees;

constexpr double Poisson = 0.3;
constexpr int Length = 40; // length of the bar, mm
constexpr int Side = 4;

bool always(double)
{
  return true;
}

/// A factorised body and the compliances of all points of its surface.
struct Solved
{
  ElasticBody body;
  PatchCompliances compliances;

  explicit Solved(ElasticBodyInput input)
  {
    EXPECT_EQ(this->body.assemble(std::move(input)), "");
    EXPECT_EQ(this->body.analyse(StiffnessFactor::Kind::Automatic), "");
    EXPECT_EQ(this->body.factorise(), "");
    std::vector<std::int32_t> points(static_cast<std::size_t>(this->body.surface().pointTotal()));
    std::iota(points.begin(), points.end(), 0);
    this->compliances = patchCompliances(this->body, points, 0.0, always);
  }

  const BodySurface& surface() const { return this->body.surface(); }
  std::int32_t at(double x, double y, double z) const
  {
    return palpate::testing::pointAt(this->surface(), Eigen::Vector3d(x, y, z));
  }
  bool isValid(std::int32_t point) const
  {
    return this->compliances.status[static_cast<std::size_t>(point)] == PatchStatus::Valid;
  }
  double compliance(std::int32_t point) const
  {
    return this->compliances.compliance[static_cast<std::size_t>(point)];
  }
  GlobalModes modes(int count) const
  {
    return globalModes(this->body, this->compliances, 0.0, count, always);
  }
  Eigen::Matrix3Xd regular(std::int32_t point) const
  {
    return RegularField(this->body, 0.0).at(point);
  }
};

/// Motion of the surface under 1 N pressed in at `point`: the sum over the modes, computed as a
/// user of the modes would.
Eigen::Matrix3Xd motion(const Solved& solved, const GlobalModes& modes, std::int32_t point)
{
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, solved.surface().pointTotal());
  for (std::size_t k = 0; k < modes.fields.size(); ++k)
  {
    const double pressed = solved.surface().normal(point).dot(modes.fields[k].col(point));
    sum -= modes.signs[k] * pressed * modes.fields[k];
  }
  return sum;
}

/// A bar of square cross-section along x from the origin, held at x = 0. E = 1 MPa.
ElasticBodyInput bar(int length = Length, int side = Side)
{
  ElasticBodyInput input;
  input.mesh = palpate::testing::hexahedronBlock(length, side, side, 1.0);
  input.materials = { { 1.0, Poisson } };
  for (Eigen::Index i = 0; i < input.mesh.nodes.cols(); ++i)
  {
    input.fixed.push_back(input.mesh.nodes(0, i) == 0.0 ? 7 : 0);
  }
  return input;
}

ElasticBodyInput heldBlock(int nx, int ny, int nz, double modulus = 1.0)
{
  ElasticBodyInput input;
  input.mesh = palpate::testing::hexahedronBlock(nx, ny, nz, 1.0);
  input.materials = { { modulus, Poisson } };
  input.fixed = palpate::testing::heldBelow(input.mesh);
  return input;
}

/// Two bodies in one input; the second is moved by `offset`, so that its faces have the same
/// orientation.
ElasticBodyInput both(ElasticBodyInput a, ElasticBodyInput b, const Eigen::Vector3d& offset)
{
  const std::int32_t first = a.mesh.nodeTotal();
  Eigen::Matrix3Xd nodes(3, first + b.mesh.nodeTotal());
  nodes << a.mesh.nodes, b.mesh.nodes.colwise() + offset;
  a.mesh.nodes = nodes;
  for (VolumeElement element : b.mesh.elements)
  {
    for (std::int32_t& node : element.nodes)
    {
      node += first;
    }
    a.mesh.elements.push_back(element);
  }
  a.fixed.insert(a.fixed.end(), b.fixed.begin(), b.fixed.end());
  return a;
}

/// Largest difference of two motions, relative to the largest motion of the second.
double difference(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b)
{
  return (a - b).colwise().norm().maxCoeff() / b.colwise().norm().maxCoeff();
}
} // namespace

TEST(RegularField, IsTheWholeMotionWithoutTheDent)
{
  const Solved beam(bar());
  const BodySurface& surface = beam.surface();
  const std::int32_t point = beam.at(24, 2, 4);
  ASSERT_TRUE(beam.isValid(point));
  const Eigen::Matrix3Xd regular = beam.regular(point);
  const Eigen::Matrix3Xd whole = beam.body.displacement(
    (4.0 * patchForces(beam.body, point, 0.75) - patchForces(beam.body, point, 1.5)) / 3.0);
  // At the point itself the motion is -C_g, which is computed from the energy of the patches, not
  // from motions. Both are accurate to the fourth order of patch radius / side, which is 0.75/4.
  EXPECT_TRUE(agrees(-regular(2, point), beam.compliance(point), 1e-3));
  const double reduced = 1.0 / (1.0 - Poisson * Poisson);
  const double rounding = 1e-9 * whole.cwiseAbs().maxCoeff();
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    const Eigen::Vector3d taken = whole.col(surface.node(i)) - regular.col(i);
    const Eigen::Vector3d away = surface.position(i) - surface.position(point);
    if (surface.normal(i)[2] < 0.4) // no dent on sides, ends and bottom
    {
      EXPECT_LT(taken.norm(), rounding) << i;
    }
    else if (surface.normal(i)[2] == 1.0 && away.norm() > 3.0 && away.norm() < 5.0)
    {
      // Error of the elements, some of which are two elements away from the force.
      EXPECT_NEAR(-taken[2] * Pi * reduced * away.norm(), 1.0, 0.05) << i;
    }
    else if (surface.normal(i)[2] == 1.0 && away.norm() > 7.0) // beyond the cut of 5.5
    {
      EXPECT_NEAR(-taken[2], 1.0 / (Pi * reduced * away.norm()), rounding) << i;
      EXPECT_NEAR(taken.head<2>().norm(),
        (1.0 - 2.0 * Poisson) / (2.0 * Pi * away.norm()) * (1.0 + Poisson), rounding)
        << i; // Johnson 1985, eq. 3.18: the motion is towards the force
      EXPECT_LT(taken.dot(away), 0.0) << i;
    }
  }
}

// Far from the support the bar moves as a Timoshenko beam. The part beyond the force rotates as a
// rigid body.
TEST(RegularField, BendsAsBeamTheoryHasIt)
{
  const Solved beam(bar());
  const double inertia = std::pow(Side, 4) / 12.0;
  const double shear = 0.85 * Side * Side / (2.0 * (1.0 + Poisson)); // κGA
  for (const int x : { 20, 30 })
  {
    const Eigen::Matrix3Xd regular = beam.regular(beam.at(x, 2, 4));
    const double below = -regular(2, beam.at(x, 2, 0));
    const double end = -regular(2, beam.at(Length, 2, 0));
    const double bending = x * x * x / (3.0 * inertia);
    // The held end cannot contract sideways, which has the same effect as a bar that is shorter by
    // a tenth of its side.
    EXPECT_NEAR(below / (bending + x / shear), 1.0, 0.02) << x;
    const double turned = x * x / (2.0 * inertia) * (Length - x);
    EXPECT_NEAR((end - below) / turned, 1.0, 0.02) << x;
  }
}

/**
 * Six modes of a bar are three for each direction of bending. By Euler's series, G = L³/EI Σ φ_k(ξ)
 * φ_k(η)/λ_k⁴ with |φ_k| <= 2 and λ = 1.875, 4.694, 7.855, 10.996, 14.137..., the modes from the
 * fourth on move no point by more than 4.7e-4 L³/EI: 0.5 % of the largest motion, ξ²(3-ξ)/6 L³/EI,
 * under a force at ξ = 1/2, and 2 % at ξ = 1/4. Twice this error is allowed, because shear, torsion
 * and local deformation of a cross-section add to it, and the third mode is not exactly Euler's.
 */
TEST(GlobalModes, MoveABarAsTheFullSolutionDoes)
{
  const Solved beam(bar());
  const GlobalModes modes = beam.modes(6);
  ASSERT_EQ(modes.fields.size(), 6U);
  EXPECT_EQ(modes.landmarks.size(), 48U);
  EXPECT_LT(modes.asymmetry, 1e-3); // by Betti's theorem the asymmetry is zero
  int compared = 0;
  double worst = 0.0;
  for (int x = Length / 4; x < Length; ++x)
  {
    const std::int32_t point = beam.at(x, 2, 4);
    if (!beam.isValid(point) ||
      std::count(modes.landmarks.begin(), modes.landmarks.end(), point) != 0)
    {
      continue;
    }
    const BodySurface& surface = beam.surface();
    const Eigen::Matrix3Xd whole = beam.body.displacement(patchForces(beam.body, point, 0.0));
    const Eigen::Matrix3Xd found = motion(beam, modes, point);
    const double allowed = x >= Length / 2 ? 0.01 : 0.04;
    double largest = 0.0;
    double error = 0.0;
    for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
    {
      const Eigen::Vector3d exact = whole.col(surface.node(i));
      largest = std::max(largest, exact.norm());
      if (surface.normal(i)[2] < 0.4) // the dent does not reach this side
      {
        error = std::max(error, (found.col(i) - exact).norm());
      }
    }
    EXPECT_LT(error, allowed * largest) << x;
    EXPECT_NEAR(-found(2, point), beam.compliance(point), allowed * largest) << x;
    worst = std::max(worst, error / largest);
    ++compared;
  }
  EXPECT_GT(compared, 10);
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(modes.neglected, 0.01); // relative to the largest C_g, that of the free end
  EXPECT_EQ(modes.signs, std::vector<int>(6, 1)); // the compliance is positive at every place
}

// An edge has no landmarks, because patches would wrap around it. The modes are nevertheless valid
// there.
TEST(GlobalModes, HoldWhereNoPatchIsValid)
{
  const Solved beam(bar());
  const BodySurface& surface = beam.surface();
  const std::int32_t point = beam.at(30, 0, 4);
  ASSERT_EQ(beam.compliances.status[static_cast<std::size_t>(point)], PatchStatus::Edge);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, beam.body.mesh().nodes.cols());
  forces.col(surface.node(point)) = -surface.normal(point);
  const Eigen::Matrix3Xd whole = beam.body.displacement(forces);
  const Eigen::Matrix3Xd found = motion(beam, beam.modes(6), point);
  const double largest = whole.colwise().norm().maxCoeff();
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    // Saint-Venant's principle
    if ((surface.position(i) - surface.position(point)).norm() > 2 * Side)
    {
      // Same tolerance as in MoveABarAsTheFullSolutionDoes beyond half of the length.
      EXPECT_LT((found.col(i) - whole.col(surface.node(i))).norm(), 0.01 * largest) << i;
    }
  }
}

TEST(GlobalModes, MoreModesNeglectLess)
{
  const Solved beam(bar(20, 4));
  double before = 1.0;
  for (const int count : { 1, 2, 4, 6 })
  {
    const GlobalModes modes = beam.modes(count);
    EXPECT_EQ(modes.fields.size(), static_cast<std::size_t>(count));
    EXPECT_LT(modes.neglected, before);
    before = modes.neglected;
  }
}

// With one landmark, one mode is exactly its field, and the other modes are zero.
TEST(GlobalModes, MoreModesThanLandmarks)
{
  const Solved block(heldBlock(4, 4, 4));
  const std::int32_t top = block.at(2, 2, 4);
  const GlobalModes modes = block.modes(6);
  ASSERT_EQ(modes.landmarks, std::vector<std::int32_t>{ top });
  ASSERT_EQ(modes.fields.size(), 6U);
  EXPECT_LT(difference(motion(block, modes, top), block.regular(top)), 1e-12); // 1e-12: rounding
  for (std::size_t k = 1; k < 6; ++k)
  {
    EXPECT_TRUE(modes.fields[k].isZero(0.0));
    EXPECT_EQ(modes.signs[k], 1);
  }
  EXPECT_EQ(modes.asymmetry, 0.0);
}

TEST(GlobalModes, ABodyWithoutAValidPatchHasNone)
{
  const Solved block(heldBlock(2, 2, 2));
  const GlobalModes modes = block.modes(2);
  EXPECT_TRUE(modes.landmarks.empty());
  ASSERT_EQ(modes.fields.size(), 2U);
  EXPECT_TRUE(modes.fields[0].isZero(0.0) && modes.fields[1].isZero(0.0));
  EXPECT_EQ(modes.neglected, 0.0);
}

// On a bonded block the support stiffens the surface: C_g < 0, and the signs of the modes are
// negative.
TEST(GlobalModes, ABondedBlockHasNegativeOnes)
{
  const Solved block(heldBlock(12, 12, 4));
  const std::int32_t top = block.at(6, 6, 4);
  ASSERT_LT(block.compliance(top), 0.0);
  const GlobalModes modes = block.modes(6);
  EXPECT_EQ(std::count(modes.signs.begin(), modes.signs.end(), -1), 6);
  const double found = -motion(block, modes, top)(2, top);
  EXPECT_LT(
    // the modes contain the largest part of C_g, although such a body needs many modes
    found, 0.5 * block.compliance(top));
  EXPECT_GT(found, 1.1 * block.compliance(top));
}

TEST(GlobalModes, PartsDoNotMoveEachOther)
{
  // Equal bars have equal eigenvalues, so the limit of six modes splits a group.
  const Solved bars(both(bar(16, 4), bar(16, 4), { 0.0, 0.0, 8.0 }));
  const GlobalModes modes = bars.modes(6);
  for (const double z : { 4.0, 12.0 })
  {
    const std::int32_t point = bars.at(12, 2, z);
    const Eigen::Matrix3Xd found = motion(bars, modes, point);
    EXPECT_GT(-found(2, point), 0.9 * bars.compliance(point));
    for (std::int32_t i = 0; i < bars.surface().pointTotal(); ++i)
    {
      const bool above = bars.surface().position(i)[2] > 6.0;
      if (above != (z > 6.0))
      {
        EXPECT_EQ(found.col(i).norm(), 0.0) << i;
      }
    }
  }
}

TEST(GlobalModes, ScaleAsOneOverTheRootOfTheModulus)
{
  const Solved soft(heldBlock(6, 6, 3));
  const Solved stiff(heldBlock(6, 6, 3, 4.0));
  const std::int32_t top = soft.at(3, 3, 3);
  const Eigen::Matrix3Xd a = motion(soft, soft.modes(3), top);
  const Eigen::Matrix3Xd b = motion(stiff, stiff.modes(3), top);
  EXPECT_LT(difference(4.0 * b, a), 1e-9); // rounding times the condition number
}

TEST(GlobalModes, StopWhenToldTo)
{
  const Solved block(heldBlock(6, 6, 3));
  int calls = 0;
  const GlobalModes modes =
    globalModes(block.body, block.compliances, 0.0, 2, [&calls](double) { return ++calls < 3; });
  EXPECT_TRUE(modes.fields.empty());
  EXPECT_EQ(calls, 3);
}
} // namespace global_modes
