// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_PulledPlug_h
#define palpate_testing_PulledPlug_h

#include "Contact/ContactBody.h"

#include <chrono>
#include <memory>
#include <string>

namespace palpate::testing
{
/// When the plug is pulled.
struct PullMoment
{
  double phase = 0.0;               ///< s, of press() when the device is plugged in
  std::chrono::microseconds wait{}; ///< since the plate was first felt
};

/// What came of it.
struct PulledPlug
{
  std::string fault;   ///< what must not be; "" if nothing
  double motors = 0.0; ///< force in the hand at that moment, N
  double wall = 0.0;   ///< from the pull to the end of the first tick after its report, ms
};

/**
 * Plugs a force device in, opens it by hidapi, presses it on the plate, and pulls the plug in
 * another thread. A fault: any force in the first tick that begins after the device has reported
 * its loss, or in the twenty that follow; a device that is not opened, not felt, or whose loss is
 * not reported within PatientTicks; one that calls itself connected afterwards.
 */
PulledPlug pullPlug(const std::shared_ptr<const ContactBody>& plate, const PullMoment& moment);
} // namespace palpate::testing

#endif
