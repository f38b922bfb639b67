// SPDX-License-Identifier: BSD-3-Clause
// A HID device that reports the orientation of its tool and receives a torque; and a HID device
// that does neither.
#include "Transports/Hid/HidDevice.h"

#include "FakeHidBus.h"
#include "KnownReports.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

namespace hid_torque
{
using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
/// A force device on a bus, with the host's device object.
struct Bench
{
  FakeHidBus bus;
  std::shared_ptr<FakeHidDevice> far;
  std::unique_ptr<HidDevice> device;
  std::uint32_t sequence = 0;

  explicit Bench(const DescriptionReport& description)
  {
    HidEntry entry;
    entry.path = "/dev/hidraw3";
    entry.usagePage = 0xFF00;
    entry.usage = 0x50;
    this->far = std::make_shared<FakeHidDevice>(entry);
    HapticReportBytes bytes;
    pack(description, bytes);
    this->far->Feature.assign(bytes.begin(), bytes.end());
    this->bus.plug(this->far);
    std::string error;
    this->device = HidDevice::open(entry.path, error, this->bus);
    EXPECT_EQ(error, "");
  }

  /// Sends a state with this x and orientation. Returns the sample that the tick reads from this
  /// state.
  DeviceSample tell(double x, const ToolOrientation& orientation)
  {
    StateReport state;
    state.sequence = ++this->sequence;
    state.position.x() = x;
    state.orientation = orientation;
    state.amplifiersOn = true;
    this->far->send(state);
    DeviceSample sample;
    EXPECT_TRUE(eventually(
      [&]
      {
        sample = this->device->read(0.0);
        return sample.valid && sample.position.x() == x;
      }));
    return sample;
  }
  /// Writes a wrench and returns the force report that arrives.
  ForceReport write(const Wrench& wrench)
  {
    const std::size_t before = this->far->written().size();
    this->device->writeWrench(wrench);
    EXPECT_TRUE(eventually([&] { return this->far->written().size() == before + 1; }));
    return this->far->lastForce();
  }
};
} // namespace

TEST(HidTorque, OrientationComesInAndTorqueGoesOut)
{
  Bench bench(knownTorqueDescription()); // the limit is 0.25 N m
  EXPECT_FALSE(isTold(bench.tell(0.25, orientationNotTold()).orientation));
  const ToolOrientation turned = turnedBy(Vector3d(0.3, 0.0, -0.1));
  const ToolOrientation told = bench.tell(0.5, turned).orientation;
  EXPECT_LE(turnBetween(told, turned).norm(), 1e-6); // single precision
  EXPECT_EQ(bench.write({ { 1, 0, 0 }, { 0, 0.125, 0 } }).torque, Vector3d(0, 0.125, 0));
  EXPECT_EQ(bench.write({ { 1, 0, 0 }, { 0, 0, -5.0 } }).torque, Vector3d(0, 0, -0.25));
  const ForceReport none = bench.write({ { 1, 0, 0 }, { 0, std::nan(""), 0 } });
  EXPECT_EQ(none.torque, Vector3d::Zero());
  EXPECT_EQ(none.force, Vector3d::Zero());
}

TEST(HidTorque, ADeviceThatOutputsNoneIsSentNone)
{
  Bench bench(knownDescription());
  EXPECT_FALSE(isTold(bench.tell(0.25, orientationNotTold()).orientation));
  const ForceReport sent = bench.write({ { 1, 0, 0 }, { 0, 0.125, 0 } });
  EXPECT_EQ(sent.force, Vector3d(1, 0, 0));
  EXPECT_EQ(sent.torque, Vector3d::Zero());
}
} // namespace hid_torque
