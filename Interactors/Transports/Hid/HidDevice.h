// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HidDevice_h
#define palpate_HidDevice_h

#include "Transports/Hid/ForceWriter.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Transports/Hid/HapticReport.h"
#include "Transports/Hid/HidBus.h"
#include "Transports/Hid/HidReader.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/**
 * A device that uses the 64-byte force reports over raw HID (PROTOCOL.md).
 *
 * A reader and a writer thread decouple the tick from the driver: read returns the newest state,
 * and write passes the force to the writer thread. Neither function waits, even if the driver
 * hangs. Reports are counted but not used if they are damaged, of another version, old or repeated.
 *
 * The specification consists of the credible values of the device's feature report; the other
 * values are conservative (specificationOf). No force is sent before a valid state has arrived, so
 * that no force is sent to another kind of device on the same vendor page.
 *
 * If the device is unplugged or reports a fault, the samples of read are not valid from the next
 * call on, and write sends no force and returns false. A device that is plugged in again is used if
 * its description is the same; samples are valid again with its first state. status reports the
 * state of the connection. The destructor sends "amplifiers off" and ends within about two seconds
 * even if the driver hangs.
 *
 * The two threads request SCHED_FIFO but also work without it.
 */
class PALPATE_EXPORT HidDevice final : public HapticDevice
{
public:
  /// Opens the device at `path`, such as "/dev/hidraw0". On failure, returns null and sets `error`
  /// to the reason.
  static std::unique_ptr<HidDevice> open(
    const std::string& path, std::string& error, HidBus& bus = systemHidBus());
  ~HidDevice() override;

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// The description as received from the device. All members are zero if the device has none.
  const DescriptionReport& description() const noexcept { return this->Description; }

  DeviceSample read(double time) noexcept override;
  /// Force and torque are limited to the maxima of the specification. If force or torque is not
  /// finite, both are sent as zero, and the result is false. No torque is sent to a device without
  /// torque output.
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;
  void holdFor(double seconds) noexcept override;

  std::string status() const override;
  DeviceErrors errors() const noexcept override;

private:
  class Link;
  HidDevice(HidBus& bus, const HidEntry& entry, std::unique_ptr<HidPort> port,
    std::shared_ptr<Link> link, const DescriptionReport& description, std::string remark);

  DeviceSpecification Limits;
  DescriptionReport Description;
  std::string Remark; ///< names of the values in the description that were not credible
  std::shared_ptr<Link> Connection;
  std::unique_ptr<HidReader> Reader;
  std::uint64_t Seen = 0;          ///< number of the last state that was read
  std::uint32_t StateSequence = 0; ///< sequence number of the last state that was read
};
} // namespace palpate

#endif
