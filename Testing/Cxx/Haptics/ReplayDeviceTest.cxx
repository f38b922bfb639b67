// SPDX-License-Identifier: BSD-3-Clause
// A recording that is written and read replays the same bits. The file of a session gives the same
// ticks again.
#include "Haptics/Devices/ReplayDevice.h"

#include "FaultyDevice.h"
#include "RecordingDevice.h"
#include "SampleResponses.h"
#include "ScratchFile.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Haptics/Devices/TrajectoryFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace replay_device
{
using Eigen::Vector3d;
using namespace palpate::testing;
using palpate::DeviceFault;
using palpate::DeviceFaults;
using palpate::DeviceSample;
using palpate::FaultyDevice;
using palpate::HapticDevice;
using palpate::RecordedSample;
using palpate::RecordingDevice;
using palpate::ReplayDevice;
using palpate::ServoStep;
using palpate::SimulatedDevice;
using palpate::Tick;
using palpate::Trajectory;
using palpate::TrajectoryRow;
using palpate::WorkspaceMapping;

namespace
{
constexpr double Period = 1e-3;

bool same(const Vector3d& a, const Vector3d& b)
{
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

/// Makes a compliant hand that presses on a plate of 10 mm and moves around.
std::unique_ptr<HapticDevice> handOnPlate(const WorkspaceMapping& mapping = WorkspaceMapping())
{
  palpate::SimulatedPlant plant;
  plant.friction = 0.05;
  plant.sampleDelay = 0.4e-3;
  return std::make_unique<SimulatedDevice>(plant, palpate::HandModel(),
    std::vector<SimulatedDevice::WayPoint>{ { 0.0, mapping.toDevice({ 5.0, 5.0, 2.0 }) },
      { 0.3, mapping.toDevice({ 4.0, 6.1, -1.1 }) }, { 0.7, mapping.toDevice({ 7.0, 3.0, -0.7 }) },
      { 1.0, mapping.toDevice({ 7.0, 4.0, 2.0 }) } });
}

/// Runs a servo step on a device. Returns the ticks.
std::vector<Tick> run(
  HapticDevice& device, const palpate::ContactBody& body, const WorkspaceMapping& mapping)
{
  ServoStep step(body, mapping, 5.0);
  std::vector<Tick> ticks;
  for (int tick = 0; tick < 1000; ++tick)
  {
    const double time = tick * Period;
    ticks.push_back(step.step(device.read(time), time));
    device.write(ticks.back().deviceForce);
  }
  return ticks;
}

Trajectory reread(const Trajectory& trajectory)
{
  const ScratchFile file(".csv");
  EXPECT_EQ(palpate::writeTrajectory(file.path(), trajectory), "");
  Trajectory read;
  EXPECT_EQ(palpate::readTrajectory(file.path(), read), "");
  return read;
}

/// A mapping with rotation, translation and magnification.
WorkspaceMapping oblique()
{
  const Eigen::Matrix3d turn =
    (Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()) * Eigen::AngleAxisd::Identity())
      .toRotationMatrix();
  return WorkspaceMapping(turn, Vector3d(12.3, -4.5, 60.1), 1.7);
}

Trajectory threeRows()
{
  Trajectory trajectory;
  trajectory.rows.resize(3);
  trajectory.rows[0].time = 1.0;
  trajectory.rows[0].tip = Vector3d(0, 0, 8);
  trajectory.rows[1].time = 2.0;
  trajectory.rows[1].tip = Vector3d(0, 16, 0);
  trajectory.rows[2].time = 4.0;
  trajectory.rows[2].tip = Vector3d(0, 0, 0);
  return trajectory;
}
} // namespace

TEST(ReplayDevice, LinearBetweenRowsAtRestAtTheEnds)
{
  ReplayDevice device(threeRows(), WorkspaceMapping());
  EXPECT_EQ(device.begin(), 1.0);
  EXPECT_EQ(device.duration(), 4.0);
  for (const double time : { -1e9, 0.0, 1.0 })
  {
    EXPECT_EQ(device.read(time).position, Vector3d(0, 0, 0.008));
  }
  EXPECT_EQ(device.read(1.5).position, Vector3d(0, 0.008, 0.004));
  EXPECT_EQ(device.read(2.0).position, Vector3d(0, 0.016, 0));
  EXPECT_EQ(device.read(3.0).position, Vector3d(0, 0.008, 0));
  // Only the time determines the position.
  EXPECT_EQ(device.read(3.0).position, Vector3d(0, 0.008, 0));
  for (const double time : { 4.0, 5.0, 1e9 })
  {
    EXPECT_EQ(device.read(time).position, Vector3d(0, 0, 0));
    EXPECT_TRUE(device.read(time).valid);
    EXPECT_TRUE(device.isAtEnd(time));
  }
  EXPECT_FALSE(device.isAtEnd(3.9));
  EXPECT_FALSE(device.read(std::numeric_limits<double>::quiet_NaN()).valid);
  EXPECT_TRUE(device.write({ 1, 2, 3 }));
  EXPECT_EQ(device.lastForce(), Vector3d(1, 2, 3));
  ReplayDevice none{ Trajectory(), WorkspaceMapping() };
  EXPECT_FALSE(none.read(0.0).valid);
}

TEST(ReplayDevice, RowsThatAreNotValidStay)
{
  Trajectory trajectory = threeRows();
  trajectory.hasContact = true;
  trajectory.rows[1].tip.setZero();
  trajectory.rows[1].contact.state = palpate::ContactState::Invalid;
  ReplayDevice device(trajectory, WorkspaceMapping());
  EXPECT_EQ(device.read(1.9).position, Vector3d(0, 0, 0.008)); // no interpolation towards (0, 0, 0)
  EXPECT_TRUE(device.read(1.9).valid);
  EXPECT_FALSE(device.read(2.0).valid);
  EXPECT_FALSE(device.read(3.9).valid);
  EXPECT_TRUE(device.read(4.0).valid);
}

TEST(ReplayDevice, VelocityButtonsAndFreshnessOfARecording)
{
  Trajectory trajectory = threeRows();
  trajectory.hasDevice = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    DeviceSample& sample = trajectory.rows[i].sample;
    sample.position = Vector3d(1.0 * static_cast<double>(i), 0, 0);
    sample.velocity = Vector3d(0, 4.0 * static_cast<double>(i), 0);
    sample.buttons = static_cast<std::uint32_t>(i);
    sample.valid = true;
    sample.fresh = i != 1;
  }
  ReplayDevice device(trajectory, WorkspaceMapping());
  const DeviceSample before = device.read(1.25);
  EXPECT_EQ(before.position, Vector3d(0.25, 0, 0)); // the position of the device, not of the tip
  EXPECT_EQ(before.velocity, Vector3d(0, 1.0, 0));
  EXPECT_EQ(before.buttons, 0U);
  EXPECT_FALSE(before.fresh); // interpolated towards a reading that was not fresh
  EXPECT_FALSE(device.read(2.0).fresh);
  EXPECT_EQ(device.read(2.0).buttons, 1U);
  EXPECT_TRUE(device.read(3.0).fresh);
  EXPECT_EQ(device.read(3.0).buttons, 1U); // pressed from the time of its row
  EXPECT_EQ(device.read(9.0).buttons, 2U);
}

TEST(ReplayDevice, ASessionsFileGivesTheSameTicks)
{
  const auto plate = uniformBody(openPlate(10.0, 20));
  // Without rotation the tips have the same bits, with and without scale and translation.
  for (const WorkspaceMapping& mapping :
    { WorkspaceMapping(), WorkspaceMapping(Eigen::Matrix3d::Identity(), { 1.3, -0.7, 0.3 }, 0.77) })
  {
    const auto device = handOnPlate(mapping);
    const std::vector<Tick> ticks = run(*device, *plate, mapping);
    const ScratchFile file(".csv");
    ASSERT_EQ(palpate::writeTrajectory(file.path(), ticks), "");
    Trajectory read;
    ASSERT_EQ(palpate::readTrajectory(file.path(), read), "");
    ReplayDevice replay(read, mapping);
    const std::vector<Tick> again = run(replay, *plate, mapping);
    int pressing = 0;
    for (std::size_t i = 0; i < ticks.size(); ++i)
    {
      ASSERT_TRUE(same(again[i].tip, ticks[i].tip)) << i;
      ASSERT_TRUE(same(again[i].contact.force, ticks[i].contact.force)) << i;
      ASSERT_EQ(again[i].contact.state, ticks[i].contact.state) << i;
      pressing += ticks[i].contact.normalForce > 0.0;
    }
    EXPECT_GT(pressing, 200);
  }
}

TEST(ReplayDevice, TipsThroughARotation)
{
  const WorkspaceMapping mapping = oblique();
  Trajectory trajectory;
  for (int i = 0; i < 200; ++i)
  {
    TrajectoryRow row;
    row.time = i;
    row.tip = mapping.toBody({ 0.01 * std::sin(1.0 * i), 0.02 * std::cos(2.0 * i), 1e-4 * i });
    trajectory.rows.push_back(row);
  }
  ReplayDevice device(trajectory, mapping);
  for (const TrajectoryRow& row : trajectory.rows)
  {
    // Coordinates are up to 100 mm; the last bit is 1.4e-14.
    const Vector3d tip = mapping.toBody(device.read(row.time).position);
    EXPECT_NEAR((tip - row.tip).norm(), 0.0, 5e-14);
  }
}

TEST(RecordingDevice, ARecordingPlaysTheSameBits)
{
  const auto plate = uniformBody(openPlate(10.0, 20));
  DeviceFaults faults;
  faults.schedule = { { DeviceFault::Dropped, 0.25, 0.003 }, { DeviceFault::NotANumber, 0.3 },
    { DeviceFault::Repeated, 0.32, 0.005 }, { DeviceFault::Disconnect, 0.5, 0.1 } };
  const WorkspaceMapping mapping = oblique();
  // The recording has the samples that the loop received, including faults.
  RecordingDevice recorder(std::make_unique<FaultyDevice>(handOnPlate(mapping), faults), 1000);
  EXPECT_EQ(recorder.specification().rate, recorder.device().specification().rate);
  const std::vector<Tick> ticks = run(recorder, *plate, mapping);
  EXPECT_EQ(recorder.errors().disconnections, 1U);
  EXPECT_EQ(recorder.overruns(), 0U);
  std::vector<RecordedSample> samples;
  recorder.drain(samples);
  ASSERT_EQ(samples.size(), 1000U);
  int taken = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    EXPECT_EQ(samples[i].time, static_cast<double>(i) * Period);
    EXPECT_TRUE(same(samples[i].force, ticks[i].deviceForce));
    taken += samples[i].isTaken;
  }
  EXPECT_EQ(taken, 900);

  const Trajectory read = reread(palpate::trajectoryOf(samples, mapping));
  EXPECT_TRUE(read.hasDevice);
  EXPECT_FALSE(read.hasContact);
  // The mapping differs from that of the recording, because positions are those of the device.
  ReplayDevice replay(read, WorkspaceMapping());
  int invalid = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const DeviceSample& was = samples[i].sample;
    const DeviceSample is = replay.read(static_cast<double>(i) * Period);
    const bool wasUsable = was.valid && was.position.allFinite();
    ASSERT_EQ(is.valid, wasUsable) << i;
    invalid += !is.valid;
    if (wasUsable)
    {
      ASSERT_TRUE(same(is.position, was.position) && same(is.velocity, was.velocity)) << i;
      ASSERT_EQ(is.fresh, was.fresh) << i;
      ASSERT_TRUE(same(read.rows[i].tip, ticks[i].tip)) << i;
    }
    ASSERT_TRUE(same(read.rows[i].sentForce, samples[i].force)) << i;
  }
  EXPECT_EQ(invalid, 101); // disconnected for 0.1 s, and one sample that is not a number

  // With the same mapping, the loop computes the same forces.
  const std::vector<Tick> again = run(replay, *plate, mapping);
  int pressing = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    ASSERT_TRUE(same(again[i].deviceForce, ticks[i].deviceForce)) << i;
    pressing += ticks[i].deviceForce.norm() > 0.0;
  }
  EXPECT_GT(pressing, 200);
}

TEST(RecordingDevice, CountsWhatFindsNoRoom)
{
  RecordingDevice recorder(handOnPlate(), 10);
  for (int tick = 0; tick < 25; ++tick)
  {
    recorder.read(tick * Period);
    recorder.write(Vector3d(0, 0, tick));
  }
  EXPECT_EQ(recorder.overruns(), 15U);
  std::vector<RecordedSample> samples;
  recorder.drain(samples);
  ASSERT_EQ(samples.size(), 10U);
  EXPECT_EQ(samples.back().force.z(), 9.0); // the first readings are kept
  recorder.read(25 * Period);
  recorder.write(Vector3d(0, 0, 25));
  recorder.drain(samples);
  ASSERT_EQ(samples.size(), 11U);
  EXPECT_EQ(samples.back().force.z(), 25.0);
}

TEST(RecordingDevice, ReadingsWithoutForcesAndForcesWithoutReadings)
{
  RecordingDevice recorder(handOnPlate(), 10);
  recorder.write(Vector3d(0, 0, 1)); // before any reading: only passed on
  recorder.read(0.0);
  recorder.read(1.0);
  recorder.write(Vector3d(0, 0, 2));
  recorder.write(Vector3d(0, 0, 3)); // like the zero force at the end of a loop
  recorder.read(2.0);
  std::vector<RecordedSample> samples;
  recorder.drain(samples);
  ASSERT_EQ(samples.size(), 2U); // the reading of 2 s has no force yet
  EXPECT_EQ(samples[0].force, Vector3d(0, 0, 0));
  EXPECT_FALSE(samples[0].isTaken);
  EXPECT_EQ(samples[1].force, Vector3d(0, 0, 2));
  EXPECT_TRUE(samples[1].isTaken);
  const auto& inner = dynamic_cast<const SimulatedDevice&>(recorder.device());
  EXPECT_EQ(inner.lastForce(), Vector3d(0, 0, 3));
}
} // namespace replay_device
