// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SimulatedPlant_h
#define palpate_SimulatedPlant_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <limits>
#include <string>
#include <string_view>

namespace palpate
{
/**
 * The mechanics and electronics of a simulated device, in SI units. Each axis obeys independently
 *
 *   m dv/dt = F + hand - b v - f_c sign v
 *
 * F is the last written force, which is constant until the next one (zero-order hold). At v = 0,
 * static friction balances a force of up to f_c. Both delays may be any fraction of a tick. A loop
 * is affected by the sum of the delays.
 *
 * With an inertia, the device outputs torque and turns. Let r be the rotation vector from the
 * tool's frame to the device frame. Each component of r obeys
 *   I d²r/dt² = M + hand - b_θ dr/dt.
 * This equation is valid for small |r|, such as tilts.
 */
struct SimulatedPlant
{
  double mass = 0.1;     ///< apparent mass m, kg; at least 1e-6
  double damping = 1.0;  ///< viscous damping b, N s/m
  double friction = 0.0; ///< Coulomb friction f_c of each axis, N
  /// Step of the encoders, m; readings are multiples of it. 0 for readings without rounding.
  double encoderStep = 0.0;
  /// Time between the tick that writes a force and the start of the force, s; at most 1.
  double forceDelay = 0.0;
  double sampleDelay = 0.0; ///< age of a reading, s; at most 1
  double inertia = 0.0; ///< moment of inertia I, kg m²; if 0, the device outputs no torque and has
                        ///< the hand's target orientation
  double turnDamping = 1e-3; ///< rotational damping b_θ, N m s/rad
};

/**
 * A hand on the device, modelled as a spring and a damper between the device and the hand's target
 * x_t. On each axis the force is
 *
 *   hand = k (x_t - x) + b (v_t - v), limited to ± the maximum force.
 *
 * The defaults have the order of magnitude of a relaxed grip.
 */
struct HandModel
{
  double stiffness = 300.0; ///< stiffness k, N/m; if stiffness and damping are 0, there is no hand
  double damping = 5.0;     ///< damping b, N s/m
  double maximumForce = std::numeric_limits<double>::infinity(); ///< largest force on each axis, N
  /// Rotational stiffness towards the hand's target orientation, N m/rad.
  double turnStiffness = 0.5;
  double turnHandDamping = 5e-3; ///< rotational damping, N m s/rad
};

/// A device and the hand that holds it.
struct HeldPlant
{
  SimulatedPlant plant;
  HandModel hand;
};

/// Describes the first setting that is out of its range, with its name, range and value. Returns ""
/// if there is none.
PALPATE_EXPORT std::string fault(HeldPlant held);

/**
 * Reads a text such as "mass=0.1,damping=1,stiffness=300". Each name may occur once, in any order;
 * the other settings get their defaults. Returns "" on success. Otherwise returns the fault and
 * leaves `held` unchanged.
 *
 * | name           | of                           | unit  | range       | default |
 * |----------------|------------------------------|-------|-------------|---------|
 * | `mass`         | device, apparent             | kg    | 1e-6 to 1e9 | 0.1     |
 * | `damping`      | device, viscous              | N s/m | 0 to 1e9    | 1       |
 * | `friction`     | device, Coulomb's            | N     | 0 to 1e9    | 0       |
 * | `encoder-step` | device                       | m     | 0 to 1e9    | 0       |
 * | `force-delay`  | device                       | s     | 0 to 1      | 0       |
 * | `sample-delay` | device                       | s     | 0 to 1      | 0       |
 * | `stiffness`    | hand, towards its target     | N/m   | 0 to 1e9    | 300     |
 * | `hand-damping` | hand                         | N s/m | 0 to 1e9    | 5       |
 * | `hand-force`   | hand, maximum                | N     | from 0      | no max. |
 * | `inertia`      | device; 0: no torque         | kg m² | 0 to 1e9    | 0       |
 *
 * The settings for rotations are per rad:
 *
 * | name                | of                              | unit  | range    | default |
 * |---------------------|---------------------------------|-------|----------|---------|
 * | `turn-damping`      | device                          | N m s | 0 to 1e9 | 0.001   |
 * | `turn-stiffness`    | hand, towards its target axis   | N m   | 0 to 1e9 | 0.5     |
 * | `turn-hand-damping` | hand                            | N m s | 0 to 1e9 | 0.005   |
 */
PALPATE_EXPORT std::string readPlant(std::string_view text, HeldPlant& held);

/**
 * Returns the specification of a simulated device for ticks at `rate` (Hz) and any hand. The
 * maximum force is 10 N, the maximum stiffness b/(T + 2t) in N/m, and the maximum damping b, where
 * t is the sum of the delays. This stiffness is half the stiffness b/(T/2 + t) of the stiffest
 * spring that a sampled loop renders passively (Colgate and Schenkel 1997; for stability with
 * delays see Diolaiti et al. 2006). With an inertia, the maximum torque is 0.5 N m, and the maximum
 * torsional stiffness is computed from b_θ in the same way, N m/rad.
 */
PALPATE_EXPORT DeviceSpecification specificationOf(const SimulatedPlant& plant, double rate);
} // namespace palpate

#endif
