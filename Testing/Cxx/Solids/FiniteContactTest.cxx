// SPDX-License-Identifier: BSD-3-Clause
// Contact at finite strain on tetrahedra: derivatives of the element, a layer against the
// axisymmetric solver's tables, and a part of a bending bar against the whole bar.
#include "Solids/TrueShape/FiniteTetrahedron.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/ReducedModulus.h"
#include "Solids/ShapedBodies.h"
#include "TestTools.h"
#include "Solids/TrueShape/DirectContact.h"
#include "Solids/TrueShape/FiniteContact.h"
#include "Solids/TrueShape/FinitePart.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace
{
using namespace palpate;
using namespace palpate::testing;

constexpr ElasticMaterial Soft{ 0.1, 0.45 };

void solve(VolumeMesh mesh, std::vector<unsigned char> fixed, ElasticBody& body)
{
  ASSERT_EQ(body.assemble({ std::move(mesh), { Soft }, std::move(fixed) }), "");
  ASSERT_EQ(body.analyse(StiffnessFactor::Kind::Automatic), "");
  ASSERT_EQ(body.factorise(), "");
}

/// At rest the element is the linear one. In other states the forces are the derivatives of the
/// energy, and the stiffness is the derivative of the forces.
TEST(FiniteTetrahedron, ForcesAndStiffnessAreDerivatives)
{
  const VolumeMesh mesh = quadratic(tetrahedra(hexahedronBlock(1, 1, 1, 2.0)));
  ElementNodes nodes = elementNodes(mesh, mesh.elements.front());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.05, 0.05);
  nodes = nodes.unaryExpr([&](double x) { return x + shift(random); });
  const FiniteTetrahedron element(nodes);
  FiniteTetrahedron::Vector u = FiniteTetrahedron::Vector::Zero();
  FiniteTetrahedron::Vector forces;
  ElementMatrix stiffness;
  ElementMatrix linear;
  element.linearize(Soft, u, forces, stiffness);
  ASSERT_TRUE(elementStiffness(ElementKind::QuadraticTetrahedron, nodes, Soft, linear));
  EXPECT_LT((stiffness - linear).cwiseAbs().maxCoeff(), 1e-13 * linear.cwiseAbs().maxCoeff());
  EXPECT_LT(forces.cwiseAbs().maxCoeff(), 1e-15);

  u = u.unaryExpr([&](double) { return 5.0 * shift(random); }); // strains of some tenths
  element.linearize(Soft, u, forces, stiffness);
  constexpr double step = 1e-5; // central difference: truncation step², rounding 1e-16 / step
  for (Eigen::Index i = 0; i < u.size(); ++i)
  {
    FiniteTetrahedron::Vector more = u;
    FiniteTetrahedron::Vector less = u;
    more[i] += step;
    less[i] -= step;
    EXPECT_NEAR((element.energy(Soft, more) - element.energy(Soft, less)) / (2.0 * step), forces[i],
      1e-8 * forces.cwiseAbs().maxCoeff());
    FiniteTetrahedron::Vector upper;
    FiniteTetrahedron::Vector lower;
    ElementMatrix unused;
    element.linearize(Soft, more, upper, unused);
    element.linearize(Soft, less, lower, unused);
    const Eigen::VectorXd slope = (upper - lower) / (2.0 * step);
    EXPECT_LT(
      (slope - stiffness.col(i)).cwiseAbs().maxCoeff(), 1e-7 * stiffness.cwiseAbs().maxCoeff());
  }
  u.setZero();
  u[0] = 10.0; // moves one corner through the opposite face
  EXPECT_EQ(element.energy(Soft, u), HUGE_VAL);
}

/// A quarter of a bonded layer, against the exact law at small strain times the factor of finite
/// strain from the axisymmetric solver's tables.
TEST(FiniteContact, OnALayerIsThatOfTheAxisymmetricSolver)
{
  constexpr double thickness = 3.0;
  constexpr double depth = 0.6;
  const auto sphere = tool("sphere:6.35");
  const std::vector<double> across = gradedHalf(0.5, 2.5, 1.7, 2.5 * thickness);
  const VolumeMesh mesh =
    quadratic(tetrahedra(gridBlock(across, across, gradedDepth(0.5, 1.0, 1.6, thickness))));
  std::vector<unsigned char> fixed = heldBelow(mesh);
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    const auto node = mesh.nodes.col(static_cast<Eigen::Index>(i));
    fixed[i] = static_cast<unsigned char>(
      fixed[i] | (node[0] == 0.0 ? FixedX : 0) | (node[1] == 0.0 ? FixedY : 0));
  }
  ElasticBody body;
  solve(mesh, fixed, body);
  const DirectPlace place{ { 0.0, 0.0, thickness }, -Eigen::Vector3d::UnitZ() };
  const ContactCurve contact = pressAtFiniteStrain(body, *sphere, place, depth);
  const LayerContact exact{ *sphere,
    std::make_shared<const LayerKernel>(Soft.poissonRatio, LayerBase::Bonded), thickness };
  const double modulus = reducedModulus(Soft.youngsModulus, Soft.poissonRatio);
  StrainBodies bodies;
  bodies.hasHalfSpace = false;
  bodies.thinnest = bodies.thickest = thickness;
  std::unique_ptr<StrainCorrection> strain;
  const auto goOn = [](double) { return true; };
  ASSERT_EQ(
    makeStrainCorrection(*sphere, { StrainModel::NeoHooke, 0.0 }, bodies, depth, goOn, strain), "");
  ASSERT_GE(contact.deepest(), depth);
  const auto expected = [&](double deflection)
  {
    return 0.25 * exact.evaluate(deflection, modulus).force *
      strain->at(deflection, Soft.poissonRatio, thickness).factor;
  };
  // Four to five facets over the contact radius have an error of 1 %, the tables 0.1 %.
  for (const double deflection : { 0.4, 0.5, depth })
  {
    const IndentationPoint found = contact.evaluate(deflection);
    const double step = 0.05 * deflection;
    const double slope = (expected(deflection + step) - expected(deflection - step)) / (2.0 * step);
    EXPECT_NEAR(found.force / expected(deflection), 1.0, 0.01) << deflection;
    EXPECT_NEAR(found.stiffness / slope, 1.0, 0.03) << deflection;
  }
  // Between the solved depths the curve is smooth, and its stiffness is the slope.
  for (double deflection = 0.05; deflection < 0.57; deflection += 0.03)
  {
    const double slope =
      (contact.evaluate(deflection + 1e-5).force - contact.evaluate(deflection - 1e-5).force) /
      2e-5;
    EXPECT_NEAR(contact.evaluate(deflection).stiffness, slope, 1e-4 * slope) << deflection;
  }
  EXPECT_TRUE(std::isnan(contact.evaluate(1.5 * depth).force));
}

/// A groove that is too narrow for the ball: the ball touches the walls nearly four depths before
/// it would reach the place. Pressed from this first touch, the contact is the same at the same
/// height.
TEST(FiniteContact, InAGrooveItBeginsWhereItFirstTouches)
{
  constexpr double height = 4.0;
  constexpr double higher = 0.6;
  constexpr double depth = 0.3;
  constexpr double slope = 1.2;
  const std::vector<double> across = { -4, -3, -2.2, -1.6, -1.1, -0.7, -0.3, 0, 0.3, 0.7, 1.1, 1.6,
    2.2, 3, 4 };
  const std::vector<double> along = { 0, 1, 1.6, 2, 2.4, 3, 4 };
  VolumeMesh mesh = gridBlock(across, along, { 0.0, 2.0, 3.2, height });
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    mesh.nodes(2, i) *= 1.0 + slope / height * std::abs(mesh.nodes(0, i));
  }
  mesh = quadratic(tetrahedra(mesh));
  ElasticBody body;
  solve(mesh, heldBelow(mesh), body);
  // first touch 1.12 mm above the place: 2 (sec(atan 1.2) - 1)
  const auto sphere = tool("sphere:2");
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  const DirectPlace bottom{ { 0.0, 2.0, height }, down };
  const ContactCurve contact = pressAtFiniteStrain(body, *sphere, bottom, depth);
  const ContactCurve above =
    pressAtFiniteStrain(body, *sphere, { { 0.0, 2.0, height + higher }, down }, depth + higher);
  ASSERT_GE(contact.deepest(), depth);
  ASSERT_GE(above.deepest(), depth + higher);
  for (const double deflection : { 0.06, 0.15, depth })
  {
    const double expected = above.evaluate(deflection + higher).force;
    EXPECT_NEAR(contact.evaluate(deflection).force, expected, 0.01 * expected) << deflection;
  }
  // The first touch is too far above the place for a depth of a hundredth.
  EXPECT_EQ(pressAtFiniteStrain(body, *sphere, bottom, 0.01 * depth).deepest(), 0.0);
  // Tolerance: parts of facets are half a millimetre long.
  EXPECT_NEAR(DirectContact(body, *sphere, bottom, depth).touchesBefore(),
    2.0 * (std::sqrt(1.0 + slope * slope) - 1.0), 0.02);
}

/// A column under 1.9 times its buckling load (Euler). Its tangent stiffness is indefinite. Twice
/// the stiffness at rest makes the sum positive definite, so that a step reduces the energy.
TEST(FinitePart, StiffenedAsAtRestItsTangentIsPositive)
{
  const VolumeMesh mesh = quadratic(tetrahedra(hexahedronBlock(1, 1, 10, 1.0)));
  ElasticBody body;
  solve(mesh, heldBelow(mesh), body);
  const auto sphere = tool("sphere:6.35");
  const ToolOutline outline(*sphere, 5.0, 0.0);
  const DirectPlace top{ { 0.5, 0.5, 10.0 }, -Eigen::Vector3d::UnitZ() };
  FinitePart part(body, *sphere, outline, top, 0.5, nullptr);
  Eigen::VectorXd pressed = Eigen::VectorXd::Zero(part.unknowns());
  constexpr double strain = 0.004; // π² / (4 · 12 · 10²) = 0.0021 is the buckling strain
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double from = axis < 2 ? 0.5 : 0.0;
      const double along = axis < 2 ? Soft.poissonRatio * strain : -strain;
      const int unknown = body.unknown(i, axis);
      if (unknown >= 0)
      {
        pressed[unknown] = along * (mesh.nodes(axis, i) - from);
      }
    }
  }
  constexpr double untouched = -20.0;
  Eigen::VectorXd gradient;
  part.linearize(Eigen::VectorXd::Zero(part.unknowns()), untouched,
    FinitePart::ToolCurvature::Included, gradient);
  const Eigen::MatrixXd atRest = part.stiffness();
  part.linearize(pressed, untouched, FinitePart::ToolCurvature::Included, gradient);
  const Eigen::MatrixXd before = part.stiffness();
  const auto isPositive = [](const Eigen::MatrixXd& lower)
  { return Eigen::LLT<Eigen::MatrixXd>(lower).info() == Eigen::Success; };
  EXPECT_TRUE(isPositive(atRest));
  EXPECT_FALSE(isPositive(before));
  part.stiffen(2.0);
  const Eigen::MatrixXd after = part.stiffness();
  EXPECT_TRUE(isPositive(after));
  EXPECT_LT((after - before - 2.0 * atRest).cwiseAbs().maxCoeff(), 1e-13 * after.maxCoeff());
  const Eigen::VectorXd step = -after.selfadjointView<Eigen::Lower>().llt().solve(gradient);
  EXPECT_LT(part.energy(pressed + 0.1 * step, untouched), part.energy(pressed, untouched));
}

/// If the surroundings of a part do not move, the part is solved as if held there, even if coarse
/// cells give a small negative compliance.
TEST(FiniteContact, ARestThatDoesNotMoveIsHeld)
{
  constexpr double depth = 0.2;
  const VolumeMesh mesh = quadratic(tetrahedra(hexahedronBlock(3, 3, 3, 1.0)));
  ElasticBody body;
  solve(mesh, heldBelow(mesh), body);
  const auto sphere = tool("sphere:6.35");
  const DirectPlace on{ { 1.5, 1.5, 3.0 }, -Eigen::Vector3d::UnitZ() };
  const double expected = pressAtFiniteStrain(body, *sphere, on, depth).evaluate(depth).force;
  ASSERT_GT(expected, 0.0);
  UnitMotion still;
  still.about = on.place;
  for (Eigen::Matrix3Xd& moved : still.nodes)
  {
    moved.setZero(3, mesh.nodes.cols());
  }
  EXPECT_EQ(pressAtFiniteStrain(body, *sphere, on, depth, &still).evaluate(depth).force, expected);
  // The surroundings rotate against a moment about x, by less than a thousandth of the rotation of
  // the contact.
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    const Eigen::Vector3d arm = mesh.nodes.col(i) - on.place;
    still.nodes[3].col(i) = -1e-3 * Eigen::Vector3d::UnitX().cross(arm);
  }
  EXPECT_EQ(pressAtFiniteStrain(body, *sphere, on, depth, &still).evaluate(depth).force, expected);
}

/// Depth at which a ball reaches facets of marked nodes: the outline of the ball meets the nearest
/// facet.
TEST(ToolFacets, AreMetWhereTheOutlineMeetsThem)
{
  const VolumeMesh mesh = hexahedronBlock(4, 4, 2, 1.0);
  ElasticBody body;
  solve(mesh, heldBelow(mesh), body);
  const auto sphere = tool("sphere:3");
  const DirectPlace on{ { 1.0, 2.0, 2.0 }, -Eigen::Vector3d::UnitZ() };
  const std::vector<ToolFacet> under = facetsUnder(body, *sphere, on, 1.0);
  std::vector<unsigned char> marked(static_cast<std::size_t>(mesh.nodeTotal()), 0);
  EXPECT_EQ(depthOfMarked(under, marked, *sphere), HUGE_VAL);
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    marked[static_cast<std::size_t>(i)] = mesh.nodes(0, i) >= 3.0 ? 1 : 0;
  }
  EXPECT_NEAR(depthOfMarked(under, marked, *sphere), 3.0 - std::sqrt(9.0 - 4.0), 1e-12);
}

TEST(FiniteContact, WhereNothingTouchesThereIsNone)
{
  const VolumeMesh mesh = quadratic(tetrahedra(hexahedronBlock(2, 2, 2, 1.0)));
  ElasticBody body;
  solve(mesh, heldBelow(mesh), body);
  const auto sphere = tool("sphere:6.35");
  const DirectPlace above{ { 1.0, 1.0, 7.0 }, -Eigen::Vector3d::UnitZ() };
  EXPECT_EQ(pressAtFiniteStrain(body, *sphere, above, 0.5).deepest(), 0.0);
  ElasticBody hexahedra;
  const VolumeMesh cubes = hexahedronBlock(2, 2, 2, 1.0);
  solve(cubes, heldBelow(cubes), hexahedra);
  const DirectPlace on{ { 1.0, 1.0, 2.0 }, -Eigen::Vector3d::UnitZ() };
  EXPECT_EQ(pressAtFiniteStrain(hexahedra, *sphere, on, 0.1).deepest(), 0.0);
  EXPECT_GE(pressAtFiniteStrain(body, *sphere, on, 0.1).deepest(), 0.1);
  EXPECT_EQ(pressAtFiniteStrain(body, *tool("flat:0.5"), on, 0.1).deepest(), 0.0);
  EXPECT_EQ(pressAtFiniteStrain(body, *sphere, on, 0.0).deepest(), 0.0);
  EXPECT_TRUE(std::isnan(ContactCurve().evaluate(0.1).force));
  EXPECT_TRUE(isForFiniteStrain(*sphere));
  EXPECT_FALSE(isForFiniteStrain(*tool("flat:1.6")));
}

/// A bar that is held at one end and pressed near the other, against its outer part with the
/// small-strain motion of the cut. Nearly all of the deflection is bending.
TEST(FiniteContact, APartGivesWayAsItDoesInTheWhole)
{
  constexpr double depth = 0.7;
  const std::vector<double> along = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 };
  const std::vector<double> across = { 0, 1, 2, 3 };
  ElasticBody whole;
  const VolumeMesh mesh = quadratic(tetrahedra(gridBlock(along, across, across)));
  solve(mesh, heldTo(mesh, 0.0), whole);
  std::vector<std::int32_t> nodes;
  const VolumeMesh cut = partBeyond(mesh, 4.0, nodes);
  ElasticBody part;
  solve(cut, heldTo(cut, 4.0), part);
  const auto sphere = tool("sphere:6.35");
  // The tool is tilted, so the sideways force also bends the bar sideways.
  const DirectPlace place{ { 9.0, 1.5, 3.0 }, Eigen::Vector3d(0.1, 0.2, -1.0).normalized() };
  const Eigen::Vector3d inside = place.place + 0.3 * place.inward;
  UnitMotion ofCut =
    unitMotion(whole, place.place, { elementAt(mesh, inside), Eigen::Vector3d::Constant(0.25) });
  for (Eigen::Matrix3Xd& moved : ofCut.nodes)
  {
    moved = Eigen::Matrix3Xd(moved(Eigen::all, nodes));
  }
  const UnitMotion rest = motionFromCut(part, ofCut);
  const ContactCurve inWhole = pressAtFiniteStrain(whole, *sphere, place, depth);
  const ContactCurve inPart = pressAtFiniteStrain(part, *sphere, place, depth, &rest);
  const ContactCurve held = pressAtFiniteStrain(part, *sphere, place, depth);
  for (const double deflection : { 0.1, 0.25, 0.5, depth })
  {
    const IndentationPoint expected = inWhole.evaluate(deflection);
    const IndentationPoint found = inPart.evaluate(deflection);
    const double stated = inPart.errorsAt(deflection).strain; // error of 2.5 θ²
    EXPECT_LE(std::abs(found.force / expected.force - 1.0), 0.002 + stated);
    EXPECT_LT(stated, 0.03);
    EXPECT_GT(held.evaluate(deflection).force, 4.0 * expected.force);
  }
}
} // namespace
