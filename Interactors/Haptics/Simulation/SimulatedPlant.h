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
 * The mechanics and electronics of a simulated device. SI units; each axis by itself:
 *
 *   m dv/dt = F + hand - b v - f_c sign v
 *
 * F is the force last written, held until the next (zero-order hold). Where v = 0, friction holds
 * against up to f_c. Both delays may be any fraction of a tick; a loop feels their sum.
 *
 * With an inertia it outputs torque and turns: with r the rotation vector from the tool's frame to
 * the device's, each of its components likewise by itself, I d²r/dt² = M + hand - b_θ dr/dt. That
 * is how a body turns while |r| is small, as tilts are.
 */
struct SimulatedPlant
{
  double mass = 0.1;         ///< m, apparent, kg; at least 1e-6
  double damping = 1.0;      ///< b, viscous, N s/m
  double friction = 0.0;     ///< f_c, Coulomb's, N, of each axis
  double encoderStep = 0.0;  ///< positions read are whole multiples of it, m; 0: not rounded
  double forceDelay = 0.0;   ///< a force acts so long after the tick that wrote it, s; at most 1
  double sampleDelay = 0.0;  ///< a reading is so old, s; at most 1
  double inertia = 0.0;      ///< I, kg m²; 0: it has no torque, and is turned as the hand means
  double turnDamping = 1e-3; ///< b_θ, N m s/rad
};

/**
 * A hand on the device: a spring and a damper between the device and where the hand means to be
 * (x_t), no stronger on each axis than a muscle is:
 *
 *   hand = k (x_t - x) + b (v_t - v), kept within ± the maximum force
 *
 * The defaults are of the order of a relaxed grip.
 */
struct HandModel
{
  double stiffness = 300.0; ///< k, N/m; with damping 0 as well: nobody holds the device
  double damping = 5.0;     ///< b, N s/m
  double maximumForce = std::numeric_limits<double>::infinity(); ///< N, on each axis
  double turnStiffness = 0.5;    ///< of turns, N m/rad, towards the axis that it means
  double turnHandDamping = 5e-3; ///< N m s/rad
};

/// A device and the hand that holds it.
struct HeldPlant
{
  SimulatedPlant plant;
  HandModel hand;
};

/// What is wrong, naming the setting, its range and its value; or "".
PALPATE_EXPORT std::string fault(HeldPlant held);

/**
 * Reads "mass=0.1,damping=1,stiffness=300", each as often as once, in any order; what is not named
 * has its default, with "" all. Returns what is wrong, and leaves `held` as it was, or "".
 *
 * | name           | of                           | unit  | range       | default |
 * |----------------|------------------------------|-------|-------------|---------|
 * | `mass`         | device, apparent             | kg    | 1e-6 to 1e9 | 0.1     |
 * | `damping`      | device, viscous              | N s/m | 0 to 1e9    | 1       |
 * | `friction`     | device, Coulomb's            | N     | 0 to 1e9    | 0       |
 * | `encoder-step` | device                       | m     | 0 to 1e9    | 0       |
 * | `force-delay`  | device                       | s     | 0 to 1      | 0       |
 * | `sample-delay` | device                       | s     | 0 to 1      | 0       |
 * | `stiffness`    | hand, towards where it means | N/m   | 0 to 1e9    | 300     |
 * | `hand-damping` | hand                         | N s/m | 0 to 1e9    | 5       |
 * | `hand-force`   | hand, the most               | N     | from 0      | endless |
 * | `inertia`      | device; 0: it has no torque  | kg m² | 0 to 1e9    | 0       |
 *
 * and of turns, per rad:
 *
 * | name                | of                              | unit  | range    | default |
 * |---------------------|---------------------------------|-------|----------|---------|
 * | `turn-damping`      | device                          | N m s | 0 to 1e9 | 0.001   |
 * | `turn-stiffness`    | hand, towards the axis it means | N m   | 0 to 1e9 | 0.5     |
 * | `turn-hand-damping` | hand                            | N m s | 0 to 1e9 | 0.005   |
 */
PALPATE_EXPORT std::string readPlant(std::string_view text, HeldPlant& held);

/**
 * What the maker of such a device would state for ticks at `rate` (Hz), not knowing who holds it:
 * 10 N; the stiffest spring that a sampled loop renders passively, b/(T/2 + delays) (Colgate and
 * Schenkel 1997; stability with delays: Diolaiti et al. 2006), N/m; and a damper of b. With an
 * inertia 0.5 N m too, and likewise the stiffest torsion spring, of b_θ, N m/rad.
 */
PALPATE_EXPORT DeviceSpecification specificationOf(const SimulatedPlant& plant, double rate);
} // namespace palpate

#endif
