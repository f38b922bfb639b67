// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_PulledPlug_h
#define palpate_testing_PulledPlug_h

#include "Contact/ContactBody.h"

#include <chrono>
#include <memory>
#include <string>

namespace palpate::testing
{
/// The moment at which the plug is pulled.
struct PullMoment
{
  double phase = 0.0;               ///< s; phase of press() when the device is plugged in
  std::chrono::microseconds wait{}; ///< time since the first force of the plate
};

/// Result of a pulled plug.
struct PulledPlug
{
  std::string fault;   ///< "" if there is none
  double motors = 0.0; ///< force on the hand at that moment, N
  double wall =
    0.0; ///< from the pull to the end of the first tick after the report of the loss, ms
};

/**
 * Plugs in a force device, opens it by hidapi, presses it on the plate, and pulls the plug from
 * another thread. Faults are: a force in the first tick that begins after the device has reported
 * its loss, or in the twenty ticks after it; a device that is not opened, gives no force, or does
 * not report its loss within PatientTicks; a device that reports itself as connected afterwards.
 */
PulledPlug pullPlug(const std::shared_ptr<const ContactBody>& plate, const PullMoment& moment);
} // namespace palpate::testing

#endif
