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
 * The axes are x to the right, y up and z towards the user; those of the reports are right, towards
 * the user and down. The value 1 is full deflection, which is 350 counts. Worn devices reach
 * slightly more.
 */
struct SpaceMouseState
{
  Eigen::Vector3d push = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(); ///< rotation about the axes, right-handed
  std::uint32_t buttons = 0;
};

/**
 * Reads one report into the state. Numbers are little-endian, signed and have 16 bits.
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
