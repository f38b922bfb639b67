// SPDX-License-Identifier: BSD-3-Clause
// A program at the other end of the bridge that sends arbitrary data. The samples of the device are
// either invalid, or finite and not older than the time-out. No force is sent to a program that has
// not described itself. Input: chunks; the first byte of each chunk selects the event, see step().
#include "Transports/Bridge/BridgeDevice.h"
#include "BridgePeer.h"
#include "Require.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <memory>
#include <thread>

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
  description.workspace.setConstant(0.0625);
  description.rate = 1000.0;
  description.sampleTimeOut = 0.02;
  return description;
}

/// A device on a Unix socket, opened once, and the program at the other end of the socket.
class Bridge
{
public:
  Bridge()
  {
    std::string error;
    std::thread host([&] { this->Device = BridgeDevice::open(this->Peer.address(), error); });
    while (!this->serve(described()))
    {
      std::this_thread::yield();
    }
    host.join();
    require(this->Device != nullptr, "an honest program is a device");
  }

  /// Restores the initial state: a described and connected device, with a new program at the other
  /// end.
  void begin()
  {
    this->Time += 1.0;
    // After a long silence the device is lost and receives a greeting again.
    this->Device->read(this->Time);
    this->serve(described());
    this->Device->read(this->Time);
  }

  void step(FuzzedDataProvider& input)
  {
    switch (input.ConsumeIntegralInRange<int>(0, 3))
    {
      case 0:
        this->send(
          input.ConsumeBytes<std::uint8_t>(input.ConsumeIntegralInRange<std::size_t>(0, 80)));
        break;
      case 1:
        this->sendState(input);
        break;
      case 2:
        this->Time += input.ConsumeFloatingPointInRange(0.0, 0.05);
        this->serve(described());
        break;
      default:
        this->Device->writeWrench(
          { Eigen::Vector3d(input.ConsumeFloatingPoint<double>(),
              input.ConsumeFloatingPoint<double>(), input.ConsumeFloatingPoint<double>()),
            Eigen::Vector3d::Constant(input.ConsumeFloatingPoint<double>()) });
        break;
    }
    const DeviceSample sample = this->Device->read(this->Time);
    require(!sample.valid ||
        (sample.position.allFinite() && sample.velocity.allFinite() &&
          sample.orientation.coeffs().allFinite()),
      "a valid sample is finite");
    require(!sample.fresh || !sample.valid || this->Sound, "news come from sound reports alone");
    if (sample.valid && sample.fresh)
    {
      this->NewsAt = this->Time;
    }
    require(
      !sample.valid || this->Time - this->NewsAt <= 0.02, "no sample is older than the time-out");
  }

private:
  /// Answers greetings. Returns true if there was a greeting. Received forces must be within the
  /// limits.
  bool serve(const DescriptionReport& description)
  {
    HapticReportBytes bytes{};
    bool greeted = false;
    for (long size = 0; (size = this->Peer.receive(bytes)) >= 0;)
    {
      HelloReport hello;
      ForceReport force;
      const auto count = static_cast<std::size_t>(size);
      if (parse(bytes.data(), count, hello) == ReportDefect::None)
      {
        DescriptionReport answer = description;
        answer.nonce = hello.nonce;
        pack(answer, bytes);
        this->Peer.send(bytes.data(), bytes.size());
        greeted = true;
      }
      else if (parse(bytes.data(), count, force) == ReportDefect::None)
      {
        require(force.force.norm() <= description.maximumForce * (1.0 + 1e-6),
          "no force beyond the limit");
        require(force.torque.norm() == 0.0, "no torque to one that outputs none");
      }
      else
      {
        require(false, "the host sends sound reports");
      }
    }
    return greeted;
  }
  void send(const std::vector<std::uint8_t>& bytes)
  {
    this->Sound = this->Sound || checkReport(bytes.data(), bytes.size()) == ReportDefect::None;
    this->Peer.send(bytes.data(), bytes.size());
  }
  void sendState(FuzzedDataProvider& input)
  {
    StateReport state;
    state.sequence =
      input.ConsumeBool() ? ++this->Sequence : input.ConsumeIntegral<std::uint32_t>();
    state.amplifiersOn = input.ConsumeBool();
    state.fault = input.ConsumeBool();
    state.position.setConstant(input.ConsumeFloatingPoint<double>());
    state.velocity.setConstant(input.ConsumeFloatingPoint<double>());
    HapticReportBytes bytes{};
    pack(state, bytes);
    this->Sound = true;
    this->Peer.send(bytes.data(), bytes.size());
  }

  SocketFolder Folder;
  BridgePeer Peer{ "unix:" + this->Folder.socket("device") };
  std::unique_ptr<BridgeDevice> Device;
  double Time = 0.0;
  double NewsAt = -1.0;
  std::uint32_t Sequence = 0;
  bool Sound = false; ///< true once a valid report has been sent
};
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static Bridge bridge;
  bridge.begin();
  FuzzedDataProvider input(data, size);
  while (input.remaining_bytes() > 0)
  {
    bridge.step(input);
  }
  return 0;
}
