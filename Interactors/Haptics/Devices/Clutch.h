// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Clutch_h
#define palpate_Clutch_h

#include "Haptics/Safety/SafetyLinks.h"

#include <Eigen/Core>

#include <cstdint>

namespace palpate
{
/**
 * Takes the hand off the tip, so that a small workspace reaches a large body: while one of its
 * buttons is held the tip stays and the hand moves freely; on release the tip follows again from
 * where it stood, moved by as much as the hand was.
 *
 * The force fades to nothing within 50 ms of pressing the button and comes back within 50 ms of
 * its release (ForceRamp), in or out of contact: neither tip nor force jumps. A gate that is shut
 * stays shut, as the tip has not left the body by it.
 *
 * Positions are the tip's, in the body's frame, mm. No heap; nothing throws.
 */
class Clutch
{
public:
  /// `buttons`: any of these bits of DeviceSample::buttons holds it; 0: there is no clutch.
  explicit Clutch(std::uint32_t buttons = 0) noexcept
    : Buttons(buttons)
  {
  }

  /// Where the tip is, when the mapping puts the hand at `hand`, finite; `elapsed` (s) since the
  /// last tick.
  Eigen::Vector3d follow(
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

  bool isHeld() const noexcept { return this->Held; }
  /// Of the force, for the hand: 1 while the tip follows it, 0 while it moves freely.
  double forceShare() const noexcept { return this->Force.share(); }

  /// The tip is where the mapping puts it, as at the beginning.
  void reset() noexcept { *this = Clutch(this->Buttons); }

private:
  std::uint32_t Buttons;
  bool Held = false;
  bool Moved = false; ///< Offset is not zero: adding zero would turn -0 into +0
  Eigen::Vector3d Tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d Offset = Eigen::Vector3d::Zero(); ///< tip minus hand
  ForceRamp Force{ 1.0 };
};
} // namespace palpate

#endif
