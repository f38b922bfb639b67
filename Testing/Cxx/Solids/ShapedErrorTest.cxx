// SPDX-License-Identifier: BSD-3-Clause
// The stated error of a contact on finite elements must bound the true error: against elements of
// half the size, at random points, tools and depths, on bodies to which the estimate was not
// fitted. Errors that a finer mesh does not change (small strain) are not included.
#include "ShapedBodies.h"

#include "Mechanics/Numerics/Constants.h"
#include "Solids/TrueShape/InclusionMixing.h"
#include "TestTools.h"

#include <random>

namespace
{
using namespace palpate;
using palpate::testing::heldAtTheEnds;
using palpate::testing::statedOfElements;
using palpate::testing::tool;

/// A body solved for contacts everywhere on its surface.
struct Solved
{
  ElasticBody body;
  std::unique_ptr<RegularGreen> green;

  Solved(ElasticBodyInput input, const std::vector<Eigen::Vector3d>& places, double radius)
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
    EXPECT_EQ(this->green->solve(points, radius, [](double) { return true; }), "");
  }

  ContactCurve curve(const AxisymmetricTool& pressed, const Eigen::Vector3d& place) const
  {
    const std::int32_t point = palpate::testing::pointAt(this->body.surface(), place);
    return ShapedContact(pressed).curve(ContactKernelFit(*this->green, point));
  }
};

using BodyOf = std::function<ElasticBodyInput(int finer)>;

/// Random points of the coarse body's surface at which a tool can press.
std::vector<Eigen::Vector3d> drawn(const BodyOf& bodyOf, std::size_t count)
{
  ElasticBody body;
  EXPECT_EQ(body.assemble(bodyOf(1)), "");
  std::mt19937 random(11);
  std::vector<std::int32_t> points;
  for (std::int32_t i = 0; i < body.surface().pointTotal(); ++i)
  {
    if (whyNotPressed(body, i).empty())
    {
      points.push_back(i);
    }
  }
  std::vector<Eigen::Vector3d> places;
  for (std::size_t k = 0; k < count && !points.empty(); ++k)
  {
    const std::size_t at = random() % points.size();
    places.push_back(body.surface().position(points[at]));
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return places;
}

/// Number of compared forces, and number of differences from finer elements above the stated error.
struct Compared
{
  int all = 0;
  int beyond = 0;
};

Compared compare(const BodyOf& bodyOf, double radius)
{
  const std::vector<Eigen::Vector3d> places = drawn(bodyOf, 24);
  const Solved coarse(bodyOf(1), places, radius);
  const Solved fine(bodyOf(2), places, radius);
  std::mt19937 random(3);
  Compared compared;
  for (const Eigen::Vector3d& place : places)
  {
    for (const char* name : { "sphere:4", "flat:0.8", "cone:70" })
    {
      const auto pressed = tool(name);
      const ContactCurve here = coarse.curve(*pressed, place);
      const ContactCurve there = fine.curve(*pressed, place);
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
    }
  }
  EXPECT_GT(compared.all, 30);
  std::cout << compared.beyond << " of " << compared.all << " beyond what is stated\n";
  return compared;
}

VolumeMesh block(int nx, int ny, int nz, int finer)
{
  return palpate::testing::hexahedronBlock(finer * nx, finer * ny, finer * nz, 1.0 / finer);
}

ElasticBodyInput heldBelow(VolumeMesh mesh, const std::vector<ElasticMaterial>& materials)
{
  std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
  return { std::move(mesh), materials, std::move(fixed) };
}

ElasticBodyInput blockWithEdges(int finer)
{
  return heldBelow(block(9, 8, 6, finer), { { 0.1, 0.4 } });
}

ElasticBodyInput barThatBends(int finer)
{
  return heldBelow(block(5, 5, 16, finer), { { 0.1, 0.35 } });
}

/// A plate two elements thick, held at two ends; it is also pressed from the side.
ElasticBodyInput thinPlate(int finer)
{
  return heldAtTheEnds(block(14, 14, 2, finer), 14.0);
}

/// A plate of quadratic tetrahedra of 1 mm, `Thickness` layers thick.
template <int Thickness>
ElasticBodyInput plateOfTetrahedra(int finer)
{
  return heldAtTheEnds(
    palpate::testing::quadratic(palpate::testing::tetrahedra(
      palpate::testing::hexahedronBlock(10 * finer, 10 * finer, Thickness * finer, 1.0 / finer))),
    10.0);
}

ElasticBodyInput overAStiffBase(int finer)
{
  VolumeMesh mesh = block(9, 9, 6, finer);
  std::vector<ElasticMaterial> materials;
  for (const VolumeElement& element : mesh.elements)
  {
    materials.push_back({ elementMiddle(mesh, element).z() < 2.0 ? 10.0 : 0.1, 0.45 });
  }
  return heldBelow(std::move(mesh), materials);
}

ElasticBodyInput quadraticTetrahedra(int finer)
{
  return heldBelow(
    palpate::testing::quadratic(palpate::testing::tetrahedra(
      palpate::testing::hexahedronBlock(4 * finer, 4 * finer, 3 * finer, 2.0 / finer))),
    { { 0.1, 0.45 } });
}

/// A block under hills and hollows with a wavelength of 8 mm and a curvature of up to 0.15/mm, with
/// eight elements per wave.
ElasticBodyInput underHills(int finer)
{
  VolumeMesh mesh = block(16, 16, 8, finer);
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    const double wave = 2.0 * Pi / 8.0;
    const double hill =
      0.125 * (std::sin(wave * mesh.nodes(0, i)) + std::sin(wave * mesh.nodes(1, i)));
    mesh.nodes(2, i) += hill * mesh.nodes(2, i) / 8.0;
  }
  return heldBelow(std::move(mesh), { { 0.1, 0.45 } });
}

/// A block over a ball with a radius of 2 mm, 2 mm below the top, which is ten times as stiff.
ElasticBodyInput overANodule(int finer)
{
  constexpr int n = 8; // sample points along each side of a voxel
  VolumeMesh mesh = block(10, 10, 8, finer);
  std::vector<ElasticMaterial> materials;
  for (const VolumeElement& element : mesh.elements)
  {
    const Eigen::Vector3d low = mesh.nodes.col(element.nodes[0]);
    const Eigen::Vector3d high = mesh.nodes.col(element.nodes[6]);
    int inside = 0;
    for (int i = 0; i < n * n * n; ++i)
    {
      const Eigen::Vector3d t =
        (Eigen::Vector3d(i % n, i / n % n, i / (n * n)).array() + 0.5) / static_cast<double>(n);
      inside += (low + t.cwiseProduct(high - low) - Eigen::Vector3d(5.0, 5.0, 4.0)).norm() < 2.0;
    }
    materials.push_back({ mixedModulus(0.1, 10.0, inside / static_cast<double>(n * n * n)), 0.45 });
  }
  return heldBelow(std::move(mesh), materials);
}
/// A block that is held at the bottom and on its top up to x = 4 mm. A contact must not extend into
/// the held part.
ElasticBodyInput heldOnTop(int finer)
{
  ElasticBodyInput input = heldBelow(block(10, 8, 5, finer), { { 0.1, 0.45 } });
  for (std::size_t i = 0; i < input.fixed.size(); ++i)
  {
    const Eigen::Vector3d at = input.mesh.nodes.col(static_cast<Eigen::Index>(i));
    input.fixed[i] = at.z() == 5.0 && at.x() < 4.01 ? 7 : input.fixed[i];
  }
  return input;
}
} // namespace

// Contacts at distances down to a tenth of their radius from the held part, against elements of a
// third of the side. These elements change the force by a quarter, and the stated error covers the
// change.
TEST(ShapedError, HoldsBesideWhatIsHeld)
{
  const std::vector<Eigen::Vector3d> places = { { 5.0, 4.0, 5.0 }, { 6.0, 4.0, 5.0 },
    { 7.0, 4.0, 5.0 } };
  const Solved coarse(heldOnTop(1), places, 2.5);
  const Solved fine(heldOnTop(3), places, 2.5);
  const auto pressed = tool("sphere:4");
  double largest = 0.0;
  for (const Eigen::Vector3d& place : places)
  {
    const ContactCurve here = coarse.curve(*pressed, place);
    const ContactCurve there = fine.curve(*pressed, place);
    ASSERT_FALSE(here.isEmpty());
    for (const double part : { 0.3, 0.6, 0.9 })
    {
      const double depth = part * std::min(here.deepest(), there.deepest());
      const IndentationPoint found = here.evaluate(depth);
      const ContactSample errors = here.errorsAt(depth);
      const double error = std::abs(found.force / there.evaluate(depth).force - 1.0);
      const double stated = statedOfElements(errors, found.stiffness * depth / found.force);
      EXPECT_LT(error, stated) << place.x() - 4.0 << " mm, " << part;
      largest = std::max(largest, error);
    }
  }
  EXPECT_GT(largest, 0.02);
}

// The stated error is a bound in 95 of 100 cases.
TEST(ShapedError, HoldsAtRandom)
{
  Compared all;
  for (const auto& [bodyOf, radius] :
    { std::pair(&blockWithEdges, 2.5), std::pair(&barThatBends, 1.8), std::pair(&thinPlate, 2.5),
      std::pair(&plateOfTetrahedra<1>, 2.5), std::pair(&plateOfTetrahedra<2>, 2.5),
      std::pair(&overAStiffBase, 2.5), std::pair(&quadraticTetrahedra, 2.5),
      std::pair(&overANodule, 2.5), std::pair(&underHills, 2.5) })
  {
    const Compared compared = compare(bodyOf, radius);
    all.all += compared.all;
    all.beyond += compared.beyond;
  }
  EXPECT_LE(all.beyond, 0.05 * all.all);
}
