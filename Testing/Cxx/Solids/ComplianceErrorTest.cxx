// SPDX-License-Identifier: BSD-3-Clause
// The stated error of a compliance must bound the true error: against the exact layer, a plate, and
// meshes of half the element size, for bodies to which the estimate was not fitted.
#include "ElasticBlocks.h"
#include "Solids/FiniteElements/EnergyError.h"
#include "Mechanics/Numerics/Constants.h"
#include "Solids/TrueShape/ComplianceError.h"
#include "ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

namespace compliance_error
{
namespace
{
using namespace palpate;
using palpate::testing::pointAt;

bool goOn(double)
{
  return true;
}

/// Compliances at all points of a body, with their stated errors.
struct Stated
{
  ElasticBody body;
  PatchCompliances found;
  std::vector<double> errors;

  explicit Stated(ElasticBodyInput input)
  {
    EXPECT_EQ(this->body.assemble(std::move(input)), "");
    EXPECT_EQ(this->body.analyse(StiffnessFactor::Kind::Automatic), "");
    EXPECT_EQ(this->body.factorise(), "");
    std::vector<std::int32_t> points(static_cast<std::size_t>(this->body.surface().pointTotal()));
    std::iota(points.begin(), points.end(), 0);
    this->found = patchCompliances(this->body, points, 0.0, goOn);
    this->errors = complianceErrors(this->body, this->found, goOn);
  }
};

enum class Cells
{
  Hexahedra,
  Tetrahedra,
  QuadraticTetrahedra
};

VolumeMesh meshOf(Cells cells, VolumeMesh hexahedra)
{
  switch (cells)
  {
    case Cells::Hexahedra:
      break;
    case Cells::Tetrahedra:
      return palpate::testing::tetrahedra(hexahedra);
    case Cells::QuadraticTetrahedra:
      return palpate::testing::quadratic(palpate::testing::tetrahedra(hexahedra));
  }
  return hexahedra;
}

constexpr double Height = 10.0;

ElasticBodyInput layer(Cells cells, int elements, double nu)
{
  const int width = 2 * (5 * elements / 2);
  VolumeMesh mesh =
    meshOf(cells, palpate::testing::hexahedronBlock(width, width, elements, Height / elements));
  const std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
  return { std::move(mesh), { { 1.0, nu } }, fixed };
}

/// C_g E* of a layer bonded to a rigid base, 1/mm.
double exactLayer(double nu)
{
  const palpate::testing::ReferenceTable table("layer_bonded_moments.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    if (table.number(row, "nu") == nu)
    {
      return table.number(row, "M0") / (Pi * Height);
    }
  }
  return NotANumber;
}

/// Number of the surface point in the middle of the top.
std::size_t middleOf(const Stated& stated)
{
  const double middle = 0.5 * stated.body.mesh().nodes.row(0).maxCoeff();
  return static_cast<std::size_t>(
    pointAt(stated.body.surface(), Eigen::Vector3d(middle, middle, Height)));
}

/// Fraction of the compliances whose error exceeds the stated error. Coarse elements are compared
/// with elements of half the side, at the points that both meshes have.
double missed(const std::function<ElasticBodyInput(int)>& bodyOf)
{
  const Stated coarse(bodyOf(1));
  const Stated fine(bodyOf(2));
  int compared = 0;
  int beyond = 0;
  for (std::int32_t i = 0; i < coarse.body.surface().pointTotal(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const std::int32_t j = pointAt(fine.body.surface(), coarse.body.surface().position(i));
    if (j >= 0 && coarse.found.status[at] == PatchStatus::Valid &&
      fine.found.status[static_cast<std::size_t>(j)] == PatchStatus::Valid)
    {
      const double better = fine.found.compliance[static_cast<std::size_t>(j)];
      // The error is of second order, so the finer mesh has a third of the difference.
      const double error = 4.0 / 3.0 * std::abs(coarse.found.compliance[at] - better);
      ++compared;
      beyond += error > coarse.errors[at] ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 20);
  std::cout << beyond << " of " << compared << " beyond what is stated\n";
  return static_cast<double>(beyond) / compared;
}

VolumeMesh block(int nx, int ny, int nz, int finer)
{
  return palpate::testing::hexahedronBlock(finer * nx, finer * ny, finer * nz, 1.0 / finer);
}
} // namespace

TEST(ComplianceError, HoldsOnALayer)
{
  for (const double nu : { 0.3, 0.45, 0.49 })
  {
    for (const auto& [cells, elements] :
      { std::pair(Cells::Hexahedra, 2), std::pair(Cells::Hexahedra, 4),
        std::pair(Cells::Tetrahedra, 4), std::pair(Cells::QuadraticTetrahedra, 2) })
    {
      const Stated stated(layer(cells, elements, nu));
      const std::size_t at = middleOf(stated);
      const double exact = exactLayer(nu) * (1.0 - nu * nu); // E = 1
      const double error = std::abs(stated.found.compliance[at] - exact);
      EXPECT_LE(error, stated.errors[at]) << nu << ", " << elements;
    }
  }
}

// The error of the elements is of second order, and a useful bound must decrease with their size.
// Compared in the middle, where the exact C_g does not depend on the mesh.
TEST(ComplianceError, ShrinksWithTheElements)
{
  const auto relative = [](Cells cells, int elements)
  {
    const Stated stated(layer(cells, elements, 0.45));
    return stated.errors[middleOf(stated)] / std::abs(exactLayer(0.45) * (1.0 - 0.45 * 0.45));
  };
  const double coarse = relative(Cells::Hexahedra, 2);
  EXPECT_LT(relative(Cells::Hexahedra, 4), 0.5 * coarse);
  EXPECT_LT(coarse, 0.3);
  EXPECT_LT(relative(Cells::QuadraticTetrahedra, 2), 0.1);
}

TEST(ComplianceError, HoldsOnABlockAtItsEdges)
{
  EXPECT_LE(missed(
              [](int finer)
              {
                VolumeMesh mesh = block(8, 8, 5, finer);
                const std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
                return ElasticBodyInput{ std::move(mesh), { { 0.1, 0.4 } }, fixed };
              }),
    0.05);
}

TEST(ComplianceError, HoldsOnABarThatBends)
{
  EXPECT_LE(missed(
              [](int finer)
              {
                VolumeMesh mesh = block(5, 5, 16, finer);
                const std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
                return ElasticBodyInput{ std::move(mesh), { { 2.0, 0.35 } }, fixed };
              }),
    0.05);
}

TEST(ComplianceError, HoldsOverAStiffBase)
{
  EXPECT_LE(missed(
              [](int finer)
              {
                VolumeMesh mesh = block(8, 8, 6, finer);
                std::vector<ElasticMaterial> materials;
                for (const VolumeElement& element : mesh.elements)
                {
                  const bool isBase = elementMiddle(mesh, element).z() < 2.0;
                  materials.push_back({ isBase ? 10.0 : 0.1, 0.45 });
                }
                const std::vector<unsigned char> fixed = palpate::testing::heldBelow(mesh);
                return ElasticBodyInput{ std::move(mesh), materials, fixed };
              }),
    0.05);
}

TEST(ComplianceError, EndsWhenToldTo)
{
  const Stated stated(layer(Cells::Hexahedra, 2, 0.45));
  EXPECT_TRUE(complianceErrors(stated.body, stated.found, [](double) { return false; }).empty());
}

// A stress that is linear in space equals its averaged stress, so the error is 0. If the stress
// jumps by s between two halves of a bar in tension, the averaged stress is linear in the two
// elements next to the jump: the error is (s/2)²/3/E in each.
TEST(EnergyError, OfALinearFieldIsNothingAndOfAStepItsSlopes)
{
  const VolumeMesh mesh = palpate::testing::hexahedronBlock(4, 2, 2, 1.0);
  ElasticBody body;
  ASSERT_EQ(body.assemble({ mesh, { { 3.0, 0.0 } }, palpate::testing::heldBelow(mesh) }), "");
  Eigen::Matrix3Xd bent = Eigen::Matrix3Xd::Zero(3, mesh.nodeTotal());
  Eigen::Matrix3Xd step = bent;
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    const Eigen::Vector3d x = mesh.nodes.col(i);
    bent.col(i) << 0.1 * x[0] * x[2], 0.0, -0.05 * x[0] * x[0]; // pure bending, ν = 0
    step(0, i) = 0.2 * std::max(0.0, x[0] - 2.0);
  }
  const std::vector<double> found = energyErrors(body, { bent, step });
  const double jump = 3.0 * 0.2;
  const double section = 4.0;
  EXPECT_NEAR(found[0], 0.0, 1e-12); // the modes represent bending exactly
  EXPECT_NEAR(found[1], 2.0 * section * 0.25 * jump * jump / 3.0 / 3.0, 1e-12);
}
} // namespace compliance_error
