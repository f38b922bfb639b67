// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoStep.h"

#include "SampleResponses.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace servo_step
{
using Eigen::Vector3d;
using namespace palpate::testing;
using palpate::Contact;
using palpate::ContactState;
using palpate::DeviceSample;
using palpate::Infinity;
using palpate::NotANumber;
using palpate::ServoStep;
using palpate::Tick;
using palpate::ToolContact;
using palpate::WorkspaceMapping;

namespace
{
DeviceSample sampleAt(const Vector3d& metres)
{
  DeviceSample sample;
  sample.position = metres;
  sample.valid = true;
  return sample;
}

WorkspaceMapping tilted()
{
  return { Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix(),
    Vector3d(5, -3, 2), 2.0 };
}

Surface thinSlab()
{
  return subdivided(block(40, 40, 3), 4);
}
} // namespace

TEST(ServoStep, NumbersOfTheTickAreThoseOfToolContact)
{
  const Surface surface = icosphere(20.0, 3);
  ResponseStore store(surface.points.size());
  store.normalsFromPoints(surface);
  store.randomizeCurves(17);
  const auto body = contactBody(surface, store);
  const WorkspaceMapping mapping = tilted();
  ServoStep step(*body, mapping, 1e6);
  ToolContact contact(*body);
  int touching = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const double t = 1e-3 * i;
    const Vector3d tip = (20.0 - 1.5 * std::sin(20.0 * t)) *
      Vector3d(std::cos(t), std::sin(t) * std::cos(3.0 * t), std::sin(t) * std::sin(3.0 * t));
    const DeviceSample sample = sampleAt(mapping.toDevice(tip));
    const Tick tick = step.step(sample, t);
    EXPECT_EQ(tick.time, t);
    EXPECT_EQ(tick.tip, mapping.toBody(sample.position));
    const Contact expected = contact.update(tick.tip);
    ASSERT_EQ(tick.contact.state, expected.state);
    EXPECT_EQ(tick.contact.force, expected.force);
    EXPECT_EQ(tick.contact.normalForce, expected.normalForce);
    EXPECT_EQ(tick.contact.deflection, expected.deflection);
    EXPECT_EQ(tick.contact.contactPoint, expected.contactPoint);
    EXPECT_EQ(tick.contact.triangle, expected.triangle);
    EXPECT_EQ(tick.deviceForce, mapping.forceToDevice(expected.force));
    touching += expected.normalForce > 0.0;
  }
  EXPECT_GT(touching, 500);
  EXPECT_LT(touching, 1900);
}

TEST(ServoStep, ForceArrivesInTheFrameOfTheDevice)
{
  // The device's x is the body's z. A press on the top of a slab gives a force along x.
  Eigen::Matrix3d rotation;
  rotation << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  const auto body = uniformBody(thinSlab());
  ServoStep step(*body, WorkspaceMapping(rotation, Vector3d::Zero(), 1.0), 100.0);
  // Body (20.3, 18.7, 2.5) mm = device (z, x, y)/1000.
  const Tick tick = step.step(sampleAt(Vector3d(0.0025, 0.0203, 0.0187)), 0.0);
  EXPECT_LE((tick.tip - Vector3d(20.3, 18.7, 2.5)).norm(), 1e-13);
  // 10·0.5^1.5 N, stored in float32.
  EXPECT_LE((tick.deviceForce - Vector3d(10.0 * std::pow(0.5, 1.5), 0, 0)).norm(), 1e-5);
  EXPECT_LE((tick.contact.force - Vector3d(0, 0, tick.deviceForce.x())).norm(), 1e-14);
}

TEST(ServoStep, LimitKeepsTheDirection)
{
  const Surface surface = icosphere(20.0, 2);
  const auto body = uniformBody(surface);
  const WorkspaceMapping mapping = tilted();
  const double limit = 3.0;
  ServoStep step(*body, mapping, limit);
  int limited = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Vector3d tip =
      (20.0 - 0.006 * i) * Vector3d(std::cos(0.01 * i), std::sin(0.01 * i), 0.4).normalized();
    const Tick tick = step.step(sampleAt(mapping.toDevice(tip)), 0.0);
    const double ideal = tick.contact.force.norm();
    const double sent = tick.deviceForce.norm();
    EXPECT_NEAR(sent, std::min(ideal, limit), 1e-14);
    EXPECT_EQ(tick.contact.force.norm(), ideal); // the ideal force is not changed
    const Vector3d ahead = mapping.forceToDevice(tick.contact.force);
    EXPECT_LE((sent * ahead - ideal * tick.deviceForce).norm(), 1e-13 * (1.0 + ideal * sent));
    limited += ideal > limit;
  }
  EXPECT_GT(limited, 100);
  EXPECT_LT(limited, 290);
}

TEST(ServoStep, LimitsThatAreNoneSendNothing)
{
  const auto body = uniformBody(thinSlab());
  const DeviceSample pressed = sampleAt(Vector3d(0.0203, 0.0187, 0.0025));
  for (const double limit : { 0.0, -1.0, NotANumber, -Infinity })
  {
    ServoStep step(*body, WorkspaceMapping(), limit);
    const Tick tick = step.step(pressed, 0.0);
    EXPECT_GT(tick.contact.normalForce, 1.0);
    EXPECT_EQ(tick.deviceForce, Vector3d::Zero()) << limit;
  }
  ServoStep unlimited(*body, WorkspaceMapping(), Infinity);
  const Tick tick = unlimited.step(pressed, 0.0);
  EXPECT_EQ(tick.deviceForce, tick.contact.force);
}

TEST(ServoStep, InvalidSamplesSendNothingAndForget)
{
  const auto body = uniformBody(thinSlab());
  DeviceSample failed = sampleAt(Vector3d(0.0203, 0.0187, 0.0012));
  failed.valid = false;
  for (const DeviceSample& bad : { failed, DeviceSample(), sampleAt(Vector3d(NotANumber, 0, 0)),
         // The last position overflows in mm.
         sampleAt(Vector3d(0, Infinity, 0)), sampleAt(Vector3d(0, 0, 1e306)) })
  {
    ServoStep step(*body, WorkspaceMapping(), 100.0);
    EXPECT_GT(step.step(sampleAt(Vector3d(0.0203, 0.0187, 0.0020)), 0.0).deviceForce.z(), 0.0);
    // Beyond the middle, the contact history keeps it on the top.
    EXPECT_GT(step.step(sampleAt(Vector3d(0.0203, 0.0187, 0.0012)), 0.0).deviceForce.z(), 0.0);
    const Tick tick = step.step(bad, 7.0);
    EXPECT_EQ(tick.time, 7.0);
    EXPECT_EQ(tick.contact.state, ContactState::Invalid);
    EXPECT_EQ(tick.contact.force, Vector3d::Zero());
    EXPECT_EQ(tick.deviceForce, Vector3d::Zero());
    // The contact history is cleared, so the same tip now belongs to the bottom.
    EXPECT_LT(step.step(sampleAt(Vector3d(0.0203, 0.0187, 0.0012)), 0.0).deviceForce.z(), 0.0);
  }
}

TEST(ServoStep, ResetForgetsTheContact)
{
  const auto body = uniformBody(thinSlab());
  ServoStep step(*body, WorkspaceMapping(), 100.0);
  step.step(sampleAt(Vector3d(0.0203, 0.0187, 0.0020)), 0.0);
  EXPECT_GT(step.step(sampleAt(Vector3d(0.0203, 0.0187, 0.0012)), 0.0).deviceForce.z(), 0.0);
  step.reset();
  EXPECT_LT(step.step(sampleAt(Vector3d(0.0203, 0.0187, 0.0012)), 0.0).deviceForce.z(), 0.0);
}

TEST(ServoStep, NoForceWhereContactIsLost)
{
  const auto body = uniformBody(openPlate(10.0, 10));
  ServoStep step(*body, WorkspaceMapping(), 100.0);
  EXPECT_GT(step.step(sampleAt(Vector3d(0.0095, 0.0052, -0.0005)), 0.0).deviceForce.z(), 0.0);
  const Tick lost = step.step(sampleAt(Vector3d(0.0105, 0.0052, -0.0005)), 0.0);
  EXPECT_EQ(lost.contact.state, ContactState::LostAtBorder);
  EXPECT_EQ(lost.deviceForce, Vector3d::Zero());
}

TEST(ServoStep, PaperFormIsPassedOn)
{
  const Surface surface = icosphere(20.0, 1);
  const auto body = uniformBody(surface);
  const Vector3d tip =
    (surface.corner(0, 0) + surface.corner(0, 1) + surface.corner(0, 2)) / 3.0 * 0.97;
  const DeviceSample sample = sampleAt(WorkspaceMapping().toDevice(tip));
  ServoStep paper(*body, WorkspaceMapping(), 100.0, { palpate::ForceForm::Paper });
  ServoStep whole(*body, WorkspaceMapping(), 100.0);
  // Relative error h²/(6R²) for a sphere of 80 facets with h = 0.55 … 0.62 R: 5 % to 6.5 %.
  EXPECT_LT(paper.step(sample, 0.0).contact.normalForce,
    0.97 * whole.step(sample, 0.0).contact.normalForce);
}
} // namespace servo_step
