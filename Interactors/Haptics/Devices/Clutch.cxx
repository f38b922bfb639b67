// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/Clutch.h"

namespace palpate
{
Eigen::Vector3d Clutch::follow(
  const Eigen::Vector3d& hand, std::uint32_t buttons, double elapsed) noexcept
{
  if (this->Held) // up to this tick, however far the hand has come since the last
  {
    this->Offset = this->Tip - hand;
    this->Moved = true;
  }
  else
  {
    this->Tip = this->Moved ? Eigen::Vector3d(hand + this->Offset) : hand;
  }
  this->Held = (buttons & this->Buttons) != 0;
  this->Force.advance(this->Held ? 0.0 : 1.0, elapsed);
  return this->Tip;
}
} // namespace palpate
