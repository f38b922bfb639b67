// SPDX-License-Identifier: BSD-3-Clause
// The choice between a point's own curve and the curve of direct contact, on a bonded layer, whose
// exact law is known.
#include "Solids/Curves/DirectCurve.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/ReducedModulus.h"
#include "Solids/ShapedBodies.h"
#include "TestTools.h"

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace direct_curve
{
namespace
{
using namespace palpate;
using namespace palpate::testing;

constexpr double Thickness = 4.0;
constexpr double Depth = 0.4;
constexpr int Samples = 8;
constexpr ElasticMaterial Material{ 1.0, 0.45 };

/// A layer on a rigid base at z = 0, with facets of this side around the middle.
struct Layer
{
  explicit Layer(double side)
  {
    const std::vector<double> across = gradedLine(side, 1.75, 1.7, 2.0 * Thickness);
    ElasticBodyInput input;
    input.mesh =
      quadratic(tetrahedra(gridBlock(across, across, gradedDepth(side, 0.5, 1.7, Thickness))));
    input.fixed = heldBelow(input.mesh);
    input.materials = { Material };
    EXPECT_EQ(this->Body.assemble(std::move(input)), "");
    EXPECT_EQ(this->Body.analyse(StiffnessFactor::Kind::Automatic), "");
    EXPECT_EQ(this->Body.factorise(), "");
  }
  ElasticBody Body;
};

class DirectCurve : public ::testing::Test
{
protected:
  /// Sets the point's curve to the exact curve times a factor, up to a depth, with the same stated
  /// error everywhere.
  void fill(double factor, double stated, double range = Depth)
  {
    for (int k = 0; k < Samples; ++k)
    {
      const auto i = static_cast<std::size_t>(k);
      const IndentationPoint exact =
        this->Exact.evaluate(this->Sampling.depth(k, range), this->Modulus);
      this->Force[i] = static_cast<float>(factor * exact.force);
      this->Stiffness[i] = static_cast<float>(factor * exact.stiffness);
      this->Error[i] = static_cast<float>(stated);
    }
    this->Range = static_cast<float>(range);
  }

  /// Returns the outcome for contacts on two meshes.
  DirectOutcome take(const DirectPress& finer, const DirectPress& coarser, bool finite = false)
  {
    const DirectTerms terms{ this->Sphere.get(), Material, Depth, 0.05, nullptr, finite };
    return takeDirectCurve(0, finer, coarser, terms, this->Sampling,
      { Samples, this->Force.data(), this->Stiffness.data(), &this->Range, &this->Validity,
        &this->Status, &this->Limit, this->Error.data() });
  }

  /// A press at a place at this height above the base.
  static DirectPress press(const ElasticBody& body, const AxisymmetricTool& sphere, double height)
  {
    const DirectPlace at{ { 0.0, 0.0, height }, -Eigen::Vector3d::UnitZ() };
    return { {}, std::make_unique<DirectContact>(body, sphere, at, Depth) };
  }

  const std::shared_ptr<const AxisymmetricTool> Sphere = tool("sphere:6.35");
  const LayerContact Exact{ *Sphere,
    std::make_shared<const LayerKernel>(Material.poissonRatio, LayerBase::Bonded), Thickness };
  const double Modulus = reducedModulus(Material.youngsModulus, Material.poissonRatio);
  const ResponseSampling Sampling{ Samples, 1.5 };
  std::array<float, Samples> Force{};
  std::array<float, Samples> Stiffness{};
  std::array<float, Samples> Error{};
  float Range = 0.0F;
  float Validity = 0.0F;
  unsigned char Status = static_cast<unsigned char>(ResponseStatus::Edge);
  unsigned char Limit = 0;
};

/// A law with a smaller error is kept, and so is any law at a place where the tool touches nothing.
/// Three laws are replaced: one whose stated error is half of its force, one whose force is half of
/// the exact one but whose stated error is small, and one that ends at a fifth of the depth. Four
/// facets over the contact radius, as in DirectContactTest, have an error of 2 %.
TEST_F(DirectCurve, TheCurveThatIsBetterKnownIsTaken)
{
  const Layer fine(0.45);
  const Layer coarse(0.7);
  const DirectPress finer = press(fine.Body, *this->Sphere, Thickness);
  const DirectPress coarser = press(coarse.Body, *this->Sphere, Thickness);
  this->fill(1.0, 0.002);
  std::array<float, Samples> former = this->Force;
  EXPECT_EQ(this->take(finer, coarser), DirectOutcome::Kept);
  EXPECT_EQ(this->Force, former);
  EXPECT_EQ(this->Validity, 0.0F);

  this->fill(1.0, 1.0);
  former = this->Force;
  const DirectPress above = press(coarse.Body, *this->Sphere, Thickness + 5.0);
  EXPECT_EQ(this->take(above, above), DirectOutcome::Failed);
  EXPECT_EQ(this->Force, former);
  const DirectTerms terms{ this->Sphere.get(), Material, Depth, 1e-6, nullptr, false };
  EXPECT_FALSE(meshesAgree(above, above, terms));
  EXPECT_TRUE(meshesAgree(finer, finer, terms));

  for (const auto& [factor, stated, range] :
    { std::array<double, 3>{ 1.3, 0.5, Depth }, { 0.5, 0.01, Depth }, { 0.9, 0.01, 0.2 * Depth } })
  {
    this->fill(factor, stated, range);
    ASSERT_EQ(this->take(finer, coarser), DirectOutcome::Replaced) << factor;
    EXPECT_EQ(this->Range, static_cast<float>(Depth));
    EXPECT_EQ(this->Status, static_cast<unsigned char>(ResponseStatus::Valid));
    float before = 0.0F;
    for (int k = 0; k < Samples; ++k)
    {
      const auto i = static_cast<std::size_t>(k);
      const IndentationPoint exact =
        this->Exact.evaluate(this->Sampling.depth(k, Depth), this->Modulus);
      const double error = std::abs(static_cast<double>(this->Force[i]) / exact.force - 1.0);
      EXPECT_GT(this->Force[i], before) << k;
      before = this->Force[i];
      // at smaller depths the contact is smaller than two facets, and the point's own curve is used
      if (k >= 3)
      {
        EXPECT_LE(error, static_cast<double>(this->Error[i])) << factor << " " << k;
      }
      if (k == Samples - 1)
      {
        EXPECT_LT(error, 0.02) << factor;
        // Error of slopes over steps in which the contact radius grows by a third.
        EXPECT_NEAR(static_cast<double>(this->Stiffness[i]) / exact.stiffness, 1.0, 0.08);
      }
    }
  }
}

/// At finite strain the reference is the exact law times the factor from the axisymmetric solver's
/// tables. The point's own curve is kept if one of the meshes has no contact at finite strain.
TEST_F(DirectCurve, FiniteStrainIsSolvedForWhereAsked)
{
  const Layer fine(0.7);
  const Layer coarse(1.05);
  const DirectPlace at{ { 0.0, 0.0, Thickness }, -Eigen::Vector3d::UnitZ() };
  DirectPress finer{ pressAtFiniteStrain(fine.Body, *this->Sphere, at, Depth), nullptr };
  DirectPress coarser{ pressAtFiniteStrain(coarse.Body, *this->Sphere, at, Depth), nullptr };
  StrainBodies bodies;
  bodies.hasHalfSpace = false;
  bodies.thinnest = bodies.thickest = Thickness;
  std::unique_ptr<StrainCorrection> strain;
  const auto goOn = [](double) { return true; };
  ASSERT_EQ(makeStrainCorrection(
              *this->Sphere, { StrainModel::NeoHooke, 0.0 }, bodies, Depth, goOn, strain),
    "");
  this->fill(1.3, 0.5);
  ASSERT_EQ(this->take(finer, coarser, true), DirectOutcome::Replaced);
  for (int k = 3; k < Samples; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const double depth = this->Sampling.depth(k, Depth);
    const double exact = this->Exact.evaluate(depth, this->Modulus).force *
      strain->at(depth, Material.poissonRatio, Thickness).factor;
    const double error = std::abs(static_cast<double>(this->Force[i]) / exact - 1.0);
    EXPECT_LE(error, static_cast<double>(this->Error[i])) << k;
    EXPECT_GE(this->Error[i], 0.01F);
  }
  DirectTerms terms{ this->Sphere.get(), Material, Depth, 0.05, nullptr, true };
  const double difference =
    std::abs(coarser.finite.evaluate(Depth).force / finer.finite.evaluate(Depth).force - 1.0);
  ASSERT_GT(difference, 0.01); // difference of the two meshes
  EXPECT_TRUE(meshesAgree(finer, coarser, terms));
  terms.errorTolerance = 0.99 * difference;
  EXPECT_FALSE(meshesAgree(finer, coarser, terms));
  EXPECT_LT(this->Error.back(), 0.04F);
  EXPECT_EQ(this->Limit, static_cast<unsigned char>(ResponseLimit::None));

  coarser.finite = {};
  coarser.small = press(coarse.Body, *this->Sphere, Thickness).small;
  EXPECT_FALSE(meshesAgree(finer, coarser, terms));
  this->fill(1.3, 0.5);
  const std::array<float, Samples> force = this->Force;
  EXPECT_EQ(this->take(finer, coarser, true), DirectOutcome::Failed);
  EXPECT_EQ(this->Force, force);
}
} // namespace
} // namespace direct_curve
