// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HapticReport_h
#define palpate_HapticReport_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace palpate
{
/**
 * The reports between a host and a self-built device, 64 bytes each, over raw HID or datagrams.
 * PROTOCOL.md describes them byte by byte; palpate_hid.h is the device's implementation in C.
 *
 * pack always makes a valid report. parse accepts any bytes; if they are invalid, it returns the
 * defect and leaves its result unchanged. Unused bytes are sent as zero and ignored. No function
 * allocates, locks or throws, except specificationOf.
 */
constexpr std::size_t HapticReportSize = 64;
using HapticReportBytes = std::array<std::uint8_t, HapticReportSize>;

constexpr std::uint8_t HapticReportMark = 0x50; ///< 'P', the first byte
constexpr std::uint8_t HapticReportVersion = 1;

enum class ReportKind : std::uint8_t
{
  State = 1,       ///< device → host
  Force = 2,       ///< host → device
  Description = 3, ///< device → host
  Hello = 4        ///< host → device, datagrams only: asks for a description
};

/// A report from the device to the host, one per reading.
struct StateReport
{
  bool amplifiersOn = false;
  bool fault = false; ///< the device reports a fault: no force is sent
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;                             ///< the device's clock, µs
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m; finite
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< m/s; finite
  std::uint32_t buttons = 0;
  std::uint32_t forceSequence = 0;                    ///< number of the last applied force report
  ToolOrientation orientation = orientationNotTold(); ///< unit quaternion
};

/// A report from the host to the device.
struct ForceReport
{
  bool enable = false; ///< false: amplifiers off, whatever the force
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;                          ///< the host's clock, µs
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< N; finite
  /// The device sets zero force if no force report arrives for this time, µs.
  std::uint32_t watchdog = 20000;
  std::uint32_t stateSequence = 0;                  ///< number of the newest received state
  Eigen::Vector3d torque = Eigen::Vector3d::Zero(); ///< N m, about the tip; finite
};

/// A report from the device to the host: the manufacturer's specification as received.
/// specificationOf replaces values that are not credible.
struct DescriptionReport
{
  bool outputsForce = true;
  bool planar = false;                                 ///< moves only in its xy plane
  double maximumForce = 0.0;                           ///< N
  double maximumStiffness = 0.0;                       ///< N/m
  double maximumForceRate = 0.0;                       ///< N/s, may be infinite
  double maximumDamping = 0.0;                         ///< N s/m
  Eigen::Vector3d workspace = Eigen::Vector3d::Zero(); ///< half extents, m
  double rate = 0.0;                                   ///< Hz
  double sampleTimeOut = 0.0;                          ///< s
  std::array<char, 17> name{};                         ///< at most 16 bytes of UTF-8, and a zero
  std::uint32_t nonce = 0; ///< the nonce of the answered hello; 0 in HID's feature report

  /// If true, `name` has at most 3 bytes, and the following members are valid.
  bool outputsTorque = false;
  double maximumTorque = 0.0;             ///< N m
  double maximumTorsionalStiffness = 0.0; ///< N m/rad
  double maximumTorqueRate = 0.0;         ///< N m/s, may be infinite
};

/// A report from the host to the device, only as a datagram.
struct HelloReport
{
  std::uint32_t nonce = 0;
};

/// Returns the watchdog of a force report, µs, for a hold time `seconds`. The result is at most the
/// device's time-out; if `seconds` is NaN, it is the time-out.
PALPATE_EXPORT std::uint32_t watchdogOf(
  double seconds, const DeviceSpecification& specification) noexcept;

/// The defect of a report, in the order of the checks.
enum class ReportDefect : std::uint8_t
{
  None,
  Size,     ///< not 64 bytes
  Mark,     ///< the first byte is not 'P'
  Version,  ///< not 1
  CheckSum, ///< damaged in transit
  Kind,     ///< another kind than expected
  Content   ///< a position, velocity, force or torque that is not finite, or an invalid rotation
};
/// Returns a text such as "wrong check sum".
PALPATE_EXPORT const char* inWords(ReportDefect defect) noexcept;

PALPATE_EXPORT void pack(const StateReport& report, HapticReportBytes& bytes) noexcept;
PALPATE_EXPORT void pack(const ForceReport& report, HapticReportBytes& bytes) noexcept;
PALPATE_EXPORT void pack(const DescriptionReport& report, HapticReportBytes& bytes) noexcept;
PALPATE_EXPORT void pack(const HelloReport& report, HapticReportBytes& bytes) noexcept;

PALPATE_EXPORT ReportDefect parse(
  const std::uint8_t* bytes, std::size_t size, StateReport& report) noexcept;
PALPATE_EXPORT ReportDefect parse(
  const std::uint8_t* bytes, std::size_t size, ForceReport& report) noexcept;
PALPATE_EXPORT ReportDefect parse(
  const std::uint8_t* bytes, std::size_t size, DescriptionReport& report) noexcept;
PALPATE_EXPORT ReportDefect parse(
  const std::uint8_t* bytes, std::size_t size, HelloReport& report) noexcept;

/// Checks size, mark, version and check sum; the kind of a valid report is byte 1.
PALPATE_EXPORT ReportDefect checkReport(const std::uint8_t* bytes, std::size_t size) noexcept;

/// CRC-32 of IEEE 802.3 (reflected, polynomial 0xEDB88320), as zlib's crc32.
PALPATE_EXPORT std::uint32_t reportCheckSum(const std::uint8_t* bytes, std::size_t size) noexcept;

/**
 * Returns the specification of a device from its description. A conservative value replaces each
 * value that is missing or not credible (credible: 0 < force ≤ 100 N, 0 < stiffness ≤ 20000 N/m, 0
 * < force rate, 0 < damping ≤ 200 N s/m, 0 < half extents ≤ 2 m, 10 ≤ rate ≤ 20000 Hz, 0 < time-out
 * ≤ 0.1 s; for a device that outputs torque 0 < torque ≤ 5 N m, 0 < torsional stiffness ≤ 100 N
 * m/rad, 0 < torque rate). `replaced`, unless null, receives the names of the replaced values. Not
 * for the tick, because it allocates.
 */
PALPATE_EXPORT DeviceSpecification specificationOf(
  const DescriptionReport& description, std::string* replaced = nullptr);
/// The specification for a device without a description: weak and slow enough for any device.
PALPATE_EXPORT DeviceSpecification carefulSpecification() noexcept;
} // namespace palpate

#endif
