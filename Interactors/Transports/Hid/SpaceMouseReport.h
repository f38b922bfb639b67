// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SpaceMouseReport_h
#define palpate_SpaceMouseReport_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace palpate
{
/**
 * Displacement and rotation of the cap of a 3Dconnexion mouse, and its buttons.
 *
 * Axes: x to the right, y up, z towards the user. (The axes of the reports are right, towards the
 * user, down.) 1 is full deflection: 350 counts; worn devices reach slightly more.
 */
struct SpaceMouseState
{
  Eigen::Vector3d push = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(); ///< about the axes, right-handed
  std::uint32_t buttons = 0;
};

/**
 * Reads one report into the state. Numbers are signed 16 bit, little-endian.
 *
 * | first byte | bytes | layout |
 * |---|---|---|
 * | 1 | 7 | x, y, z (classic: SpaceNavigator, SpaceMouse Pro, …) |
 * | 2 | 7 | rotation about x, y, z (classic) |
 * | 1 | 13 or more | all six in one (wireless and newer) |
 * | 3 | 2 or more | one bit per button, up to 32 |
 *
 * Returns false, and changes nothing, if the report has another length. Reports with another first
 * byte (battery, display, …) are ignored.
 */
PALPATE_EXPORT bool takeSpaceMouseReport(
  const std::uint8_t* report, std::size_t size, SpaceMouseState& state) noexcept;
} // namespace palpate

#endif
