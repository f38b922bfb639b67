// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary 64 bytes from a device. The report is rejected, or complete and finite. Input: a choice
// (bit 0: correct mark, version and checksum, so that the content is reached), and a report.
#include "Transports/Hid/HapticReport.h"
#include "Require.h"
#include "Transports/Hid/SpaceMouseReport.h"

#include <cmath>
#include <limits>
#include <vector>

using namespace palpate;
using palpate::testing::require;

namespace
{
/// Removes the orientation, because packing may change it.
void forgetTurn(StateReport& report)
{
  // If two components are equal to rounding, either of them may be omitted.
  report.orientation = orientationNotTold();
}

template <class Report>
void forgetTurn(Report&)
{
}

/// Checks that a parsed report has the same bytes when it is packed again.
template <class Report>
void parseAndPack(const std::uint8_t* bytes, std::size_t size)
{
  Report report;
  if (parse(bytes, size, report) != ReportDefect::None)
  {
    return;
  }
  HapticReportBytes first{};
  HapticReportBytes second{};
  forgetTurn(report);
  pack(report, first);
  Report again;
  require(parse(first.data(), first.size(), again) == ReportDefect::None, "what was parsed packs");
  pack(again, second);
  require(first == second, "packing is the inverse of parsing");
}

void checkState(const std::uint8_t* bytes, std::size_t size)
{
  StateReport state;
  if (parse(bytes, size, state) == ReportDefect::None)
  {
    require(state.position.allFinite() && state.velocity.allFinite(), "a state is finite");
    if (isTold(state.orientation))
    {
      HapticReportBytes packed{};
      StateReport again;
      pack(state, packed);
      require(std::abs(state.orientation.norm() - 1.0) < 1e-12, "an orientation is unit");
      require(parse(packed.data(), packed.size(), again) == ReportDefect::None &&
          turnBetween(state.orientation, again.orientation).norm() < 1e-5,
        "an orientation comes back");
    }
  }
}

void checkDescription(const std::uint8_t* bytes, std::size_t size)
{
  DescriptionReport description;
  if (parse(bytes, size, description) != ReportDefect::None)
  {
    return;
  }
  std::string replaced;
  const DeviceSpecification limits = specificationOf(description, &replaced);
  require(limits.outputsForce ? limits.maximumForce > 0.0 && limits.maximumForce <= 100.0
                              : limits.maximumForce == 0.0,
    "a credible force");
  require(
    limits.maximumStiffness > 0.0 && limits.maximumStiffness <= 20000.0, "a credible stiffness");
  require(limits.maximumForceRate > 0.0, "a credible force rate");
  require(limits.maximumDamping > 0.0 && limits.maximumDamping <= 200.0, "a credible damping");
  const double least = std::numeric_limits<double>::min();
  require((limits.workspace.array() <= 2.0).all() && limits.workspace.x() >= least &&
      limits.workspace.y() >= least && limits.workspace.z() >= (description.planar ? 0.0 : least),
    "a credible workspace");
  require(limits.outputsTorque ? limits.maximumTorque > 0.0 && limits.maximumTorque <= 5.0
                               : limits.maximumTorque == 0.0,
    "a credible torque");
  require(limits.maximumTorsionalStiffness > 0.0 && limits.maximumTorsionalStiffness <= 100.0 &&
      limits.maximumTorqueRate > 0.0,
    "a credible torsional stiffness");
  require(limits.rate >= 10.0 && limits.rate <= 20000.0, "a credible rate");
  require(limits.sampleTimeOut > 0.0 && limits.sampleTimeOut <= 0.1, "a credible time-out");
  require(description.name.back() == '\0', "a name ends");
}

void checkSpaceMouse(const std::uint8_t* bytes, std::size_t size)
{
  SpaceMouseState state;
  takeSpaceMouseReport(bytes, size, state);
  constexpr double largest = 32768.0 / 350.0;
  require(
    (state.push.array().abs() <= largest).all() && (state.turn.array().abs() <= largest).all(),
    "a push is within 16 bits");
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  // A copy of exactly this size lets the address sanitizer detect a read beyond its end.
  std::vector<std::uint8_t> bytes(data + 1, data + size);
  if ((data[0] & 1U) != 0 && bytes.size() >= HapticReportSize)
  {
    bytes.resize(HapticReportSize);
    bytes[0] = HapticReportMark;
    bytes[1] = static_cast<std::uint8_t>(1 + (data[0] >> 1U) % 4);
    bytes[2] = HapticReportVersion;
    const std::uint32_t sum = reportCheckSum(bytes.data(), HapticReportSize - 4);
    for (std::size_t i = 0; i < 4; ++i)
    {
      bytes[HapticReportSize - 4 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
    }
    require(
      checkReport(bytes.data(), bytes.size()) == ReportDefect::None, "a mended report is sound");
  }
  checkState(bytes.data(), bytes.size());
  checkDescription(bytes.data(), bytes.size());
  checkSpaceMouse(bytes.data(), bytes.size());
  parseAndPack<StateReport>(bytes.data(), bytes.size());
  parseAndPack<ForceReport>(bytes.data(), bytes.size());
  parseAndPack<DescriptionReport>(bytes.data(), bytes.size());
  parseAndPack<HelloReport>(bytes.data(), bytes.size());
  return 0;
}
