// SPDX-License-Identifier: BSD-3-Clause
// A SpaceMouse in a tick: two modes, rest, limits, loss and return.
#include "Transports/Hid/SpaceMouseDevice.h"

#include "FakeHidBus.h"

#include <gtest/gtest.h>

#include <cmath>

namespace space_mouse_device
{
using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
const std::string Path = "/dev/hidraw5";
constexpr double Period = 1e-3; // s

struct Bench
{
  FakeHidBus bus;
  std::shared_ptr<FakeHidDevice> far;
  std::unique_ptr<SpaceMouseDevice> mouse;
  double time = 0.0;

  explicit Bench(SpaceMouseMode mode)
  {
    this->plug();
    std::string error;
    this->mouse = SpaceMouseDevice::open(Path, mode, error, this->bus);
    EXPECT_EQ(error, "");
  }

  void plug()
  {
    HidEntry entry;
    entry.path = Path;
    entry.vendor = 0x256F;
    entry.product = 0xC635;
    entry.usagePage = 1;
    entry.usage = 8;
    this->far = std::make_shared<FakeHidDevice>(entry);
    this->bus.plug(this->far);
  }

  /// Sends counts to the right, towards the user and down. Waits for the button, which shows that
  /// the counts have been read.
  bool push(int x, int y, int z)
  {
    const auto low = [](int value) { return static_cast<std::uint8_t>(value & 0xFF); };
    const auto high = [](int value) { return static_cast<std::uint8_t>((value >> 8) & 0xFF); };
    const std::uint8_t report[] = { 1, low(x), high(x), low(y), high(y), low(z), high(z) };
    this->far->send(report, sizeof report);
    const std::uint8_t button = ++this->Mark;
    const std::uint8_t buttons[] = { 3, button };
    this->far->send(buttons, sizeof buttons);
    return eventually([&] { return this->mouse->read(this->time).buttons == button; });
  }

  DeviceSample run(double seconds)
  {
    DeviceSample sample;
    for (int i = 0; i < static_cast<int>(std::lround(seconds / Period)); ++i)
    {
      this->time += Period;
      sample = this->mouse->read(this->time);
    }
    return sample;
  }

private:
  std::uint8_t Mark = 0;
};
} // namespace

TEST(SpaceMouse, SilenceAtRestIsNoFault)
{
  Bench bench(SpaceMouseMode::Rate);
  const DeviceSample sample = bench.run(60.0);
  EXPECT_TRUE(sample.valid);
  EXPECT_TRUE(sample.fresh);
  EXPECT_EQ(sample.position, Vector3d::Zero());
  EXPECT_TRUE(std::isinf(bench.mouse->specification().sampleTimeOut));
  EXPECT_FALSE(bench.mouse->specification().outputsForce);
  EXPECT_TRUE(bench.mouse->write({ 1.0, 0.0, 0.0 }));
}

TEST(SpaceMouse, RateModeMovesWhileItIsPushed)
{
  Bench bench(SpaceMouseMode::Rate);
  bench.run(Period);
  ASSERT_TRUE(bench.push(350, 0, 0));
  const DeviceSample moved = bench.run(0.2);
  // Full speed, 0.05 m/s, behind a low-pass filter of 20 ms: 0.05 · (0.2 − 0.02 (1 − e⁻¹⁰)) m.
  // Explicit Euler at 1 ms is ahead by half the path of a tick.
  const double way = 0.05 * (0.2 - 0.02 * (1.0 - std::exp(-10.0)));
  EXPECT_NEAR(moved.position.x(), way, 0.05 * Period);
  EXPECT_NEAR(moved.velocity.x(), 0.05, 1e-4); // a fraction of e⁻¹⁰ is missing
  EXPECT_EQ(moved.position.y(), 0.0);
  ASSERT_TRUE(bench.push(0, 0, 0));
  const DeviceSample after = bench.run(1.0);
  EXPECT_NEAR(after.position.x(), 0.05 * 0.2, 0.05 * 2 * Period) << "the low-pass runs out";
  EXPECT_LT(after.velocity.norm(), 1e-12);
}

TEST(SpaceMouse, RateModeStopsWhenReportsStop)
{
  Bench bench(SpaceMouseMode::Rate);
  bench.run(Period);
  ASSERT_TRUE(bench.push(0, 0, -350)); // a push upward
  bench.run(0.5);
  const DeviceSample sample = bench.run(0.5);
  EXPECT_NEAR(sample.position.y(), 0.05 * 0.25, 0.05 * 3 * Period) << "longestSilence";
  EXPECT_LT(sample.velocity.norm(), 1e-9);
}

TEST(SpaceMouse, StaysWithinItsReach)
{
  Bench bench(SpaceMouseMode::Rate);
  bench.run(Period);
  for (int i = 0; i < 30; ++i)
  {
    ASSERT_TRUE(bench.push(-350, 350, 0));
    bench.run(0.1);
  }
  EXPECT_EQ(bench.run(Period).position, Vector3d(-0.05, 0.0, 0.05));
  EXPECT_EQ(bench.run(Period).velocity, Vector3d::Zero());
}

TEST(SpaceMouse, PositionModeStandsWhereTheCapIs)
{
  Bench bench(SpaceMouseMode::Position);
  bench.run(Period);
  ASSERT_TRUE(bench.push(350, 0, 0));
  EXPECT_NEAR(bench.run(2.0).position.x(), 0.05, 1e-12);
  // 0.52571 of full deflection, which gives (0.52571 − 0.05) / 0.95
  ASSERT_TRUE(bench.push(184, 0, 0));
  EXPECT_NEAR(bench.run(2.0).position.x(), 0.05 * (184.0 / 350.0 - 0.05) / 0.95, 1e-12);
  ASSERT_TRUE(bench.push(17, 0, 0)); // 0.0486: within the dead zone
  EXPECT_NEAR(bench.run(2.0).position.x(), 0.0, 1e-12);
}

TEST(SpaceMouse, APauseOfTheLoopIsNoMotion)
{
  Bench bench(SpaceMouseMode::Rate);
  bench.run(Period);
  ASSERT_TRUE(bench.push(350, 0, 0));
  bench.run(0.1);
  ASSERT_TRUE(bench.push(350, 0, 0));
  const double before = bench.run(Period).position.x();
  bench.time += 10.0;
  ASSERT_TRUE(bench.push(350, 0, 0));
  EXPECT_LT(bench.run(Period).position.x() - before, 0.05 * 0.025) << "not half a metre";
}

TEST(SpaceMouse, TimeThatIsNoneIsNotValid)
{
  Bench bench(SpaceMouseMode::Rate);
  EXPECT_FALSE(bench.mouse->read(std::nan("")).valid);
  EXPECT_TRUE(bench.mouse->read(1.0).valid);
}

TEST(SpaceMouse, UnpluggedAndBack)
{
  Bench bench(SpaceMouseMode::Rate);
  bench.run(Period);
  ASSERT_TRUE(bench.push(350, 0, 0));
  const Vector3d stood = bench.run(0.1).position;
  bench.bus.unplug(Path);
  ASSERT_TRUE(eventually([&] { return bench.mouse->errors().disconnections == 1; }));
  EXPECT_FALSE(bench.mouse->read(bench.time).valid);
  EXPECT_EQ(bench.mouse->status(), "unplugged, waiting for it to return");
  bench.plug();
  ASSERT_TRUE(eventually([&] { return bench.mouse->read(bench.time).valid; }));
  EXPECT_EQ(bench.run(1.0).position, stood) << "as at rest, until it says otherwise";
  EXPECT_EQ(bench.mouse->status(), "connected");
}

TEST(SpaceMouse, WrongLengthsAreCounted)
{
  Bench bench(SpaceMouseMode::Rate);
  const std::uint8_t report[] = { 1, 0xFF, 0xFF, 0xFF };
  bench.far->send(report, sizeof report);
  ASSERT_TRUE(eventually([&] { return bench.mouse->errors().malformed == 1; }));
  EXPECT_EQ(bench.run(0.1).position, Vector3d::Zero());
}
} // namespace space_mouse_device
