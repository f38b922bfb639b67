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
 * The reports between a host and a self-built device, 64 bytes each, sent over raw HID or as
 * datagrams. PROTOCOL.md describes them byte by byte; palpate_hid.h implements the device's side in
 * C.
 *
 * pack always makes a valid report. parse accepts any bytes. If the bytes are invalid, parse
 * returns the defect and leaves its result unchanged. Unused bytes are sent as zero and ignored by
 * the receiver. No function allocates, locks or throws, except specificationOf.
 */
constexpr std::size_t HapticReportSize = 64;
using HapticReportBytes = std::array<std::uint8_t, HapticReportSize>;

constexpr std::uint8_t HapticReportMark = 0x50; ///< first byte of a report, 'P'
constexpr std::uint8_t HapticReportVersion = 1;

enum class ReportKind : std::uint8_t
{
  State = 1,       ///< from the device to the host
  Force = 2,       ///< from the host to the device
  Description = 3, ///< from the device to the host
  Hello = 4        ///< from the host to the device, only as a datagram; asks for a description
};

/// A report from the device to the host. One report is sent per reading.
struct StateReport
{
  bool amplifiersOn = false;
  bool fault = false; ///< the device has a fault, and the host sends no force
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;                             ///< time by the device's clock, µs
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m; must be finite
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< m/s; must be finite
  std::uint32_t buttons = 0;
  std::uint32_t forceSequence = 0; ///< number of the last force report that was applied
  ToolOrientation orientation = orientationNotTold(); ///< unit quaternion
};

/// A report from the host to the device.
struct ForceReport
{
  bool enable = false; ///< if false, the amplifiers are off, regardless of the force
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;                          ///< time by the host's clock, µs
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< N; must be finite
  /// Time, µs, after which the device sets zero force if no further force report arrives.
  std::uint32_t watchdog = 20000;
  std::uint32_t stateSequence = 0; ///< number of the newest state that was received
  Eigen::Vector3d torque = Eigen::Vector3d::Zero(); ///< about the tip, N m; must be finite
};

/// A report from the device to the host with the manufacturer's specification as received.
/// specificationOf replaces values that are not credible.
struct DescriptionReport
{
  bool outputsForce = true;
  bool planar = false;                                 ///< the device moves only in its xy plane
  double maximumForce = 0.0;                           ///< N
  double maximumStiffness = 0.0;                       ///< N/m
  double maximumForceRate = 0.0;                       ///< N/s, may be infinite
  double maximumDamping = 0.0;                         ///< N s/m
  Eigen::Vector3d workspace = Eigen::Vector3d::Zero(); ///< half extents, m
  double rate = 0.0;                                   ///< Hz
  double sampleTimeOut = 0.0;                          ///< s
  std::array<char, 17> name{}; ///< at most 16 bytes of UTF-8, followed by a zero
  std::uint32_t nonce = 0; ///< nonce of the hello that is answered; 0 in the feature report of HID

  /// Whether the device outputs torque. If true, `name` has at most 3 bytes, and the following
  /// members are valid.
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

/// Returns the watchdog of a force report, µs, for a hold time of `seconds` s. The result is at
/// most the device's time-out. If `seconds` is NaN, the result is the time-out.
PALPATE_EXPORT std::uint32_t watchdogOf(
  double seconds, const DeviceSpecification& specification) noexcept;

/// The defect of a report, in the order of the checks.
enum class ReportDefect : std::uint8_t
{
  None,
  Size,     ///< the size is not 64 bytes
  Mark,     ///< the first byte is not 'P'
  Version,  ///< the version is not 1
  CheckSum, ///< the checksum is wrong, because the report was damaged in transit
  Kind,     ///< the report is of another kind than expected
  Content   ///< a position, velocity, force or torque is not finite, or the rotation is invalid
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

/// Checks size, mark, version and checksum. The kind of a valid report is byte 1.
PALPATE_EXPORT ReportDefect checkReport(const std::uint8_t* bytes, std::size_t size) noexcept;

/// CRC-32 of IEEE 802.3 (reflected, polynomial 0xEDB88320), the same as crc32 of zlib.
PALPATE_EXPORT std::uint32_t reportCheckSum(const std::uint8_t* bytes, std::size_t size) noexcept;

/**
 * Returns the specification of a device from its description. A conservative value replaces each
 * value that is missing or not credible. Credible are 0 < force ≤ 100 N, 0 < stiffness ≤ 20000 N/m,
 * 0 < force rate, 0 < damping ≤ 200 N s/m, 0 < half extents ≤ 2 m, 10 ≤ rate ≤ 20000 Hz, 0 <
 * time-out ≤ 0.1 s, and for a device that outputs torque 0 < torque ≤ 5 N m, 0 < torsional
 * stiffness ≤ 100 N m/rad, 0 < torque rate. The names of the replaced values are written to
 * `replaced` unless it is null. The function allocates and must not be called from the servo tick.
 */
PALPATE_EXPORT DeviceSpecification specificationOf(
  const DescriptionReport& description, std::string* replaced = nullptr);
/// Returns the specification for a device without a description. Its limits are low enough for any
/// device.
PALPATE_EXPORT DeviceSpecification carefulSpecification() noexcept;
} // namespace palpate

#endif
