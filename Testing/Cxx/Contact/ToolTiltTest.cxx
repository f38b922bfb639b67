// SPDX-License-Identifier: BSD-3-Clause
// Tilted tools in the tick: against closed forms on a plate, and against the work along paths on a
// ball. The tables are made from functions, so that the test checks the tick and not a tool.
#include "Contact/ToolContact.h"
#include "SampleResponses.h"
#include "SampleSeries.h"
#include "SampleTilts.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

using namespace palpate::testing;
using palpate::Contact;
using palpate::ContactBody;
using palpate::ContactSettings;
using palpate::ContactState;
using palpate::ContactSurface;
using palpate::ForceForm;
using palpate::ToolContact;
using palpate::ToolPose;
using palpate::Vector3;

namespace
{
constexpr double Radius = 5.0;
constexpr double Largest = 0.6;
constexpr double TiltRange = 2.0;

/// The axis of a tool that is tilted by `angle` in the direction `towards` of the plane, rad.
Vector3 leaning(double angle, double towards)
{
  return { std::sin(angle) * std::cos(towards), std::sin(angle) * std::sin(towards),
    std::cos(angle) };
}

std::unique_ptr<ContactBody> tiltable(const Surface& surface, const ResponseStore& store,
  const TiltStore& tilts, const palpate::PronySeries& series = {}, const float* weight = nullptr)
{
  palpate::ResponseArrays arrays = store.arrays();
  arrays.tilt = tilts.views;
  arrays.tilt.weight = weight;
  arrays.relaxation.series = series;
  arrays.relaxation.exponent = 1.5;
  return contactBody(surface, arrays);
}

/// A plate at z = 0 with F = 10 δ^1.5.
struct Plate
{
  explicit Plate(const TiltStore& tilts, const palpate::PronySeries& series = {})
    : body(tiltable(surface, store, tilts, series))
  {
  }
  Surface surface = openPlate(60.0, 12);
  ResponseStore store{ surface.points.size() };
  std::unique_ptr<ContactBody> body;
};

/// A tip at this depth in the middle of the plate.
Vector3 tipAt(double depth)
{
  return { 31.3, 29.1, -depth };
}

double pressed(double depth)
{
  return depth > 0.0 ? 10.0 * std::pow(depth, 1.5) : 0.0;
}

ContactSettings energyOn(ContactSurface surface)
{
  ContactSettings settings;
  settings.form = ForceForm::EnergyConsistent;
  settings.surface = surface;
  return settings;
}

/// A factor of the work that depends on both depth and tilt.
double leaningFactor(double depth, double angle)
{
  return 1.0 + angle * angle * (0.8 + 0.5 * depth);
}
double softFactor(double depth, double angle)
{
  return 1.0 - angle * angle * (0.4 - 0.1 * depth);
}

/// A ball of 20 mm with smoothly varying curves.
struct Ball
{
  explicit Ball(const TiltStore& tilts, const std::vector<float>& weight = {})
  {
    this->store.normalsFromPoints(this->surface);
    this->store.randomizeCurves(3);
    std::fill(this->store.range.begin(), this->store.range.end(), 2.0F);
    this->body =
      tiltable(this->surface, this->store, tilts, {}, weight.empty() ? nullptr : weight.data());
  }
  Surface surface = icosphere(20.0, 2);
  ResponseStore store{ surface.points.size() };
  std::unique_ptr<ContactBody> body;
};

/// A pose on a closed path over a part of the ball, with the tool tilted in varying directions.
ToolPose poseAt(double turn)
{
  const double polar = 0.5 + 0.2 * std::sin(turn);
  const double around = 0.3 * std::cos(turn) + 0.1 * std::sin(2.0 * turn);
  const Vector3 out = leaning(polar, around);
  const double depth = 0.6 + 0.4 * std::sin(3.0 * turn);
  const Vector3 lean = 0.3 * Vector3(std::cos(2.0 * turn), std::sin(turn), std::sin(3.0 * turn));
  return { (20.0 - depth) * out, out + lean };
}

struct Work
{
  double net = 0.0;
  double taken = 0.0; ///< part of the energy that was put in
};

/// Work of a tool in one turn, by the trapezoidal rule.
Work workAround(const ContactBody& body, const ContactSettings& settings, int steps)
{
  ToolContact contact(body, settings);
  ToolPose before = poseAt(0.0);
  contact.update(before);
  Contact last = contact.update(before); // begins the contact, which is followed from here on
  Work work;
  for (int i = 1; i <= steps; ++i)
  {
    const ToolPose pose = poseAt(2.0 * M_PI * i / steps);
    const Contact now = contact.update(pose);
    const Vector3 turned = before.axis.cross(pose.axis); // rotation of the axis, a small angle
    const double step = -0.5 *
      ((last.force + now.force).dot(pose.tip - before.tip) +
        (last.torque + now.torque).dot(turned));
    work.net += step;
    work.taken += std::max(step, 0.0);
    before = pose;
    last = now;
  }
  return work;
}
} // namespace

TEST(ToolTilt, ASphereThatLeansIsASphereThatIsDeeper)
{
  const TiltStore tilts({ noFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Plate plate(tilts);
  for (const double angle : { 0.05, 0.2, 0.5 })
  {
    for (const double depth : { -0.05, 0.3, 1.0 })
    {
      const Vector3 axis = leaning(angle, 0.7);
      ToolContact contact(*plate.body);
      contact.update(ToolPose(tipAt(depth), axis));
      const Contact felt = contact.update(ToolPose(tipAt(depth), axis));
      const double force = pressed(depth + Radius * (1.0 - std::cos(angle)));
      // The curve is stored as floats, the drop at nodes 2 degrees apart.
      EXPECT_NEAR(felt.normalForce, force, 1e-5 * (1.0 + force)) << angle << ' ' << depth;
      const Vector3 torque = force * Radius * axis.cross(Vector3::UnitZ());
      EXPECT_LT((felt.torque - torque).norm(), 1e-4 * (1.0 + torque.norm())) << angle;
      EXPECT_NEAR(felt.tilt, force > 0.0 ? angle : felt.tilt, 1e-12);
    }
  }
}

TEST(ToolTilt, FoundAtOnceItIsTheSameAsFollowed)
{
  const TiltStore tilts({ leaningFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Plate plate(tilts);
  const ToolPose pose(tipAt(0.4), leaning(0.3, 2.0));
  ToolContact contact(*plate.body);
  const Contact first = contact.update(pose);
  const Contact second = contact.update(pose);
  EXPECT_NEAR(first.normalForce, second.normalForce, 1e-12 * second.normalForce);
  EXPECT_LT((first.torque - second.torque).norm(), 1e-12 * second.torque.norm());
}

TEST(ToolTilt, ForceTorqueAndStiffnessAreThoseOfTheWork)
{
  const TiltStore tilts({ leaningFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Plate plate(tilts);
  const double depth = 0.5;
  const double angle = 0.3;
  const auto work = [](double tip, double tilt)
  {
    const double deep = tip + Radius * (1.0 - std::cos(tilt));
    return 4.0 * std::pow(deep, 2.5) * leaningFactor(deep, tilt);
  };
  const double h = 1e-4;
  ToolContact contact(*plate.body);
  const Vector3 axis = leaning(angle, 0.0);
  contact.update(ToolPose(tipAt(depth), axis));
  const Contact felt = contact.update(ToolPose(tipAt(depth), axis));
  const double force = (work(depth + h, angle) - work(depth - h, angle)) / (2.0 * h);
  const double stiffness =
    (work(depth + h, angle) - 2.0 * work(depth, angle) + work(depth - h, angle)) / (h * h);
  const double moment = (work(depth, angle + h) - work(depth, angle - h)) / (2.0 * h);
  // Curves are floats in 8 samples, and the table has 17 by 17 nodes of a polynomial in x² and y².
  EXPECT_NEAR(felt.normalForce, force, 1e-5 * force);
  EXPECT_NEAR(felt.stiffness, stiffness, 1e-3 * stiffness);
  EXPECT_NEAR(felt.torque.dot(axis.cross(Vector3::UnitZ()).normalized()), moment, 1e-4 * moment);
}

TEST(ToolTilt, WithoutAnAxisEveryBitIsAsBefore)
{
  const TiltStore tilts({ leaningFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Ball with(tilts);
  const auto without = contactBody(with.surface, with.store);
  for (const ContactSettings& settings : allFormsAndSurfaces())
  {
    ToolContact tilted(*with.body, settings);
    ToolContact plain(*without, settings);
    for (int i = 0; i < 100; ++i)
    {
      const Vector3 tip = poseAt(0.05 * i).tip;
      const Contact a = tilted.update(tip);
      const Contact b = plain.update(ToolPose(tip, leaning(0.3, 1.0))); // a body without tilts
      ASSERT_EQ(a.force, b.force) << i;
      ASSERT_EQ(a.torque, Vector3::Zero());
      ASSERT_EQ(b.torque, Vector3::Zero());
      ASSERT_EQ(a.state, b.state);
    }
  }
}

TEST(ToolTilt, UprightItIsTheForceWithoutAnAxis)
{
  const TiltStore tilts({ leaningFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Plate plate(tilts);
  ToolContact tilted(*plate.body);
  ToolContact plain(*plate.body);
  for (const double depth : { 0.01, 0.5, 1.5, 2.5 })
  {
    tilted.update(ToolPose(tipAt(depth), Vector3::UnitZ()));
    const Contact a = tilted.update(ToolPose(tipAt(depth), Vector3::UnitZ()));
    const Contact b = plain.update(tipAt(depth));
    EXPECT_NEAR(a.normalForce, b.normalForce, 1e-12 * b.normalForce);
    EXPECT_EQ(a.torque, Vector3::Zero());
    EXPECT_EQ(a.state, b.state) << depth;
  }
}

TEST(ToolTilt, FurtherThanTheTableItIsFeltAsThereAndSaysSo)
{
  const TiltStore tilts({ leaningFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Plate plate(tilts);
  const auto at = [&plate](double angle)
  {
    ToolContact contact(*plate.body);
    contact.update(ToolPose(tipAt(0.5), leaning(angle, 0.0)));
    return contact.update(ToolPose(tipAt(0.5), leaning(angle, 0.0)));
  };
  const Contact last = at(Largest - 1e-9);
  EXPECT_EQ(last.state, ContactState::Slide);
  for (const double angle : { Largest + 0.01, 1.5 })
  {
    const Contact beyond = at(angle);
    EXPECT_EQ(beyond.state, ContactState::TiltedTooFar) << angle;
    EXPECT_NEAR(beyond.normalForce, last.normalForce, 1e-6 * last.normalForce) << angle;
    EXPECT_EQ(beyond.torque, Vector3::Zero()) << angle;
  }
}

TEST(ToolTilt, NothingIsGainedOnAClosedPath)
{
  const TiltStore tilts({ leaningFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Ball ball(tilts);
  const ContactSettings settings = energyOn(ContactSurface::Smooth);
  const Work coarse = workAround(*ball.body, settings, 4000);
  const Work fine = workAround(*ball.body, settings, 8000);
  ASSERT_GT(fine.taken, 1.0);
  // The followed point is determined with the normal of the last tick. The error of this delay and
  // that of the trapezoidal rule fall with the step (7e-5 and 4e-5 here). The difference between
  // the patch's normal and the blended normal, from which the tilt is measured, has a smaller
  // effect.
  EXPECT_LT(std::abs(fine.net), 2e-4 * fine.taken) << coarse.net;
}

TEST(ToolTilt, NeitherAreUnlikeLawsOfItsPoints)
{
  const TiltStore tilts({ leaningFactor, softFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Surface surface = icosphere(20.0, 2);
  std::vector<float> weight;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const float first = static_cast<float>(0.5 + 0.5 * std::sin(static_cast<double>(p)));
    weight.push_back(first);
    weight.push_back(1.0F - first);
  }
  const Ball ball(tilts, weight);
  const Work work = workAround(*ball.body, energyOn(ContactSurface::Smooth), 8000);
  EXPECT_LT(std::abs(work.net), 2e-4 * work.taken);
}

TEST(ToolTilt, ABodyThatRelaxesRestsAtTheTiltedForce)
{
  const TiltStore tilts({ leaningFactor }, dropOfSphere(Radius), TiltRange, Largest);
  const Plate elastic(tilts);
  const Plate relaxing(tilts, relaxation({ { 0.5, 0.1 } }));
  const ToolPose pose(tipAt(0.5), leaning(0.3, 1.0));
  ToolContact plain(*elastic.body);
  plain.update(pose);
  const Contact slow = plain.update(pose);
  ToolContact contact(*relaxing.body);
  contact.update(ToolPose(tipAt(-3.0), pose.axis), 0.001);
  contact.update(pose, 1e-6);
  Contact felt = contact.update(pose, 1e-6);
  // In a fast press force and torque are 1 + p times as large.
  EXPECT_NEAR(felt.normalForce, 1.5 * slow.normalForce, 1e-3 * slow.normalForce);
  EXPECT_NEAR(felt.torque.norm(), 1.5 * slow.torque.norm(), 1e-2 * slow.torque.norm());
  felt = contact.update(pose, 10.0);
  EXPECT_NEAR(felt.normalForce, slow.normalForce, 1e-6 * slow.normalForce);
  EXPECT_LT((felt.torque - slow.torque).norm(), 1e-6 * slow.torque.norm());
}
