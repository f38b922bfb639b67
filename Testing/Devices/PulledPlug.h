// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_PulledPlug_h
#define palpate_testing_PulledPlug_h

#include "Contact/ContactBody.h"

#include <chrono>
#include <memory>
#include <string>

namespace palpate::testing
{
/// The moment at which the device is unplugged.
struct PullMoment
{
  double phase = 0.0;               ///< phase of press() when the device is plugged in, s
  std::chrono::microseconds wait{}; ///< time since the first force of the plate
};

/// Result of unplugging a device once.
struct PulledPlug
{
  std::string fault;   ///< "" if there is none
  double motors = 0.0; ///< force of the motors when the device is unplugged, N
  double wall =
    0.0; ///< from the pull to the end of the first tick after the report of the loss, ms
};

/**
 * Plugs in a force device, opens it by hidapi, presses it on the plate, and unplugs it in another
 * thread. Faults are:
 * - a force in the first tick that begins after the device has reported its loss, or in the next
 * twenty ticks;
 * - a device that cannot be opened, exerts no force, or does not report its loss within
 * PatientTicks;
 * - a device that reports itself as connected afterwards.
 */
PulledPlug pullPlug(const std::shared_ptr<const ContactBody>& plate, const PullMoment& moment);
} // namespace palpate::testing

#endif
