// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Hid/HapticReport.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
constexpr std::size_t CheckSumOffset = 60;

constexpr std::array<std::uint32_t, 256> checkSumTable()
{
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte)
  {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit)
    {
      remainder = (remainder >> 1) ^ ((remainder & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    table[byte] = remainder;
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> CheckSumTable = checkSumTable();

/// The members of a report are little-endian, regardless of the byte order of the host.
void put32(HapticReportBytes& bytes, std::size_t offset, std::uint32_t value) noexcept
{
  for (std::size_t i = 0; i < 4; ++i)
  {
    bytes[offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
  }
}

std::uint32_t get32(const std::uint8_t* bytes, std::size_t offset) noexcept
{
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    value |= static_cast<std::uint32_t>(bytes[offset + i]) << (8 * i);
  }
  return value;
}

void put64(HapticReportBytes& bytes, std::size_t offset, std::uint64_t value) noexcept
{
  put32(bytes, offset, static_cast<std::uint32_t>(value));
  put32(bytes, offset + 4, static_cast<std::uint32_t>(value >> 32));
}

std::uint64_t get64(const std::uint8_t* bytes, std::size_t offset) noexcept
{
  return get32(bytes, offset) | static_cast<std::uint64_t>(get32(bytes, offset + 4)) << 32;
}

static_assert(sizeof(float) == 4, "fields are IEEE 754 single precision");

void putFloat(HapticReportBytes& bytes, std::size_t offset, double value) noexcept
{
  const auto single = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &single, sizeof bits);
  put32(bytes, offset, bits);
}

double getFloat(const std::uint8_t* bytes, std::size_t offset) noexcept
{
  const std::uint32_t bits = get32(bytes, offset);
  float single = 0.0F;
  std::memcpy(&single, &bits, sizeof single);
  return static_cast<double>(single);
}

void putVector(HapticReportBytes& bytes, std::size_t offset, const Eigen::Vector3d& value) noexcept
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    putFloat(bytes, offset + 4 * i, value[static_cast<Eigen::Index>(i)]);
  }
}

Eigen::Vector3d getVector(const std::uint8_t* bytes, std::size_t offset) noexcept
{
  return { getFloat(bytes, offset), getFloat(bytes, offset + 4), getFloat(bytes, offset + 8) };
}

std::uint8_t flags(bool first, bool second, bool third = false) noexcept
{
  return static_cast<std::uint8_t>((first ? 1 : 0) | (second ? 2 : 0) | (third ? 4 : 0));
}

constexpr std::size_t OrientationOffset = 48;
constexpr std::size_t TorqueOffset = 36;
constexpr std::size_t TorqueLimitsOffset = 44;
constexpr std::size_t ShortName = 3; ///< number of bytes of the name if the torque limits follow

/// Returns the offset of component `i` of the quaternion w, x, y, z. The component with the index
/// `largest` is omitted from the report.
std::size_t placeOf(int i, int largest) noexcept
{
  return OrientationOffset + 4 * static_cast<std::size_t>(i < largest ? i : i - 1);
}

/// Writes the three smaller components of the quaternion. The largest component is made positive
/// and can be computed from the others.
void putOrientation(HapticReportBytes& bytes, const ToolOrientation& orientation) noexcept
{
  const Eigen::Vector4d wxyz(orientation.w(), orientation.x(), orientation.y(), orientation.z());
  int largest = 0;
  wxyz.cwiseAbs().maxCoeff(&largest);
  const double sign = wxyz[largest] < 0.0 ? -1.0 : 1.0;
  bytes[3] = static_cast<std::uint8_t>(bytes[3] | 4 | largest << 3);
  for (int i = 0; i < 4; ++i)
  {
    if (i != largest)
    {
      putFloat(bytes, placeOf(i, largest), sign * wxyz[i]);
    }
  }
}

/// Reads the quaternion. Returns false if the bytes are invalid, which means that the omitted
/// component would not be the largest one.
bool getOrientation(const std::uint8_t* bytes, ToolOrientation& orientation) noexcept
{
  constexpr double Rounding = 1e-3; // tolerance for devices that compute inexactly
  const int largest = bytes[3] >> 3 & 3;
  Eigen::Vector4d wxyz = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i)
  {
    wxyz[i] = i != largest ? getFloat(bytes, placeOf(i, largest)) : 0.0;
  }
  const double square = wxyz.squaredNorm();
  if (!(square <= 0.75 + Rounding)) // the condition is true for NaN, so that NaN is rejected
  {
    return false;
  }
  wxyz[largest] = std::sqrt(1.0 - square);
  orientation = ToolOrientation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  return true;
}

void begin(HapticReportBytes& bytes, ReportKind kind, std::uint8_t flagByte) noexcept
{
  bytes.fill(0);
  bytes[0] = HapticReportMark;
  bytes[1] = static_cast<std::uint8_t>(kind);
  bytes[2] = HapticReportVersion;
  bytes[3] = flagByte;
}

void finish(HapticReportBytes& bytes) noexcept
{
  put32(bytes, CheckSumOffset, reportCheckSum(bytes.data(), CheckSumOffset));
}

ReportDefect checkKind(const std::uint8_t* bytes, std::size_t size, ReportKind kind) noexcept
{
  const ReportDefect defect = checkReport(bytes, size);
  if (defect != ReportDefect::None)
  {
    return defect;
  }
  return bytes[1] == static_cast<std::uint8_t>(kind) ? ReportDefect::None : ReportDefect::Kind;
}
} // namespace

const char* inWords(ReportDefect defect) noexcept
{
  switch (defect)
  {
    case ReportDefect::None:
      return "sound";
    case ReportDefect::Size:
      return "not 64 bytes";
    case ReportDefect::Mark:
      return "does not begin with 'P'";
    case ReportDefect::Version:
      return "another version of the protocol";
    case ReportDefect::CheckSum:
      return "wrong check sum";
    case ReportDefect::Kind:
      return "another kind of report";
    case ReportDefect::Content:
      return "a number that is not finite, or an orientation that is not a rotation";
  }
  return "unknown";
}

std::uint32_t reportCheckSum(const std::uint8_t* bytes, std::size_t size) noexcept
{
  std::uint32_t remainder = 0xFFFFFFFFU;
  for (std::size_t i = 0; i < size; ++i)
  {
    remainder = (remainder >> 8) ^ CheckSumTable[(remainder ^ bytes[i]) & 0xFFU];
  }
  return ~remainder;
}

ReportDefect checkReport(const std::uint8_t* bytes, std::size_t size) noexcept
{
  if (size != HapticReportSize)
  {
    return ReportDefect::Size;
  }
  if (bytes[0] != HapticReportMark)
  {
    return ReportDefect::Mark;
  }
  if (bytes[2] != HapticReportVersion)
  {
    return ReportDefect::Version;
  }
  return get32(bytes, CheckSumOffset) == reportCheckSum(bytes, CheckSumOffset)
    ? ReportDefect::None
    : ReportDefect::CheckSum;
}

void pack(const StateReport& report, HapticReportBytes& bytes) noexcept
{
  begin(bytes, ReportKind::State, flags(report.amplifiersOn, report.fault));
  put32(bytes, 4, report.sequence);
  put64(bytes, 8, report.time);
  putVector(bytes, 16, report.position);
  putVector(bytes, 28, report.velocity);
  put32(bytes, 40, report.buttons);
  put32(bytes, 44, report.forceSequence);
  if (isTold(report.orientation))
  {
    putOrientation(bytes, report.orientation);
  }
  finish(bytes);
}

ReportDefect parse(const std::uint8_t* bytes, std::size_t size, StateReport& report) noexcept
{
  const ReportDefect defect = checkKind(bytes, size, ReportKind::State);
  if (defect != ReportDefect::None)
  {
    return defect;
  }
  const Eigen::Vector3d position = getVector(bytes, 16);
  const Eigen::Vector3d velocity = getVector(bytes, 28);
  ToolOrientation orientation = orientationNotTold();
  const bool isTurned = (bytes[3] & 4) != 0;
  if (!position.allFinite() || !velocity.allFinite() ||
    (isTurned && !getOrientation(bytes, orientation)))
  {
    return ReportDefect::Content;
  }
  report.orientation = orientation;
  report.amplifiersOn = (bytes[3] & 1) != 0;
  report.fault = (bytes[3] & 2) != 0;
  report.sequence = get32(bytes, 4);
  report.time = get64(bytes, 8);
  report.position = position;
  report.velocity = velocity;
  report.buttons = get32(bytes, 40);
  report.forceSequence = get32(bytes, 44);
  return ReportDefect::None;
}

std::uint32_t watchdogOf(double seconds, const DeviceSpecification& specification) noexcept
{
  const double longest = specification.sampleTimeOut;
  const double held = seconds >= 0.0 && seconds < longest ? seconds : longest;
  return static_cast<std::uint32_t>(std::lround(1e6 * std::clamp(held, 0.0, 1.0)));
}

void pack(const ForceReport& report, HapticReportBytes& bytes) noexcept
{
  begin(bytes, ReportKind::Force, flags(report.enable, false));
  put32(bytes, 4, report.sequence);
  put64(bytes, 8, report.time);
  putVector(bytes, 16, report.force);
  put32(bytes, 28, report.watchdog);
  put32(bytes, 32, report.stateSequence);
  putVector(bytes, TorqueOffset, report.torque);
  finish(bytes);
}

ReportDefect parse(const std::uint8_t* bytes, std::size_t size, ForceReport& report) noexcept
{
  const ReportDefect defect = checkKind(bytes, size, ReportKind::Force);
  if (defect != ReportDefect::None)
  {
    return defect;
  }
  const Eigen::Vector3d force = getVector(bytes, 16);
  const Eigen::Vector3d torque = getVector(bytes, TorqueOffset);
  if (!force.allFinite() || !torque.allFinite())
  {
    return ReportDefect::Content;
  }
  report.torque = torque;
  report.enable = (bytes[3] & 1) != 0;
  report.sequence = get32(bytes, 4);
  report.time = get64(bytes, 8);
  report.force = force;
  report.watchdog = get32(bytes, 28);
  report.stateSequence = get32(bytes, 32);
  return ReportDefect::None;
}

void pack(const DescriptionReport& report, HapticReportBytes& bytes) noexcept
{
  begin(bytes, ReportKind::Description,
    flags(report.outputsForce, report.planar, report.outputsTorque));
  putFloat(bytes, 4, report.maximumForce);
  putFloat(bytes, 8, report.maximumStiffness);
  putFloat(bytes, 12, report.maximumForceRate);
  putFloat(bytes, 16, report.maximumDamping);
  putVector(bytes, 20, report.workspace);
  putFloat(bytes, 32, report.rate);
  putFloat(bytes, 36, report.sampleTimeOut);
  const auto last = report.outputsTorque ? report.name.begin() + ShortName : report.name.end() - 1;
  const auto end = std::find(report.name.begin(), last, '\0');
  std::copy(report.name.begin(), end, bytes.begin() + 40);
  put32(bytes, 56, report.nonce);
  if (report.outputsTorque)
  {
    putFloat(bytes, TorqueLimitsOffset, report.maximumTorque);
    putFloat(bytes, TorqueLimitsOffset + 4, report.maximumTorsionalStiffness);
    putFloat(bytes, TorqueLimitsOffset + 8, report.maximumTorqueRate);
  }
  finish(bytes);
}

ReportDefect parse(const std::uint8_t* bytes, std::size_t size, DescriptionReport& report) noexcept
{
  const ReportDefect defect = checkKind(bytes, size, ReportKind::Description);
  if (defect != ReportDefect::None)
  {
    return defect;
  }
  report.outputsForce = (bytes[3] & 1) != 0;
  report.planar = (bytes[3] & 2) != 0;
  report.maximumForce = getFloat(bytes, 4);
  report.maximumStiffness = getFloat(bytes, 8);
  report.maximumForceRate = getFloat(bytes, 12);
  report.maximumDamping = getFloat(bytes, 16);
  report.workspace = getVector(bytes, 20);
  report.rate = getFloat(bytes, 32);
  report.sampleTimeOut = getFloat(bytes, 36);
  report.outputsTorque = (bytes[3] & 4) != 0;
  report.maximumTorque = report.outputsTorque ? getFloat(bytes, TorqueLimitsOffset) : 0.0;
  report.maximumTorsionalStiffness =
    report.outputsTorque ? getFloat(bytes, TorqueLimitsOffset + 4) : 0.0;
  report.maximumTorqueRate = report.outputsTorque ? getFloat(bytes, TorqueLimitsOffset + 8) : 0.0;
  report.name.fill('\0');
  std::copy_n(
    bytes + 40, report.outputsTorque ? ShortName : report.name.size() - 1, report.name.begin());
  report.nonce = get32(bytes, 56);
  return ReportDefect::None;
}

void pack(const HelloReport& report, HapticReportBytes& bytes) noexcept
{
  begin(bytes, ReportKind::Hello, 0);
  put32(bytes, 4, report.nonce);
  finish(bytes);
}

ReportDefect parse(const std::uint8_t* bytes, std::size_t size, HelloReport& report) noexcept
{
  const ReportDefect defect = checkKind(bytes, size, ReportKind::Hello);
  if (defect == ReportDefect::None)
  {
    report.nonce = get32(bytes, 4);
  }
  return defect;
}
} // namespace palpate
