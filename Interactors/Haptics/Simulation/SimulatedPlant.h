// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SimulatedPlant_h
#define palpate_SimulatedPlant_h

#include "Mechanics/PalpateExport.h"

#include <limits>
#include <string>

namespace palpate
{
/**
 * The mechanics and electronics of a simulated device. SI units; each axis by itself:
 *
 *   m dv/dt = F + hand - b v - f_c sign v
 *
 * F is the force last written, held until the next (zero-order hold). Where v = 0, friction holds
 * against up to f_c. Both delays may be any fraction of a tick; a loop feels their sum.
 */
struct SimulatedPlant
{
  double mass = 0.1;        ///< m, apparent, kg; at least 1e-6
  double damping = 1.0;     ///< b, viscous, N s/m
  double friction = 0.0;    ///< f_c, Coulomb's, N, of each axis
  double encoderStep = 0.0; ///< positions read are whole multiples of it, m; 0: not rounded
  double forceDelay = 0.0;  ///< a force acts so long after the tick that wrote it, s; at most 1
  double sampleDelay = 0.0; ///< a reading is so old, s; at most 1
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
};

/// What is wrong, naming the setting and its value; or "".
PALPATE_EXPORT std::string fault(const SimulatedPlant& plant);
PALPATE_EXPORT std::string fault(const HandModel& hand);
} // namespace palpate

#endif
