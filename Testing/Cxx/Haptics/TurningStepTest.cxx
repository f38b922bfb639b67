// SPDX-License-Identifier: BSD-3-Clause
// The step with a device that reports the orientation of its tool: the contact gets the axis. With
// a device that does not report an orientation, the ticks are as before.
#include "Haptics/Devices/TrajectoryFile.h"
#include "Haptics/Devices/ReplayDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include "SampleResponses.h"
#include "ScratchFile.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace turning_step
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using namespace palpate;
using palpate::NotANumber;
using namespace palpate::testing;

namespace
{
struct Plate
{
  Surface surface = block(40, 40, 10);
  ResponseStore store{ surface.points.size() };
  std::shared_ptr<const ContactBody> body;
  Plate()
  {
    this->store.normalsFromPoints(this->surface);
    this->store.randomizeCurves(3);
    this->body = contactBody(this->surface, this->store);
  }
};

DeviceSample sampleAt(double z, const ToolOrientation& orientation = orientationNotTold())
{
  DeviceSample sample;
  sample.position = Vector3d(0.02, 0.02, 1e-3 * z);
  sample.orientation = orientation;
  sample.valid = true;
  return sample;
}
} // namespace

TEST(TurningStep, OnePowerOnBothSides)
{
  // The power F · v + M · ω at the device, in W, equals that in the body, in N mm/s, divided by
  // 1000 scale. This is also true for a device with left-handed axes, for which turns change their
  // sign.
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  const auto any = [&]
  {
    const double x = gauss(random);
    const double y = gauss(random);
    return Vector3d(x, y, gauss(random));
  };
  for (int i = 0; i < 200; ++i)
  {
    Matrix3d axes = Eigen::AngleAxisd(gauss(random), any().normalized()).toRotationMatrix();
    const double hand = i % 2 == 0 ? 1.0 : -1.0;
    axes.col(2) *= hand;
    const double scale = std::exp(gauss(random));
    const WorkspaceMapping mapping(axes, any(), scale);
    const Vector3d force = any();
    const Vector3d torque = any();
    const Vector3d velocity = any();
    // The turn in the body by its definition: the change, in the body's frame, of an axis that the
    // device turns.
    const Vector3d turn = 1e-6 * any();
    const Vector3d axis = any().normalized();
    const Vector3d change = mapping.axisToBody(axis + turn.cross(axis)) - mapping.axisToBody(axis);
    const Vector3d bodyTurn = hand * (axes * turn);
    EXPECT_LE((bodyTurn.cross(mapping.axisToBody(axis)) - change).norm(), 1e-15);
    const double body = force.dot(mapping.velocityToBody(velocity)) + torque.dot(bodyTurn);
    const double device =
      mapping.forceToDevice(force).dot(velocity) + mapping.torqueToDevice(torque).dot(turn);
    EXPECT_NEAR(device, body / (1000.0 * scale), 1e-13 * (1.0 + std::abs(device)));
    EXPECT_LE((mapping.torqueToBody(mapping.torqueToDevice(torque)) - torque).norm(), 1e-14);
    EXPECT_LE((mapping.axisToDevice(mapping.axisToBody(axis)) - axis).norm(), 1e-15);
  }
  const WorkspaceMapping flat = WorkspaceMapping().planar();
  EXPECT_EQ(flat.torqueToDevice(Vector3d(1.0, 2.0, 500.0)), Vector3d(0.0, 0.0, 0.5));
}

TEST(TurningStep, TheContactIsGivenThePose)
{
  const Plate plate;
  Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const WorkspaceMapping mapping(quarter, Vector3d(40.0, 0.0, 0.0), 1.0);
  ServoStep step(*plate.body, mapping, 1e6);
  ToolContact contact(*plate.body);
  const double angle = 0.2;
  for (int i = 0; i < 200; ++i)
  {
    const double z = 10.5 - 0.01 * i;
    const Tick tick = step.step(sampleAt(z, turnedBy(Vector3d(angle, 0.0, 0.0))), 1e-3 * i);
    // The turn is about the device's x, which is the body's y. The shaft tilts to the device's -y,
    // which is the body's x.
    const Vector3d axis(std::sin(angle), 0.0, std::cos(angle));
    ASSERT_TRUE(tick.valid);
    EXPECT_LE((tick.axis - axis).norm(), 1e-15);
    const Contact expected = contact.update(ToolPose(tick.tip, tick.axis));
    EXPECT_EQ(tick.contact.force, expected.force);
    EXPECT_EQ(tick.contact.torque, expected.torque);
    EXPECT_EQ(tick.contact.tilt, expected.tilt);
    EXPECT_EQ(tick.idealTorque, expected.torque);
    EXPECT_EQ(tick.deviceTorque, Vector3d::Zero()); // the chain allows no torque
  }
}

TEST(TurningStep, NoOrientationIsTheTickOfBeforeAndNonsenseIsNoSample)
{
  const Plate plate;
  SafetySettings settings;
  settings.maximumTorque = 0.1;
  const auto scene = [&] { return std::make_unique<ServoScene>(plate.body); };
  ServoStep plain(scene(), WorkspaceMapping(), SafetySettings());
  ServoStep turning(scene(), WorkspaceMapping(), settings);
  for (int i = 0; i < 600; ++i)
  {
    const double z = 10.3 - 0.5 * std::abs(std::sin(0.01 * i));
    const Tick a = plain.step(sampleAt(z), 1e-3 * i);
    const Tick b = turning.step(sampleAt(z), 1e-3 * i);
    ASSERT_EQ(a.deviceForce, b.deviceForce);
    ASSERT_EQ(a.acted, b.acted);
    ASSERT_FALSE(b.hasAxis());
    ASSERT_EQ(b.deviceTorque, Vector3d::Zero());
  }
  const Tick lost = turning.step(sampleAt(9.9, ToolOrientation(1.0, NotANumber, 0.0, 0.0)), 0.6);
  EXPECT_FALSE(lost.valid);
  EXPECT_EQ(lost.deviceForce, Vector3d::Zero());
  EXPECT_EQ(lost.axis, Vector3d::Zero());
}

TEST(TurningStep, AFileKeepsAxisAndTorqueAndPlaysThem)
{
  std::mt19937 random(9);
  std::normal_distribution<double> gauss;
  std::vector<Tick> ticks;
  for (int i = 0; i < 50; ++i)
  {
    Tick tick;
    tick.time = 1e-3 * i;
    tick.tip = Vector3d(gauss(random), gauss(random), gauss(random));
    tick.contact.state = i % 7 == 0 ? ContactState::TiltedTooFar : ContactState::Slide;
    tick.axis = i % 11 == 0 ? Vector3d(Vector3d::Zero())
                            : Vector3d(gauss(random), gauss(random), gauss(random)).normalized();
    tick.contact.torque = Vector3d(gauss(random), gauss(random), gauss(random));
    ticks.push_back(tick);
  }
  const ScratchFile file(".csv");
  ASSERT_EQ(writeTrajectory(file.path(), ticks), "");
  Trajectory read;
  ASSERT_EQ(readTrajectory(file.path(), read), "");
  ASSERT_TRUE(read.hasAxis && read.hasTorque && !read.hasMemory && !read.hasDevice);
  const Matrix3d axes = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const WorkspaceMapping mapping(axes, Vector3d(5, -3, 2), 2.0);
  ReplayDevice replay(read, mapping);
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    EXPECT_EQ(read.rows[i].axis, ticks[i].axis); // the same bits
    EXPECT_EQ(read.rows[i].contact.torque, ticks[i].contact.torque);
    EXPECT_EQ(read.rows[i].contact.state, ticks[i].contact.state);
    const DeviceSample played = replay.read(ticks[i].time);
    EXPECT_EQ(isTold(played.orientation), !ticks[i].axis.isZero(0.0));
    EXPECT_LE((mapping.axisToBody(shaftOf(played.orientation)) - ticks[i].axis).norm(), 1e-14);
  }
  // Halfway between two ticks the shaft is halfway between the shafts of both ticks.
  const Vector3d half = mapping.axisToBody(shaftOf(replay.read(1.5e-3).orientation));
  EXPECT_LE((half - (ticks[1].axis + ticks[2].axis).normalized()).norm(), 1e-12);

  for (Tick& tick : ticks) // without an orientation, the file is as before
  {
    tick.axis.setZero();
    tick.contact.torque.setZero();
  }
  ASSERT_EQ(writeTrajectory(file.path(), ticks), "");
  std::ifstream stream(file.path());
  std::string names;
  std::getline(stream, names);
  EXPECT_EQ(names,
    "time_s,tip_x_mm,tip_y_mm,tip_z_mm,contact_x_mm,contact_y_mm,contact_z_mm,deflection_mm,"
    "normal_force_N,friction_x_N,friction_y_N,friction_z_N,ideal_force_N,state");
}

TEST(TurningStep, AxesInFilesThatAreNone)
{
  const auto faultOf = [](const std::string& text)
  {
    std::istringstream stream(text);
    Trajectory trajectory;
    return readTrajectory(stream, "t.csv", trajectory);
  };
  const std::string names = "time_s,tip_x_mm,tip_y_mm,tip_z_mm,";
  EXPECT_EQ(faultOf(names + "axis_x,axis_y,axis_z\n0,1,2,3,0.6,0,0.8\n1,1,2,3,0,0,0\n"), "");
  EXPECT_EQ(faultOf(names + "axis_x,axis_y,axis_z\n0,1,2,3,0,0,1\n1,1,2,3,0,0,0.9\n"),
    "t.csv:3: axis_x, axis_y, axis_z must have the length 1, or be zero");
  EXPECT_NE(
    faultOf(names + "axis_x,axis_z\n0,1,2,3,0,1\n").find("'axis_y' is missing"), std::string::npos);
  EXPECT_NE(faultOf(names + "axis_x,axis_y,axis_z\n0,1,2,3,0,nan,1\n"), "");
}
} // namespace turning_step
