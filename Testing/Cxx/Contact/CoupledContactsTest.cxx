// SPDX-License-Identifier: BSD-3-Clause
// Cases that coupling must not change: one contact, contacts far apart, bodies without coupling.
// Also the coupling of two places.
#include "Contact/Coupled/CoupledContacts.h"

#include "CoupledPlate.h"
#include "SampleSeries.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <random>
#include <vector>

using namespace palpate;
using palpate::NotANumber;
using namespace palpate::testing;

namespace
{
/// A path in and out of the plate, beyond its border and its range, with some positions that are
/// not valid.
Vector3 pathOf(int tick, double phase)
{
  const double t = 1e-2 * tick + phase;
  return { 30.0 + 33.0 * std::sin(1.3 * t), 30.0 + 31.0 * std::cos(0.7 * t),
    tick % 97 == 3 ? NotANumber : 0.5 - 2.0 * std::abs(std::sin(3.0 * t)) };
}

void expectSame(const Contact& one, const Contact& other, int tick)
{
  EXPECT_EQ(one.state, other.state) << tick;
  EXPECT_EQ(one.triangle, other.triangle) << tick;
  for (const auto& [a, b] :
    { std::pair(one.force, other.force), std::pair(one.friction, other.friction),
      std::pair(one.normal, other.normal), std::pair(one.contactPoint, other.contactPoint) })
  {
    EXPECT_EQ(std::memcmp(a.data(), b.data(), 3 * sizeof(double)), 0) << tick;
  }
  EXPECT_EQ(one.normalForce, other.normalForce) << tick;
  EXPECT_EQ(one.stiffness, other.stiffness) << tick;
  EXPECT_EQ(one.deflection, other.deflection) << tick;
  EXPECT_EQ(one.memory, other.memory) << tick;
}

std::vector<ContactSettings> settingsWithFriction()
{
  std::vector<ContactSettings> all = allFormsAndSurfaces();
  all.push_back({});
  all.back().friction.coefficient = 0.4;
  return all;
}
} // namespace

TEST(CoupledContacts, OneIsAToolContactToTheBit)
{
  const auto body = CoupledPlate().body();
  for (const ContactSettings& settings : settingsWithFriction())
  {
    CoupledContacts one(*body, settings, 1);
    ToolContact alone(*body, settings);
    int forces = 0;
    for (int tick = 0; tick < 600; ++tick)
    {
      const ToolPose pose(pathOf(tick, 0.0));
      const Contact& felt = one.update(&pose, 1e-3)[0];
      expectSame(felt, alone.update(pose, 1e-3), tick);
      forces += felt.normalForce > 0.0;
    }
    EXPECT_GT(forces, 100);
    EXPECT_EQ(one.stiffening(), 1.0);
  }
}

// In a servo loop a contact without a pose does not end; only time passes for it.
TEST(CoupledContacts, AStepIsAToolContactAndKeepsItWithoutAPose)
{
  CoupledPlate plate;
  plate.relaxation.series = relaxation({ { 1.0, 0.02 } });
  plate.relaxation.exponent = 1.5;
  for (const std::size_t count : { 1U, 2U })
  {
    const auto body = plate.body(count == 1);
    for (const ContactSettings& settings : settingsWithFriction())
    {
      CoupledContacts contacts(*body, settings, count);
      CoupledContacts copies(*body, settings, count);
      std::vector<ToolContact> alone(count, ToolContact(*body, settings));
      std::vector<std::optional<ToolPose>> poses(count);
      int back = 0;
      for (int tick = 0; tick < 600; ++tick)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          poses[i].reset();
          if (tick % 11 != static_cast<int>(i))
          {
            poses[i].emplace(pathOf(tick, static_cast<double>(i)));
          }
        }
        copies.assume(contacts);
        const auto& copied = copies.step(poses.data(), 1e-3);
        const auto& felt = contacts.step(poses.data(), 1e-3);
        for (std::size_t i = 0; i < count; ++i)
        {
          expectSame(copied[i], felt[i], tick);
          if (poses[i])
          {
            expectSame(felt[i], alone[i].update(*poses[i], 1e-3), tick);
            back += tick % 11 == static_cast<int>(i) + 1 && felt[i].friction.norm() > 0.0;
          }
          else
          {
            alone[i].pass(1e-3);
            EXPECT_EQ(felt[i].state, ContactState::Invalid);
            EXPECT_EQ(felt[i].force, Vector3::Zero());
          }
        }
      }
      // A contact that had begun again would have no friction in its first tick.
      EXPECT_TRUE(back > 10 || settings.friction.coefficient == 0.0);
    }
  }
}

TEST(CoupledContacts, WithoutCouplingAreToolContactsToTheBit)
{
  const auto body = CoupledPlate().body(false);
  EXPECT_EQ(body->coupling, nullptr);
  for (const ContactSettings& settings : settingsWithFriction())
  {
    CoupledContacts three(*body, settings, 3);
    std::vector<ToolContact> alone(3, ToolContact(*body, settings));
    for (int tick = 0; tick < 300; ++tick)
    {
      std::vector<ToolPose> poses;
      for (std::size_t i = 0; i < 3; ++i)
      {
        poses.emplace_back(pathOf(tick, static_cast<double>(i)));
      }
      const auto& felt = three.update(poses.data());
      for (std::size_t i = 0; i < 3; ++i)
      {
        expectSame(felt[i], alone[i].update(poses[i]), tick);
      }
    }
  }
}

TEST(CoupledContacts, FarApartHardlyFeelEachOther)
{
  const CoupledPlate plate;
  const auto body = plate.body();
  CoupledContacts two(*body, {}, 2);
  const auto poses = posesOf({ { 3.1, 4.0, 0.2 }, { 56.0, 57.0, 0.2 } });
  const double alone = ToolContact(*body).update(poses[0]).normalForce;
  const double coupled = two.settle(poses.data())[0].normalForce;
  // 1.5 C F/δ to first order, with Boussinesq's C at 74.6 mm. The next order is the square of this
  // change.
  const double change =
    1.5 * alone / 0.2 / (3.14159265 * plate.terms.modulus * std::hypot(52.9, 53.0));
  EXPECT_NEAR(1.0 - coupled / alone, change, 2.0 * change * change);
  EXPECT_LT(change, 0.01);
}

// A tool that leaves the surface or has an invalid position has no load.
TEST(CoupledContacts, WhoIsNotThereIsNotFelt)
{
  const auto body = CoupledPlate().body();
  const double alone = ToolContact(*body).update(Vector3(29.1, 29.7, -0.5)).normalForce;
  for (const Vector3& second : { Vector3(33.0, 29.0, 1.0), Vector3(33.0, NotANumber, -0.5) })
  {
    CoupledContacts two(*body, {}, 2);
    const auto near = posesOf({ { 29.1, 29.7, 0.5 }, { 33.0, 29.0, 0.5 } });
    EXPECT_LT(two.update(near.data())[0].normalForce, 0.95 * alone);
    const ToolPose poses[] = { near[0], ToolPose(second) };
    EXPECT_EQ(two.update(poses)[0].normalForce, alone);
    EXPECT_LT(two.update(near.data())[0].normalForce, alone);
    two.lose(1);
    EXPECT_EQ(two.sunk(1), 0.0);
  }
}

// With relaxation each tool has the force of a single tool at a depth that is reduced by the
// lowering of the surface under the slow forces of the others. A tool that leaves faster than the
// body recovers has no effect on the others.
TEST(CoupledContacts, OfABodyThatRelaxesFeelItInTime)
{
  CoupledPlate plate;
  const auto slowBody = plate.body();
  plate.relaxation.series = relaxation({ { 1.0, 0.05 }, { 0.5, 0.4 } });
  plate.relaxation.exponent = 1.5;
  const auto body = plate.body();
  CoupledContacts two(*body, {}, 2);
  CoupledContacts slow(*slowBody, {}, 2);
  ToolContact alone[] = { ToolContact(*body), ToolContact(*body) };
  int pressed = 0;
  int letAlone = 0;
  for (int tick = 0; tick < 400; ++tick)
  {
    const double t = 5e-3 * tick;
    const double first = 0.4 + 0.3 * std::sin(5.0 * t);
    // The second tool leaves quickly after a second, then enters again.
    const double second = tick >= 200 && tick < 240 ? 0.5 - 0.4 * (tick - 199) / 40.0 : 0.5;
    const auto poses = posesOf({ { 25.1, 29.3, first }, { 31.2, 29.3, second } });
    const auto& felt = two.settle(poses.data(), 5e-3);
    slow.settle(poses.data());
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Vector3 raised = poses[i].tip + Vector3(0.0, 0.0, two.sunk(i));
      const Contact expected = alone[i].update(raised, 5e-3);
      // tolerance for rounding
      EXPECT_NEAR(felt[i].normalForce, expected.normalForce, 1e-9) << tick;
    }
    if (felt[0].normalForce > 0.0 && felt[1].normalForce > 0.0 && tick < 200)
    {
      EXPECT_NEAR(two.sunk(0), slow.sunk(0), 1e-9) << tick;
      ++pressed;
    }
    if (tick > 201 && !(felt[1].normalForce > 0.0))
    {
      letAlone += two.sunk(0) == 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(pressed, 100);
  EXPECT_GT(letAlone, 10);
}

TEST(CoupledContacts, BeyondABorderFadeForTheOthersToo)
{
  const auto body = CoupledPlate().body();
  double before = -1.0;
  for (int i = 0; i <= 400; ++i)
  {
    CoupledContacts two(*body, {}, 2);
    const double x = 59.5 + 0.005 * i;
    const auto& felt = two.settle(posesOf({ { 55.0, 29.7, 0.5 }, { x, 29.7, 0.5 } }).data());
    // The force on the first tool does not jump where the second one passes the border, at 60 mm,
    // or where its force ends, at 60.5 mm.
    EXPECT_TRUE(before < 0.0 || std::abs(felt[0].normalForce - before) < 0.02) << x;
    before = felt[0].normalForce;
  }
  EXPECT_EQ(before, ToolContact(*body).update(Vector3(55.0, 29.7, -0.5)).normalForce);
}

TEST(BodyCoupling, IsSymmetricAndKnowsItsGradients)
{
  // A ball with another material and thickness at each point and three modes.
  const Surface ball = icosphere(20.0, 2);
  ResponseStore store(ball.points.size());
  store.normalsFromPoints(ball);
  const CouplingLaw law(LayerKernel(0.45, LayerBase::Bonded));
  std::mt19937 random(3);
  std::uniform_real_distribution<float> share(0.5F, 1.5F);
  std::vector<float> modulus(ball.points.size());
  std::vector<float> thickness(ball.points.size());
  std::vector<float> modes(3 * ball.points.size());
  for (std::vector<float>* values : { &modulus, &thickness, &modes })
  {
    for (float& value : *values)
    {
      value = share(random) * (values == &thickness ? 10.0F : 1.0F);
    }
  }
  ResponseArrays arrays = store.arrays();
  arrays.coupling.modulus = 1.0;
  arrays.coupling.thickness = 10.0;
  arrays.coupling.knots = law.knots().data();
  arrays.coupling.localModulus = modulus.data();
  arrays.coupling.localThickness = thickness.data();
  arrays.coupling.modes = modes.data();
  arrays.coupling.modeCount = 3;
  EXPECT_EQ(faultOfCoupling(arrays.coupling, ball.points.size()), "");
  const auto made = contactBody(ball, arrays);
  const ContactBody& body = *made;
  const BodyCoupling& coupling = *body.coupling;
  int facing = 0;
  const auto count = static_cast<std::int32_t>(body.surface.triangleCount());
  for (std::int32_t one = 0; one < count; one += 7)
  {
    const std::int32_t other = (one * 31 + 11) % count;
    const Vector3 weights(0.2, 0.5, 0.3);
    const auto spot = coupling.at(one, weights, 0.1);
    const auto away = coupling.at(other, { 0.6, 0.3, 0.1 }, 0.1);
    EXPECT_EQ(coupling.compliance(spot, away), coupling.compliance(away, spot));
    if (one == other || spot.normal.dot(away.normal) < 0.05)
    {
      continue;
    }
    ++facing;
    const Vector3 gradient = coupling.gradient(spot, one, away);
    for (int k = 0; k < 2; ++k)
    {
      Vector3 step = Vector3::Zero();
      step[k] = 1e-5;
      step[2] = -1e-5;
      const double difference = coupling.compliance(coupling.at(one, weights + step, 0.1), away) -
        coupling.compliance(coupling.at(one, weights - step, 0.1), away);
      // Rounding, divided by twice the step. The contact radius does not depend on the place.
      EXPECT_NEAR(gradient[k] - gradient[2], difference / 2e-5, 1e-8) << one << " " << other;
    }
  }
  EXPECT_GT(facing, 10);
}

TEST(BodyCoupling, OfOppositeSidesIsThatOfTheModes)
{
  const Surface slab = block(20.0, 20.0, 2.0);
  ResponseStore store(slab.points.size());
  takeMeshNormals(store, slab);
  std::vector<float> modes(slab.points.size());
  for (std::size_t i = 0; i < modes.size(); ++i)
  {
    modes[i] = slab.points[i].z() > 1.0 ? 0.5F : -0.5F; // along z, on both sides
  }
  ResponseArrays arrays = store.arrays();
  arrays.coupling.modulus = 1.0;
  arrays.coupling.modes = modes.data();
  arrays.coupling.modeCount = 1;
  const auto made = contactBody(slab, arrays);
  const ContactBody& body = *made;
  const auto under = [&body](const Vector3& tip)
  {
    const auto near = body.tree.closest(tip);
    return body.coupling->at(near.triangle, near.projection.weights, 1.0);
  };
  const auto above = under({ 9.0, 10.0, 1.9 });
  const auto below = under({ 9.0, 10.0, 0.1 });
  const auto beside = under({ 15.0, 10.0, 1.9 });
  EXPECT_DOUBLE_EQ(body.coupling->compliance(above, below), -0.25);
  EXPECT_NEAR(body.coupling->compliance(above, beside),
    // 1e-6: stored as floats
    0.25 + above.normal.dot(beside.normal) / (3.14159265358979 * 6.0), 1e-6);
}

TEST(BodyCoupling, NamesWhatIsWrong)
{
  const auto says = [](const CouplingTerms& terms, const char* part)
  {
    const std::string fault = faultOfCoupling(terms, 3);
    EXPECT_NE(fault.find(part), std::string::npos) << fault;
  };
  const std::vector<float> wrong = { 1.0F, -2.0F, 1.0F };
  const std::vector<float> notFinite = { 0.0F, 1.0F, std::numeric_limits<float>::infinity() };
  std::vector<CouplingKnot> knots(CouplingLaw::KnotCount);
  CouplingTerms terms;
  EXPECT_EQ(faultOfCoupling(terms, 3), "");
  terms.modulus = -1.0;
  says(terms, "modulus must be finite and not negative (MPa), but is -1");
  terms.modulus = NotANumber;
  says(terms, "but is nan");
  terms.modulus = 1.0;
  terms.thickness = 2.0;
  says(terms, "79 knots of a layer, and 0 without them, but is 2");
  terms.knots = knots.data();
  EXPECT_EQ(faultOfCoupling(terms, 3), "");
  knots[5].slope = NotANumber;
  says(terms, "knot 5 must be finite");
  knots[5].slope = 0.0;
  knots[7].ratio = -0.5;
  says(terms, "knot 7");
  knots[7].ratio = 0.0;
  terms.localModulus = wrong.data();
  says(terms, "modulus (MPa) of point 1 must be finite and above 0, but is -2");
  terms.localModulus = nullptr;
  terms.localThickness = wrong.data();
  says(terms, "thickness (mm) of point 1");
  terms.localThickness = nullptr;
  terms.modes = notFinite.data();
  terms.modeCount = 1;
  says(terms, "mode 0 of point 2 must be finite, but is inf");
  terms.modeCount = 17;
  says(terms, "0 to 16, but is 17");
}

// Two fingers pinch a slender body. One finger alone bends the body, which is 24 times as soft as
// its dent. Two fingers only dent the body. A Gauss-Seidel round reduces the residual to 0.92.
TEST(CoupledContacts, APinchOfASlenderBodyIsFoundAtOnceAndFollowed)
{
  CoupledPlate plate(true); // F = 4 δ: 1/4 = 1/k + C
  constexpr double bending = 0.24;
  constexpr double dent = 100.0; // stiffness k of the dent, N/mm
  std::vector<float> modes;
  for (const Vector3& point : plate.surface.points)
  {
    modes.push_back(static_cast<float>(std::sqrt(bending) * (point.x() < 30.0 ? 1.0 : -1.0)));
  }
  plate.terms.modulus = 0.0;
  plate.terms.modes = modes.data();
  plate.terms.modeCount = 1;
  const auto body = plate.body();
  const auto poses = posesOf({ { 7.3, 31.1, 0.05 }, { 52.1, 29.3, 0.05 } });
  CoupledContacts settled(*body, {}, 2);
  for (const Contact& felt : settled.settle(poses.data()))
  {
    // Modes are stored as floats: 6e-8 of 0.24 in 0.01.
    EXPECT_NEAR(felt.normalForce, 0.05 * dent, 1e-5 * 0.05 * dent);
  }
  // A tick starts without an estimate of the forces and converges in one step.
  CoupledContacts ticked(*body, {}, 2);
  EXPECT_NEAR(ticked.update(poses.data())[1].normalForce, 0.05 * dent, 1e-5 * 0.05 * dent);
  // One finger alone bends the body.
  const auto alone = posesOf({ { 7.3, 31.1, 0.05 }, { 52.1, 29.3, -1.0 } });
  EXPECT_NEAR(settled.settle(alone.data())[0].normalForce, 4.0 * 0.05, 1e-6);
}
