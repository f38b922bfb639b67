// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Hid/SpaceMouseReport.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double FullDeflection = 350.0; ///< full deflection, in counts of the device

double axis(const std::uint8_t* bytes) noexcept
{
  const auto bits = static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
  return static_cast<std::int16_t>(bits) / FullDeflection;
}

/// Converts the axes of a report (right, towards the user, down) to the axes of SpaceMouseState
/// (right, up, towards the user).
Eigen::Vector3d axes(const std::uint8_t* bytes) noexcept
{
  return { axis(bytes), -axis(bytes + 4), axis(bytes + 2) };
}
} // namespace

bool takeSpaceMouseReport(
  const std::uint8_t* report, std::size_t size, SpaceMouseState& state) noexcept
{
  if (size < 2)
  {
    return false;
  }
  switch (report[0])
  {
    case 1:
      if (size != 7 && size < 13)
      {
        return false;
      }
      state.push = axes(report + 1);
      if (size >= 13)
      {
        state.turn = axes(report + 7);
      }
      return true;
    case 2:
      if (size != 7)
      {
        return false;
      }
      state.turn = axes(report + 1);
      return true;
    case 3:
      state.buttons = 0;
      for (std::size_t i = 0; i < std::min<std::size_t>(size - 1, 4); ++i)
      {
        state.buttons |= static_cast<std::uint32_t>(report[1 + i]) << (8 * i);
      }
      return true;
    default:
      return true;
  }
}
} // namespace palpate
