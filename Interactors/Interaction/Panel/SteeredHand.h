// SPDX-License-Identifier: BSD-3-Clause
#ifndef SteeredHand_h
#define SteeredHand_h

#include "Interaction/Panel/SteeredTilt.h"

namespace palpate
{
/// How a hand that a mouse steers was left: what stays when the mouse takes another.
struct SteeredHand
{
  SteeredTilt tilt;
  double wheelDepth = 0.0;           ///< mm
  double tip[3] = { 0.0, 0.0, 0.0 }; ///< where it was steered to, mm
};
} // namespace palpate

#endif
