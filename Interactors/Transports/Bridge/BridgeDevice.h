// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BridgeDevice_h
#define palpate_BridgeDevice_h

#include "Transports/Bridge/BridgeSocket.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Transports/Hid/HapticReport.h"
#include "Mechanics/PalpateExport.h"
#include "Transports/Hid/ReportSequence.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/**
 * A device that another program drives. The 64-byte force reports (PROTOCOL.md) are exchanged as
 * datagrams through a local socket (BridgeSocket). Therefore any vendor's SDK can serve as a
 * device; device/bridge_device.c is such a program.
 *
 * The class uses no threads. read receives the datagrams that have arrived, at most ReadsPerTick,
 * and uses the newest state. write sends a force. Both functions need a few system calls and never
 * wait. Only datagrams from the program's address are used. The program counts as lost if it has
 * restarted, or if no new state arrives for longer than the specification's sampleTimeOut, measured
 * by the time passed to read. While the program is lost, read returns samples that are not valid,
 * and write sends no force and returns false. Four greetings per second are sent to a lost program.
 * The program is used again when it has sent the same description as before and a valid state.
 *
 * The destructor sends "amplifiers off, zero force". One thread may call read and write; another
 * thread may call status and the counters.
 */
class PALPATE_EXPORT BridgeDevice final : public HapticDevice
{
public:
  static constexpr int ReadsPerTick = 64;

  /// Sends greetings to the program at `address` ("unix:/PATH" or "udp:PORT") until its description
  /// arrives, for at most `patience` s. If no description arrives, returns null and sets `error` to
  /// the reason.
  static std::unique_ptr<BridgeDevice> open(
    const std::string& address, std::string& error, double patience = 2.0);
  ~BridgeDevice() override;

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  const DescriptionReport& description() const noexcept { return this->Description; }

  DeviceSample read(double time) noexcept override;
  /// Force and torque are limited to the maxima of the specification. If force or torque is not
  /// finite, both are sent as zero. No torque is sent to a device without torque output.
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;
  void holdFor(double seconds) noexcept override;

  std::string status() const override;
  DeviceErrors errors() const noexcept override;
  /// Number of datagrams from other senders. These datagrams are ignored.
  std::uint64_t foreign() const noexcept { return this->Foreign; }

private:
  enum class Stage : std::uint8_t
  {
    Greeting,  ///< waits for the program's description
    Described, ///< waits for the program's first state
    Alive
  };
  BridgeDevice(std::unique_ptr<BridgeSocket> socket, std::string address, std::uint32_t nonce);
  bool greetFirst(double patience);
  void receiveAll(double time) noexcept;
  void take(const std::uint8_t* bytes, std::size_t size, double time) noexcept;
  void takeState(const StateReport& state, double time) noexcept;
  void takeDescription(const DescriptionReport& description) noexcept;
  void lose() noexcept;
  void greet() noexcept;
  bool send(const Wrench& wrench, bool enable) noexcept;

  std::unique_ptr<BridgeSocket> Socket;
  std::string Address;
  std::string Remark; ///< names of the values in the description that were not credible
  DeviceSpecification Limits;
  DescriptionReport Description;
  std::uint32_t Watchdog = 0; ///< µs
  bool Known = false;         ///< whether the description has arrived at least once

  std::uint32_t Nonce;
  bool Started = false;   ///< whether read has been called
  double GreetedAt = 0.0; ///< s
  ReportSequence Sequence;
  StateReport Newest;
  double NewsAt = 0.0; ///< time of Newest, s
  bool Fresh = false;
  std::uint32_t ForceSequence = 0;

  std::atomic<Stage> Now{ Stage::Greeting };
  std::atomic<bool> Stranger{ false }; ///< whether the program now describes another device
  std::atomic<bool> Faulty{ false };
  std::atomic<bool> Amplified{ false };
  std::atomic<std::uint64_t> Malformed{ 0 };
  std::atomic<std::uint64_t> Stale{ 0 };
  std::atomic<std::uint64_t> Lost{ 0 };
  std::atomic<std::uint64_t> Unsent{ 0 };
  std::atomic<std::uint64_t> Disconnections{ 0 };
  std::atomic<std::uint64_t> Foreign{ 0 };
};
} // namespace palpate

#endif
