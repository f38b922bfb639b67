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
 * The mechanics and electronics of a simulated device. SI units; each axis is independent:
 *
 *   m dv/dt = F + hand - b v - f_c sign v
 *
 * F is the last written force, constant until the next one (zero-order hold). At v = 0, static
 * friction balances a force of up to f_c. Both delays may be any fraction of a tick; a loop is
 * affected by their sum.
 *
 * With an inertia the device outputs torque and turns: each component of r, the rotation vector
 * from the tool's frame to the device's, obeys I d²r/dt² = M + hand - b_θ dr/dt. This is valid for
 * small |r|, as for tilts.
 */
struct SimulatedPlant
{
  double mass = 0.1;         ///< m, apparent, kg; at least 1e-6
  double damping = 1.0;      ///< b, viscous, N s/m
  double friction = 0.0;     ///< f_c, Coulomb's, N, of each axis
  double encoderStep = 0.0;  ///< m; readings are multiples of this step; 0: not rounded
  double forceDelay = 0.0;   ///< time from the tick that writes a force until it acts, s; at most 1
  double sampleDelay = 0.0;  ///< age of a reading, s; at most 1
  double inertia = 0.0;      ///< I, kg m²; 0: no torque; the orientation is the hand's target
  double turnDamping = 1e-3; ///< b_θ, N m s/rad
};

/**
 * A hand on the device: a spring and a damper between the device and the hand's target x_t, with a
 * limited force on each axis:
 *
 * hand = k (x_t - x) + b (v_t - v), limited to ± the maximum force
 *
 * The defaults have the order of magnitude of a relaxed grip.
 */
struct HandModel
{
  double stiffness = 300.0; ///< k, N/m; if damping is 0 as well, there is no hand
  double damping = 5.0;     ///< b, N s/m
  double maximumForce = std::numeric_limits<double>::infinity(); ///< N, on each axis
  double turnStiffness = 0.5;    ///< rotational, N m/rad, towards the hand's target
  double turnHandDamping = 5e-3; ///< N m s/rad
};

/// A device and the hand that holds it.
struct HeldPlant
{
  SimulatedPlant plant;
  HandModel hand;
};

/// The fault of the first setting that is out of its range, with its name, range and value; or "".
PALPATE_EXPORT std::string fault(HeldPlant held);

/**
 * Reads "mass=0.1,damping=1,stiffness=300": each name at most once, in any order; other settings
 * have their defaults. Returns "", or the fault; `held` is then unchanged.
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
 * and for rotations, per rad:
 *
 * | name                | of                              | unit  | range    | default |
 * |---------------------|---------------------------------|-------|----------|---------|
 * | `turn-damping`      | device                          | N m s | 0 to 1e9 | 0.001   |
 * | `turn-stiffness`    | hand, towards its target axis   | N m   | 0 to 1e9 | 0.5     |
 * | `turn-hand-damping` | hand                            | N m s | 0 to 1e9 | 0.005   |
 */
PALPATE_EXPORT std::string readPlant(std::string_view text, HeldPlant& held);

/**
 * The specification of such a device for ticks at `rate` (Hz) and any hand: 10 N; the stiffness
 * b/(T + 2t) in N/m, where t is the sum of the delays; and a damper of b. This stiffness is half
 * that of the stiffest spring which a sampled loop renders passively, b/(T/2 + t) (Colgate and
 * Schenkel 1997; stability with delays: Diolaiti et al. 2006). With an inertia also 0.5 N m and the
 * corresponding torsional stiffness, with b_θ, in N m/rad.
 */
PALPATE_EXPORT DeviceSpecification specificationOf(const SimulatedPlant& plant, double rate);
} // namespace palpate

#endif
