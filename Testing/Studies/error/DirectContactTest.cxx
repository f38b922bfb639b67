// SPDX-License-Identifier: BSD-3-Clause
// Direct contact on meshes small enough for a test: against the exact law of a bonded layer,
// straight and oblique, and for rotated bodies.
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/ReducedModulus.h"
#include "Solids/ShapedBodies.h"
#include "TestTools.h"
#include "Solids/TrueShape/DirectContact.h"

#include <Eigen/Geometry>

#include <cmath>
#include <memory>

namespace
{
using namespace palpate;
using namespace palpate::testing;

constexpr double Young = 1.0;
constexpr double Poisson = 0.45;
constexpr double Thickness = 4.0;

/// A layer on a rigid base at z = 0, five times as wide as thick. Facets around the middle are
/// `side` long.
VolumeMesh layer(double side, bool isOfTetrahedra)
{
  const std::vector<double> across = gradedLine(side, 1.75, 1.5, 2.5 * Thickness);
  const VolumeMesh mesh = gridBlock(across, across, gradedDepth(side, 0.7, 1.5, Thickness));
  return isOfTetrahedra ? quadratic(tetrahedra(mesh)) : mesh;
}

struct Layer
{
  explicit Layer(double side, bool isOfTetrahedra = false,
    const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
  {
    ElasticBodyInput input;
    input.mesh = layer(side, isOfTetrahedra);
    input.fixed = heldBelow(input.mesh);
    input.mesh.nodes = turn * input.mesh.nodes;
    input.materials = { { Young, Poisson } };
    EXPECT_EQ(this->Body.assemble(std::move(input)), "");
    EXPECT_EQ(this->Body.analyse(StiffnessFactor::Kind::Automatic), "");
    EXPECT_EQ(this->Body.factorise(), "");
  }
  ElasticBody Body;
};

double exact(const AxisymmetricTool& pressed, double depth)
{
  const LayerContact contact(
    pressed, std::make_shared<const LayerKernel>(Poisson, LayerBase::Bonded), Thickness);
  return contact.evaluate(depth, reducedModulus(Young, Poisson)).force;
}

const Eigen::Vector3d Top(0.0, 0.0, Thickness);
const DirectPlace Straight{ Top, -Eigen::Vector3d::UnitZ() };

/// The force of the nodal contact of the reference sheet is 0.5 to 1 % too large with five facets
/// over the contact radius. Linear elements need more facets.
TEST(DirectContact, SphereOnALayer)
{
  const auto sphere = tool("sphere:6.35");
  const Layer tetrahedra(0.4, true);
  const DirectContact onTetrahedra(tetrahedra.Body, *sphere, Straight, 0.4);
  EXPECT_NEAR(onTetrahedra.at(0.4).force / exact(*sphere, 0.4), 1.0, 0.01);
  const Layer hexahedra(0.2);
  const DirectContact contact(hexahedra.Body, *sphere, Straight, 0.4);
  for (const double depth : { 0.2, 0.4 })
  {
    EXPECT_NEAR(contact.at(depth).force / exact(*sphere, depth), 1.0, 0.015) << depth;
  }
}

/// The pressure is infinite at the rim, which is inside a facet. Therefore the error is
/// proportional to the facet length, here 0.2 of the radius.
TEST(DirectContact, FlatOnALayer)
{
  const auto flat = tool("flat:1.6");
  const Layer layer(0.32, true);
  const DirectContact contact(layer.Body, *flat, Straight, 0.3);
  EXPECT_NEAR(contact.at(0.3).force / exact(*flat, 0.3), 1.0, 0.03);
}

/// A rotation of the whole problem does not change the force, except through the position of the
/// tool's frame relative to the facets.
TEST(DirectContact, TurnedInSpace)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const auto sphere = tool("sphere:6.35");
  const Layer layer(0.4);
  const Layer turned(0.4, false, turn);
  const DirectContact one(layer.Body, *sphere, Straight, 0.3);
  const DirectContact other(turned.Body, *sphere, { turn * Top, turn * Straight.inward }, 0.3);
  EXPECT_EQ(one.corners(), other.corners());
  EXPECT_NEAR(other.at(0.3).force / one.at(0.3).force, 1.0, 1e-8);
}

/// A ball of radius R, pressed obliquely by α without friction. Its lowest point starts in the
/// surface and ends at a depth of R - (R - δ) cos α. The force along its path is cos α times the
/// normal force.
TEST(DirectContact, Aslant)
{
  constexpr double radius = 6.35;
  constexpr double depth = 0.2;
  const auto sphere = tool("sphere:6.35");
  const Layer layer(0.25);
  for (const double degrees : { 10.0, 15.0 })
  {
    const double aslant = degrees * std::acos(-1.0) / 180.0;
    // At the end of the press, the point of first contact is in the fine middle of the mesh.
    const Eigen::Vector3d inward(std::sin(aslant), 0.0, -std::cos(aslant));
    const Eigen::Vector3d place((radius - depth) * -std::sin(aslant), 0.0, 0.0);
    const DirectPlace at{ Top - place, inward };
    const double deep = radius - (radius - depth) * std::cos(aslant);
    const double expected = std::cos(aslant) * exact(*sphere, deep);
    const DirectContact contact(layer.Body, *sphere, at, depth);
    for (const Pushed pushed : { Pushed::TogetherAlongTheMean, Pushed::EachAlongItsOwn })
    {
      EXPECT_NEAR(contact.at(depth, pushed).force / expected, 1.0, 0.03) << degrees;
    }
  }
}

TEST(DirectContact, NothingTouches)
{
  const auto sphere = tool("sphere:6.35");
  const Layer layer(0.5);
  const DirectContact contact(
    layer.Body, *sphere, { Top + Eigen::Vector3d(0.0, 0.0, 5.0), Straight.inward }, 1.0);
  EXPECT_EQ(contact.corners(), 0);
  EXPECT_EQ(contact.at(1.0).force, 0.0);
}
} // namespace
