// SPDX-License-Identifier: BSD-3-Clause
// The error of the finer of two meshes, estimated from both, must bound the true error: against
// elements of half the size, at random points, tools and depths.
#include "ShapedBodies.h"

#include "Solids/TrueShape/MeshDifference.h"
#include "TestTools.h"

#include <random>

namespace mesh_difference
{
namespace
{
using namespace palpate;
using palpate::testing::heldAtTheEnds;
using palpate::testing::statedOfElements;
using palpate::testing::tool;

constexpr double Radius = 1.8; // radius of the widest contact, mm
/// Makes a body with elements of 2 mm / finer.
using BodyOf = ElasticBodyInput (*)(int finer);

/// A body solved for contacts at some places of its surface, or everywhere.
struct Solved
{
  ElasticBody body;
  std::unique_ptr<RegularGreen> green;

  explicit Solved(
    ElasticBodyInput input, const std::vector<Eigen::Vector3d>& places = {}, double spacing = 0.0)
  {
    EXPECT_EQ(this->body.assemble(std::move(input)), "");
    EXPECT_EQ(this->body.analyse(StiffnessFactor::Kind::Automatic), "");
    EXPECT_EQ(this->body.factorise(), "");
    this->green = std::make_unique<RegularGreen>(this->body);
    std::vector<std::int32_t> points;
    for (const Eigen::Vector3d& place : places)
    {
      points.push_back(palpate::testing::pointAt(this->body.surface(), place));
    }
    for (std::int32_t i = 0; places.empty() && i < this->body.surface().pointTotal(); ++i)
    {
      points.push_back(i);
    }
    EXPECT_EQ(this->green->solve(
                points, Radius, [](double) { return true; }, spacing),
      "");
  }

  ContactKernelFit at(const Eigen::Vector3d& place) const
  {
    return ContactKernelFit(*this->green, palpate::testing::pointAt(this->body.surface(), place));
  }
};

/// Random points of the surface at which a tool can press.
std::vector<Eigen::Vector3d> drawn(const ElasticBody& body, std::size_t count)
{
  std::mt19937 random(11);
  std::vector<Eigen::Vector3d> places;
  while (places.size() < count)
  {
    const auto i =
      static_cast<std::int32_t>(random() % static_cast<unsigned>(body.surface().pointTotal()));
    if (whyNotPressed(body, i).empty())
    {
      places.push_back(body.surface().position(i));
    }
  }
  return places;
}

/// Number of compared forces, number of differences from finer elements above the stated error, and
/// the mean stated error of the elements, with and without the second mesh.
struct Compared
{
  int all = 0;
  int beyond = 0;
  double stated = 0.0;
  double expected = 0.0;
  double error = 0.0;
};

Compared compare(BodyOf bodyOf)
{
  const Solved coarse(bodyOf(1));
  const Solved fine(bodyOf(2));
  const std::vector<Eigen::Vector3d> places = drawn(fine.body, 12);
  // The number of sources is the same, so that only the elements differ.
  const Solved truth(bodyOf(4), places, fine.body.surface().spacing(0));
  const MeshDifference meshes(LandmarkKernels(*fine.green), LandmarkKernels(*coarse.green));
  std::mt19937 random(3);
  Compared compared;
  for (const Eigen::Vector3d& place : places)
  {
    const ContactKernelFit without = fine.at(place);
    ContactKernelFit with = without;
    with.setMissed(meshes.at(
      place, fine.body.surface().normal(palpate::testing::pointAt(fine.body.surface(), place))));
    EXPECT_TRUE(with.site().missed.isKnown());
    for (const char* name : { "sphere:4", "flat:0.8", "cone:70" })
    {
      const auto pressed = tool(name);
      const ShapedContact contact(*pressed);
      const ContactCurve here = contact.curve(with);
      const ContactCurve there = contact.curve(truth.at(place));
      if (here.isEmpty() || there.isEmpty())
      {
        continue;
      }
      const double part = (1.0 + static_cast<double>(random() % 9)) / 10.0;
      const double depth = part * std::min({ here.deepest(), there.deepest(), 1.0 });
      const IndentationPoint found = here.evaluate(depth);
      const ContactSample errors = here.errorsAt(depth);
      const double stated = statedOfElements(errors, found.stiffness * depth / found.force);
      const double better = there.evaluate(depth).force;
      // the error is of second order
      const double error = 4.0 / 3.0 * std::abs(found.force / better - 1.0);
      ++compared.all;
      compared.beyond += error > stated ? 1 : 0;
      compared.error += error;
      compared.stated += errors.mesh;
      compared.expected += contact.curve(without).errorsAt(depth).mesh;
    }
  }
  EXPECT_GT(compared.all, 20);
  std::cout << compared.beyond << " of " << compared.all << " beyond what is stated; error "
            << compared.error / compared.all << ", stated " << compared.stated / compared.all
            << " in place of " << compared.expected / compared.all << "\n";
  return compared;
}

/// A plate of quadratic tetrahedra whose side is the thickness, and twice the thickness on the
/// coarser mesh.
ElasticBodyInput thinPlate(int finer)
{
  const int layers = std::max(1, finer / 2);
  VolumeMesh mesh = palpate::testing::quadratic(palpate::testing::tetrahedra(
    palpate::testing::hexahedronBlock(5 * finer, 5 * finer, layers, 2.0 / finer)));
  mesh.nodes.row(2) *= finer / (2.0 * layers);
  return heldAtTheEnds(std::move(mesh), 10.0);
}

/// A plate of two layers of tetrahedra.
ElasticBodyInput plate(int finer)
{
  return heldAtTheEnds(
    palpate::testing::quadratic(palpate::testing::tetrahedra(
      palpate::testing::hexahedronBlock(5 * finer, 5 * finer, finer, 2.0 / finer))),
    10.0);
}

ElasticBodyInput heldBlock(int finer)
{
  VolumeMesh mesh = palpate::testing::hexahedronBlock(5 * finer, 4 * finer, 3 * finer, 2.0 / finer);
  std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
  return { std::move(mesh), { { 0.1, 0.4 } }, fixed };
}

/// A cap of a ball of 8 mm on a block, held at the bottom. Its nodes are on the ball itself.
ElasticBodyInput heldCap(int finer)
{
  constexpr double radius = 8.0;
  constexpr double half = 4.0;
  VolumeMesh mesh = palpate::testing::quadratic(palpate::testing::tetrahedra(
    palpate::testing::hexahedronBlock(4 * finer, 4 * finer, 2 * finer, 2.0 / finer)));
  std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    auto at = mesh.nodes.col(i);
    const double across = (at.head<2>() - Eigen::Vector2d(half, half)).squaredNorm();
    at[2] *= 1.0 + (std::sqrt(radius * radius - across) - std::sqrt(radius * radius - 32.0)) / half;
  }
  return { std::move(mesh), { { 0.1, 0.45 } }, fixed };
}
} // namespace

// The error is a bound in 95 of 100 cases and smaller than the expected error of the elements from
// one mesh.
TEST(MeshDifference, BoundsWhatFinerElementsChange)
{
  Compared all;
  for (const BodyOf bodyOf : { &thinPlate, &plate, &heldBlock, &heldCap })
  {
    const Compared compared = compare(bodyOf);
    all.all += compared.all;
    all.beyond += compared.beyond;
    EXPECT_LT(compared.stated, compared.expected);
  }
  EXPECT_LE(all.beyond, 0.05 * all.all);
}

// Two estimates combine as the harmonic mean of their squares.
TEST(MeshDifference, StandsBesideAnotherEstimate)
{
  const MissedCompliance told{ { 0.5, 2.0 }, { 3.0, 4.0 } };
  EXPECT_DOUBLE_EQ(told.at(0.1), 3.0);
  EXPECT_DOUBLE_EQ(told.at(1.0), 3.5);
  EXPECT_DOUBLE_EQ(told.at(9.0), 4.0);
  EXPECT_DOUBLE_EQ(told.beside(4.0, 0.1), std::sqrt(2.0) * 12.0 / 5.0);
  EXPECT_DOUBLE_EQ(told.beside(0.0, 1.0), 0.0);
  EXPECT_NEAR(told.beside(1e9, 1.0), std::sqrt(2.0) * 3.5, 1e-6);
  EXPECT_FALSE(MissedCompliance{}.isKnown());
}
} // namespace mesh_difference
