// SPDX-License-Identifier: BSD-3-Clause
// The bridge with a scripted device program at the other end, in virtual time: lost, late, damaged
// and foreign datagrams, and a program that ends and returns.
#include "Transports/Bridge/BridgeDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include "BridgePeer.h"
#include "SampleResponses.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <future>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
DescriptionReport described()
{
  DescriptionReport description;
  description.maximumForce = 4.0;
  description.maximumStiffness = 2000.0;
  description.maximumForceRate = 4000.0;
  description.maximumDamping = 8.0;
  description.workspace = Vector3d::Constant(0.0625);
  description.rate = 1000.0;
  description.sampleTimeOut = 0.0205; // s; between two ticks
  description.name = { 'T', 'e', 's', 't' };
  return description;
}

/// A device's program: answers greetings, stores the last force, and sends the states given to it.
class Program
{
public:
  explicit Program(const std::string& address)
    : Peer(address)
  {
  }

  /// Receives the pending datagrams.
  void serve()
  {
    HapticReportBytes bytes{};
    for (long size = 0; (size = this->Peer.receive(bytes)) >= 0;)
    {
      HelloReport hello;
      ForceReport report;
      const auto count = static_cast<std::size_t>(size);
      if (parse(bytes.data(), count, hello) == ReportDefect::None && this->answers)
      {
        DescriptionReport answer = this->description;
        answer.nonce = hello.nonce + this->nonceError;
        pack(answer, bytes);
        this->Peer.send(bytes.data(), bytes.size());
        ++this->greetings;
      }
      else if (parse(bytes.data(), count, report) == ReportDefect::None)
      {
        this->force = report;
        ++this->forces;
      }
    }
  }
  void send(std::uint32_t number, const Vector3d& position = Vector3d::Zero())
  {
    StateReport state;
    state.sequence = this->sequence = number;
    state.amplifiersOn = true;
    state.position = position;
    state.fault = this->fault;
    state.orientation = this->orientation;
    HapticReportBytes bytes{};
    pack(state, bytes);
    this->Peer.send(bytes.data(), bytes.size());
  }
  void sendNext(const Vector3d& position = Vector3d::Zero())
  {
    this->send(this->sequence + 1, position);
  }

  BridgePeer Peer;
  DescriptionReport description = described();
  bool answers = true;
  bool fault = false;
  ToolOrientation orientation = orientationNotTold();
  std::uint32_t nonceError = 0;
  std::uint32_t sequence = 0;
  ForceReport force;
  int forces = 0;
  int greetings = 0;
};

std::string addressOf(const std::string& kind, const std::string& path)
{
  return kind == "unix" ? "unix:" + path : "udp:0";
}

/// Opens the device. Opening waits for an answer, so the program is served in the meantime.
std::unique_ptr<BridgeDevice> opened(Program& program)
{
  std::string error;
  auto opening = std::async(
    std::launch::async, [&] { return BridgeDevice::open(program.Peer.address(), error, 20.0); });
  while (opening.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready)
  {
    program.serve();
  }
  auto device = opening.get();
  program.serve();
  EXPECT_TRUE(device) << error;
  return device;
}

class Bridge : public ::testing::TestWithParam<std::string>
{
protected:
  Bridge()
    : program(std::make_unique<Program>(addressOf(GetParam(), this->Folder.socket("device"))))
    , device(opened(*this->program))
  {
  }
  /// One tick of both sides; the program's state is sent first.
  DeviceSample tick(const Vector3d& position = Vector3d::Zero())
  {
    this->time += 1e-3;
    this->program->serve();
    this->program->sendNext(position);
    return this->device->read(this->time);
  }
  DeviceSample silentTick()
  {
    this->time += 1e-3;
    return this->device->read(this->time);
  }

  SocketFolder Folder;
  std::unique_ptr<Program> program;
  std::unique_ptr<BridgeDevice> device;
  double time = 1000.0; // a host's clock need not start at zero
};

INSTANTIATE_TEST_SUITE_P(
  Sockets, Bridge, ::testing::Values("unix", "udp"), [](const auto& kind) { return kind.param; });
} // namespace

TEST_P(Bridge, OrientationComesInAndTorqueGoesOut)
{
  EXPECT_FALSE(isTold(tick().orientation)); // the program reports no orientation
  EXPECT_TRUE(device->writeWrench({ { 1, 0, 0 }, { 0.1, 0, 0 } }));
  program->serve();
  EXPECT_EQ(program->force.torque, Vector3d::Zero()); // and it accepts no torque
  EXPECT_EQ(program->force.force, Vector3d(1, 0, 0));

  device.reset();
  program->description.outputsTorque = true;
  program->description.maximumTorque = 0.5;
  program->description.maximumTorsionalStiffness = 1.0;
  program->description.maximumTorqueRate = 10.0;
  program->description.name = { 'P', 'e', 'n' };
  program->greetings = 0;
  device = opened(*program);
  ASSERT_TRUE(device);
  EXPECT_EQ(device->specification().maximumTorque, 0.5);
  program->orientation = turnedBy(Vector3d(0.0, 0.3, 0.0));
  const DeviceSample sample = tick();
  ASSERT_TRUE(sample.valid);
  // Single precision, as in the protocol.
  EXPECT_LE(turnBetween(sample.orientation, program->orientation).norm(), 1e-6);
  EXPECT_TRUE(device->writeWrench({ { 0, 1, 0 }, { 0.25, 0, 0 } }));
  program->serve();
  EXPECT_EQ(program->force.torque, Vector3d(0.25, 0, 0));
  // The torque is reduced to the limit.
  EXPECT_TRUE(device->writeWrench({ { 0, 1, 0 }, { 0, -3.0, 0 } }));
  program->serve();
  EXPECT_EQ(program->force.torque, Vector3d(0, -0.5, 0));
  EXPECT_EQ(program->force.force, Vector3d(0, 1, 0));
  EXPECT_TRUE(device->writeWrench({ { 0, 1, 0 }, { 0, std::nan(""), 0 } }));
  program->serve();
  EXPECT_EQ(program->force.torque, Vector3d::Zero());
  EXPECT_EQ(program->force.force, Vector3d::Zero());
  EXPECT_TRUE(device->write({ 0, 1, 0 })); // a force without a torque resets the torque to zero
  program->serve();
  EXPECT_EQ(program->force.torque, Vector3d::Zero());
}

TEST_P(Bridge, ExchangesPositionsAndForces)
{
  EXPECT_EQ(device->specification().maximumForce, 4.0);
  EXPECT_EQ(device->specification().workspace, Vector3d::Constant(0.0625));
  EXPECT_FALSE(device->read(time).valid) << "before the first state";
  EXPECT_FALSE(device->write({ 1, 0, 0 })) << "before the first state";
  for (int i = 1; i <= 1000; ++i)
  {
    const DeviceSample sample = tick({ 0.0, 0.0, 0x1p-16 * i }); // the position is exact in a float
    ASSERT_TRUE(sample.valid && sample.fresh) << i;
    ASSERT_EQ(sample.position.z(), 0x1p-16 * i);
    ASSERT_TRUE(device->write({ 0.0, 0x1p-9 * i, 0.0 }));
    program->serve();
    ASSERT_EQ(program->force.force.y(), 0x1p-9 * i);
    ASSERT_EQ(program->force.stateSequence, program->sequence);
  }
  EXPECT_EQ(program->forces, 1000);
  EXPECT_TRUE(program->force.enable);
  EXPECT_EQ(program->force.watchdog, 20500U);
  EXPECT_EQ(device->status(), "connected");
  const DeviceErrors errors = device->errors();
  EXPECT_EQ(
    errors.malformed + errors.stale + errors.lost + errors.unsent + errors.disconnections, 0U);
}

TEST_P(Bridge, ForceIsShortenedAndNeverNotFinite)
{
  tick();
  EXPECT_TRUE(device->write({ 0.0, 30.0, 40.0 }));
  program->serve();
  // 4 N in the direction (0, 3, 4)/5; floats on the wire.
  EXPECT_NEAR((program->force.force - Vector3d(0.0, 2.4, 3.2)).norm(), 0.0, 1e-6);
  EXPECT_TRUE(device->write({ 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0 }));
  program->serve();
  EXPECT_EQ(program->force.force, Vector3d::Zero());
}

TEST_P(Bridge, CountsWhatIsLostLateAndRepeated)
{
  tick({ 0.25, 0, 0 });
  const std::uint32_t first = program->sequence;
  program->send(first + 5, { 0.5, 0, 0 }); // four reports are lost
  EXPECT_EQ(silentTick().position.x(), 0.5);
  program->send(first + 3, { 0.75, 0, 0 }); // late report
  DeviceSample sample = silentTick();
  EXPECT_TRUE(sample.valid);
  EXPECT_FALSE(sample.fresh);
  EXPECT_EQ(sample.position.x(), 0.5);
  program->send(first + 5, { 0.75, 0, 0 }); // repeated report
  EXPECT_EQ(silentTick().position.x(), 0.5);
  program->send(first + 6, { 1, 0, 0 });
  program->send(first + 7, { 2, 0, 0 }); // the newest of several reports
  EXPECT_EQ(silentTick().position.x(), 2.0);
  EXPECT_EQ(device->errors().lost, 4U);
  EXPECT_EQ(device->errors().stale, 2U);
  EXPECT_EQ(device->errors().disconnections, 0U);
}

TEST_P(Bridge, CountsWhatIsMalformed)
{
  tick({ 0.5, 0, 0 });
  StateReport state;
  state.sequence = program->sequence + 1;
  state.position.x() = 9.0;
  HapticReportBytes good{};
  pack(state, good);
  std::vector<std::uint8_t> longer(good.begin(), good.end());
  longer.push_back(0);
  program->Peer.send(longer.data(), longer.size());
  program->Peer.send(good.data(), good.size() - 1);
  program->Peer.send(good.data(), 0);
  for (const std::size_t byte : { 0, 1, 2, 16, 60 }) // mark, kind, version, position, checksum
  {
    HapticReportBytes bad = good;
    bad[byte] = static_cast<std::uint8_t>(bad[byte] ^ 0x81);
    program->Peer.send(bad.data(), bad.size());
  }
  const DeviceSample sample = silentTick();
  EXPECT_EQ(device->errors().malformed, 8U);
  EXPECT_EQ(sample.position.x(), 0.5);
  EXPECT_FALSE(sample.fresh);
}

TEST_P(Bridge, IgnoresOtherSenders)
{
  tick({ 0.5, 0, 0 });
  Program other(addressOf(GetParam(), Folder.socket("other")));
  other.Peer.imitate(program->Peer);
  other.send(program->sequence + 1, { 9, 0, 0 });
  other.send(program->sequence + 2, { 9, 0, 0 });
  const DeviceSample sample = silentTick();
  EXPECT_EQ(sample.position.x(), 0.5);
  EXPECT_FALSE(sample.fresh);
  EXPECT_EQ(device->foreign(), 2U);
  EXPECT_EQ(device->errors().malformed, 0U);
}

TEST_P(Bridge, NoForceInTheFirstTickAfterTheTimeOut)
{
  const auto plate = std::shared_ptr<const ContactBody>(uniformBody(openPlate(10.0, 20)));
  const Vector3d above(5e-3, 5e-3, 1e-4);
  const Vector3d pressed(5e-3, 5e-3, -5e-4);
  ServoStep step(std::make_unique<ServoScene>(plate, ContactSettings()), WorkspaceMapping(),
    SafetySettings::of(device->specification()));
  const auto servo = [&](const DeviceSample& sample)
  {
    const Tick done = step.step(sample, time);
    device->write(done.deviceForce);
    return done.deviceForce;
  };
  servo(tick(above));
  for (int i = 0; i < 100; ++i)
  {
    servo(tick(pressed));
  }
  ASSERT_GT(servo(tick(pressed)).norm(), 0.1);
  const double last = time;
  int ticks = 0;
  for (DeviceSample sample = silentTick(); sample.valid; sample = silentTick())
  {
    EXPECT_FALSE(sample.fresh);
    servo(sample);
    program->serve();
    ASSERT_LT(++ticks, 100) << device->specification().sampleTimeOut;
  }
  EXPECT_EQ(servo(DeviceSample()), Vector3d::Zero());
  // The first tick after 20.5 ms; time is a sum of milliseconds.
  EXPECT_NEAR(time - last, 0.021, 1e-6);
  program->serve();
  EXPECT_FALSE(program->force.enable);
  EXPECT_EQ(program->force.force, Vector3d::Zero());
  EXPECT_EQ(device->errors().disconnections, 1U);
  EXPECT_FALSE(device->write({ 1, 0, 0 }));
}

TEST_P(Bridge, AProgramThatDiesAndReturnsIsUsedAgain)
{
  const std::string address = program->Peer.address(); // includes the port, which is used again
  for (int round = 0; round < 5; ++round)
  {
    ASSERT_TRUE(tick().valid || tick().valid) << round;
    program.reset();
    for (int i = 0; i < 100; ++i)
    {
      device->write({ 1, 0, 0 });
      silentTick();
    }
    EXPECT_FALSE(silentTick().valid);
    EXPECT_EQ(device->status(), "silent, waiting for it to return");
    program = std::make_unique<Program>(address);
    program->sequence = 17; // its numbers start again
    for (int i = 0; i < 400 && !tick().valid; ++i)
    {
    }
    EXPECT_TRUE(tick({ 0.5, 0, 0 }).valid);
    EXPECT_GE(program->greetings, 1);
    EXPECT_TRUE(device->write({ 1, 0, 0 }));
  }
  EXPECT_EQ(device->errors().disconnections, 5U);
}

TEST_P(Bridge, AProgramThatStartsAnewWithinTheTimeOutHasToDescribeItself)
{
  for (int i = 0; i < 50; ++i)
  {
    tick();
  }
  const int before = program->greetings;
  program->sequence = 0;
  int invalid = 0;
  for (int i = 0; i < 30; ++i)
  {
    invalid += tick().valid ? 0 : 1;
  }
  EXPECT_GT(invalid, 0);
  EXPECT_GT(program->greetings, before);
  EXPECT_TRUE(tick().valid);
  EXPECT_EQ(device->errors().disconnections, 1U);
}

TEST_P(Bridge, AStrangerInItsPlaceIsNotUsed)
{
  tick();
  program->description.maximumForce = 60.0;
  for (int i = 0; i < 30; ++i)
  {
    silentTick();
  }
  for (int i = 0; i < 600; ++i)
  {
    ASSERT_FALSE(tick().valid);
    ASSERT_FALSE(device->write({ 1, 0, 0 }));
  }
  EXPECT_NE(device->status().find("describes itself otherwise"), std::string::npos);
  EXPECT_FALSE(program->force.enable);
}

TEST_P(Bridge, AnAnswerToAnotherGreetingIsNone)
{
  tick();
  for (int i = 0; i < 30; ++i)
  {
    silentTick();
  }
  program->nonceError = 1;
  for (int i = 0; i < 600; ++i)
  {
    ASSERT_FALSE(tick().valid);
  }
  EXPECT_GE(device->errors().malformed, 2U); // four greetings per second for 0.6 s
}

TEST_P(Bridge, AFaultTakesTheForceAway)
{
  tick();
  device->write({ 1, 0, 0 });
  program->fault = true;
  EXPECT_FALSE(tick().valid);
  EXPECT_FALSE(device->write({ 1, 0, 0 }));
  program->serve();
  EXPECT_FALSE(program->force.enable);
  EXPECT_EQ(device->status(), "connected, but it reports a fault");
}

TEST_P(Bridge, ATimeThatIsNoNumberIsALoss)
{
  tick();
  EXPECT_FALSE(device->read(std::numeric_limits<double>::quiet_NaN()).valid);
}

TEST_P(Bridge, SaysGoodbye)
{
  tick();
  device->write({ 1, 0, 0 });
  device.reset();
  program->serve();
  EXPECT_FALSE(program->force.enable);
  EXPECT_EQ(program->force.force, Vector3d::Zero());
}

TEST(BridgeAddress, WhatIsWrongIsNamed)
{
  const auto complaint = [](const std::string& address)
  {
    std::string error;
    EXPECT_FALSE(BridgeDevice::open(address, error, 0.0)) << address;
    return error;
  };
  EXPECT_EQ(complaint("tcp:5"), "'tcp:5': is neither unix:/PATH nor udp:PORT");
  EXPECT_EQ(complaint("unix"), "'unix': is neither unix:/PATH nor udp:PORT");
  EXPECT_EQ(complaint("unix:a"), "'unix:a': the path of a Unix socket must begin with '/'");
  EXPECT_EQ(complaint("unix:/" + std::string(107, 'x')).substr(117),
    "the path of a Unix socket has at most 107 bytes, this one 108");
  for (const char* port : { "udp:", "udp:0", "udp:65536", "udp:-1", "udp:12a", "udp:host:5" })
  {
    EXPECT_NE(complaint(port).find("a port is a number from 1 to 65535"), std::string::npos);
  }
  EXPECT_EQ(complaint("unix:/nobody/there"),
    "'unix:/nobody/there': no program there describes itself as a device");
}

TEST(BridgeExample, IsADevice)
{
  const SocketFolder folder;
  const std::string path = folder.socket("device");
  const pid_t child = fork();
  if (child == 0)
  {
    execl(PALPATE_BRIDGE_EXAMPLE, "bridge_device", path.c_str(), nullptr);
    _exit(127);
  }
  std::string error;
  const auto device = BridgeDevice::open("unix:" + path, error, 20.0);
  EXPECT_TRUE(device) << error;
  double lowest = 1.0;
  double highest = -1.0;
  bool amplified = false;
  const auto begin = std::chrono::steady_clock::now();
  for (double time = 0.0; device && time < 20.0 && !(highest - lowest > 0.015 && amplified);)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const DeviceSample sample = device->read(time);
    device->write({ 0, 0, 1 });
    if (sample.valid)
    {
      lowest = std::min(lowest, sample.position.z());
      highest = std::max(highest, sample.position.z());
      amplified = amplified || device->status() == "connected";
    }
  }
  EXPECT_TRUE(amplified) << "it takes forces";
  EXPECT_GT(highest - lowest, 0.015) << "the hand taps, 20 mm from top to bottom";
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  unlink(path.c_str());
}
