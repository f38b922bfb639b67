// SPDX-License-Identifier: BSD-3-Clause
// A tilted tool at every point of a body: the force is interpolated correctly between the nodes of
// the laws.
#include "Laws/MaterialTilts.h"

#include "Laws/BodyMaterial.h"
#include "Mechanics/Tilt/TiltNodes.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

using namespace palpate;

namespace
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

std::unique_ptr<AxisymmetricTool> toolOf(const std::string& text)
{
  ToolSpecification specification;
  std::string error;
  EXPECT_TRUE(parseTool(text, specification, error)) << error;
  return makeTool(specification);
}

BodyMaterial bodyOf(
  BodyMaterial::Constants constants, BodyMaterial::Values values, std::size_t points)
{
  BodyMaterial material(std::move(constants));
  EXPECT_EQ(material.take(std::move(values), points), "");
  return material;
}

double forceOf(const TiltTable& table, const float* weights, const AxisymmetricTool& tool,
  const TiltBody& body, double depth, double angle)
{
  std::vector<double> shares(weights, weights + table.terms().laws);
  const TiltFactor tau = table.at(depth, angle, shares.data());
  const TiltWork upright = pressedInto(tool, body, depth);
  return upright.force * tau.value + upright.work * tau.byDepth;
}

/// Compares the force at each point, interpolated by its weights, with that of a table made for
/// this point.
void compare(const std::string& text, double range, double largest, const BodyMaterial& material,
  std::size_t points, double tolerance)
{
  const auto tool = toolOf(text);
  const ContactSpots spots = material.spots();
  const MaterialTilts tilt = tiltsOf(*tool, range, largest, material.range(), spots, points);
  ASSERT_EQ(tilt.fault, "");
  const auto laws = static_cast<std::size_t>(tilt.table.terms().laws);
  ASSERT_EQ(tilt.weights.size(), points * laws);
  ASSERT_LE(laws, static_cast<std::size_t>(TiltTerms::MostLaws));
  std::vector<TiltBody> bodies;
  for (std::size_t i = 0; i < points; ++i)
  {
    const ContactSpot spot = spots.at(i);
    bodies.push_back({ spot.thickness,
      spot.thickness > 0.0
        ? std::make_shared<const LayerKernel>(spot.poissonRatio, LayerBase::Bonded)
        : nullptr,
      spot.compliance * spot.reducedModulus });
  }
  const MadeTilt own = makeTiltTable(*tool, range, largest, bodies);
  ASSERT_EQ(own.fault, "");
  for (std::size_t i = 0; i < points; ++i)
  {
    const float* weights = tilt.weights.data() + i * laws;
    EXPECT_NEAR(std::accumulate(weights, weights + laws, 0.0), 1.0, 1e-6); // weights are floats
    EXPECT_GE(*std::min_element(weights, weights + laws), 0.0F);
    std::vector<float> alone(points, 0.0F);
    alone[i] = 1.0F;
    for (const double depth : { 0.4 * range, 0.9 * range })
    {
      for (const double angle : { 0.4 * largest, largest })
      {
        const double direct = forceOf(own.table, alone.data(), *tool, bodies[i], depth, angle);
        EXPECT_NEAR(
          forceOf(tilt.table, weights, *tool, bodies[i], depth, angle), direct, tolerance * direct)
          << text << ", point " << i << ", depth " << depth << ", angle " << angle / Degree;
      }
    }
  }
}
} // namespace

TEST(MaterialTilts, AModulusAloneIsOneLaw)
{
  BodyMaterial::Values values;
  values.youngsModulus = { "E", { 0.1, 0.2, 5.0 } };
  const BodyMaterial material =
    bodyOf({ 0.1, 0.45, 0.0, LayerBase::Bonded, false }, std::move(values), 3);
  const auto tool = toolOf("flat:1");
  const MaterialTilts tilt =
    tiltsOf(*tool, 1.0, 30.0 * Degree, material.range(), material.spots(), 3);
  ASSERT_EQ(tilt.fault, "");
  EXPECT_EQ(tilt.table.terms().laws, 1);
  EXPECT_TRUE(tilt.weights.empty());
  EXPECT_EQ(tilt.error, 0.0);
  EXPECT_EQ(tilt.thinnest, 0.0);
}

// Error of the linear interpolation between nodes: 1 % of the force.
TEST(MaterialTilts, ThicknessesAreMetBetweenTheNodes)
{
  BodyMaterial::Values values;
  values.thickness = { "h", { 1.6, 2.6, 0.0 } };
  const BodyMaterial material =
    bodyOf({ 0.1, 0.45, 0.0, LayerBase::Bonded, false }, std::move(values), 3);
  compare("flat:1", 0.5, 20.0 * Degree, material, 3, 0.01);
}

TEST(MaterialTilts, APointedToolToo)
{
  BodyMaterial::Values values;
  values.thickness = { "h", { 1.1, 1.7, 2.9 } };
  const BodyMaterial material =
    bodyOf({ 0.1, 0.45, 0.0, LayerBase::Bonded, false }, std::move(values), 3);
  compare("cone:60", 1.0, 15.0 * Degree, material, 3, 0.01);
}

TEST(MaterialTilts, CompliancesAreMetBetweenTheNodes)
{
  BodyMaterial::Values values;
  values.youngsModulus = { "E", { 0.1, 0.2, 0.1, 0.3 } };
  values.compliance = { "C", { 0.3, 1.1, 3.7, 8.0 } };
  const BodyMaterial material =
    bodyOf({ 0.1, 0.45, 0.0, LayerBase::Bonded, false }, std::move(values), 4);
  compare("cone:60", 1.0, 15.0 * Degree, material, 4, 0.01);
  compare("flat:1", 0.5, 20.0 * Degree, material, 4, 0.01);
}

// The grid over several varying quantities is coarser: 2 %.
TEST(MaterialTilts, SeveralThingsMakeAGrid)
{
  BodyMaterial::Values values;
  values.thickness = { "h", { 1.5, 2.0, 2.6 } };
  values.compliance = { "C", { 0.5, 0.1, 0.9 } };
  const BodyMaterial material =
    bodyOf({ 0.1, 0.45, 0.0, LayerBase::Bonded, true }, std::move(values), 3);
  compare("cone:60", 1.0, 15.0 * Degree, material, 3, 0.02);
}

TEST(MaterialTilts, AStackHasAKernelOfItsOwn)
{
  // A stack of two equal layers is one layer of their total thickness.
  const BodyMaterial two =
    bodyOf({ 0.1, 0.45, 1.0, LayerBase::Bonded, false, { StackLayer{ 2.0, 0.1, 0.45 } } }, {}, 1);
  const BodyMaterial one = bodyOf({ 0.1, 0.45, 3.0, LayerBase::Bonded, false }, {}, 1);
  const auto tool = toolOf("cone:60");
  const MaterialTilts stacked = tiltsOf(*tool, 0.8, 15.0 * Degree, two.range(), two.spots(), 1);
  const MaterialTilts single = tiltsOf(*tool, 0.8, 15.0 * Degree, one.range(), one.spots(), 1);
  ASSERT_EQ(stacked.fault, "");
  ASSERT_EQ(single.fault, "");
  // LayerStack agrees with one layer to 1e-12. The table of its kernel has an error of 1e-10,
  // divided by differences of 1e-2 of y.
  EXPECT_NEAR(stacked.table.at(0.5, 0.2).value, single.table.at(0.5, 0.2).value, 1e-7);
  EXPECT_GT(single.table.at(0.5, 0.2).value, 1.1);
}

TEST(MaterialTilts, RefusesInWords)
{
  const BodyMaterial material = bodyOf({ 0.1, 0.45, 0.0, LayerBase::Bonded, false }, {}, 1);
  const MaterialTilts steep =
    tiltsOf(*toolOf("cone:60"), 1.0, 40.0 * Degree, material.range(), material.spots(), 1);
  EXPECT_NE(steep.fault.find("40 degrees"), std::string::npos) << steep.fault;
  EXPECT_NE(steep.fault.find("26 degrees"), std::string::npos) << steep.fault;
  const BodyMaterial thin = bodyOf({ 0.1, 0.45, 0.02, LayerBase::Bonded, false }, {}, 1);
  const MaterialTilts deep =
    tiltsOf(*toolOf("cone:60"), 1.0, 10.0 * Degree, thin.range(), thin.spots(), 1);
  EXPECT_NE(deep.fault.find("0.02 mm"), std::string::npos) << deep.fault;
}

TEST(MaterialTilts, ALayerTooThinTakesTheThinnestThatAnswers)
{
  BodyMaterial::Values values;
  values.thickness = { "h", { 0.02, 0.4 } };
  const BodyMaterial material =
    bodyOf({ 0.1, 0.45, 0.0, LayerBase::Bonded, false }, std::move(values), 2);
  const MaterialTilts tilt =
    tiltsOf(*toolOf("cone:60"), 1.0, 10.0 * Degree, material.range(), material.spots(), 2);
  ASSERT_EQ(tilt.fault, "");
  EXPECT_GT(tilt.thinnest, 0.02);
  const auto laws = static_cast<std::size_t>(tilt.table.terms().laws);
  EXPECT_EQ(tilt.weights[laws - 1], 1.0F);
  EXPECT_EQ(tilt.weights[laws], 1.0F);
}
