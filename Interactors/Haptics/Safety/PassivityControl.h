// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PassivityControl_h
#define palpate_PassivityControl_h

#include "Haptics/Devices/ToolOrientation.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/**
 * A force with a torque, or a displacement with a rotation, as one vector of six components.
 * Torques are divided by a length ℓ and rotations are multiplied by ℓ. Therefore all components are
 * in N, or all in m, and the product of a force and a displacement is their work.
 *
 * If the angular part is zero, every result is bit for bit the result of the linear part alone.
 */
struct SpatialVector
{
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();

  bool isAngular() const noexcept { return !this->angular.isZero(0.0); }
  double dot(const SpatialVector& other) const noexcept
  {
    return this->linear.dot(other.linear) + this->angular.dot(other.angular);
  }
  double squaredNorm() const noexcept
  {
    return this->linear.squaredNorm() + this->angular.squaredNorm();
  }
  double norm() const noexcept { return std::sqrt(this->squaredNorm()); }
  /// The norm, computed without overflow or underflow of the squares.
  double stableNorm() const noexcept
  {
    const double straight = this->linear.stableNorm();
    return this->isAngular() ? std::hypot(straight, this->angular.stableNorm()) : straight;
  }

  SpatialVector& operator+=(const SpatialVector& other) noexcept
  {
    this->linear += other.linear;
    this->angular += other.angular;
    return *this;
  }
};

inline SpatialVector operator+(SpatialVector one, const SpatialVector& other) noexcept
{
  return one += other;
}

inline SpatialVector operator*(double factor, const SpatialVector& vector) noexcept
{
  return { factor * vector.linear, factor * vector.angular };
}

inline SpatialVector operator/(const SpatialVector& vector, double divisor) noexcept
{
  return { vector.linear / divisor, vector.angular / divisor };
}

/**
 * The most recently sent forces. If a device's readings and forces are delayed by up to n ticks
 * together, each of the last n + 1 forces may be the one that acts now. Without a delay, no force
 * is stored.
 */
class ForcesUnderWay
{
public:
  static constexpr std::size_t Most = 32; ///< largest delay, ticks

  /// `delay` and `period` are in s. A delay of more than Most ticks counts as Most ticks. A delay
  /// of NaN counts as no delay.
  ForcesUnderWay(double delay, double period) noexcept
    : Late(delay > 0.0 && period > 0.0
          ? static_cast<std::size_t>(std::ceil(std::min(delay / period, 1.0 * Most) - 1e-9))
          : 0)
  {
    this->Forces.fill({});
  }

  std::size_t late() const noexcept { return this->Late; }

  void sent(const SpatialVector& force) noexcept
  {
    this->Newest = (this->Newest + 1) % this->Forces.size();
    this->Forces[this->Newest] = force;
  }

  /// The largest energy, J, that the hand may have received in the displacement `moved` (m) during
  /// `ticks` ticks. It may be negative.
  double mostGiven(const SpatialVector& moved, std::size_t ticks) const noexcept
  {
    double most = this->at(0).dot(moved);
    for (std::size_t i = 1; i < std::min(this->Late + ticks, this->Forces.size()); ++i)
    {
      most = std::max(most, this->at(i).dot(moved));
    }
    return most;
  }

  /**
   * The largest force f such that Σ max(|F_i|, f)² over the next late() + 1 holds is at most
   * `square`. |F_i| is the largest force that may still act i holds from now. Returns 0 if no such
   * f exists.
   */
  double largestWithin(double square) const noexcept
  {
    // largest[i] is the largest force sent within the last late() - i ticks. In the last hold only
    // the new force acts.
    std::array<double, Most + 1> largest{};
    for (std::size_t i = this->Late; i-- > 0;)
    {
      largest[i] = std::max(largest[i + 1], this->at(this->Late - 1 - i).norm());
    }
    // The loop goes through the stored forces in descending order. The holds with weaker forces
    // share the remainder of `square`.
    double left = square;
    for (std::size_t i = 0; i <= this->Late; ++i)
    {
      const double most = std::sqrt(std::max(0.0, left) / static_cast<double>(this->Late + 1 - i));
      if (most >= largest[i])
      {
        return most;
      }
      left -= largest[i] * largest[i];
    }
    return 0.0;
  }

private:
  /// The force that was sent `age` ticks before the last one.
  const SpatialVector& at(std::size_t age) const noexcept
  {
    return this->Forces[(this->Newest + this->Forces.size() - age) % this->Forces.size()];
  }

  std::size_t Late;
  std::size_t Newest = 0;
  std::array<SpatialVector, 2 * Most> Forces;
};

/**
 * Prevents the device from returning more energy to the hand than it has received: it is a
 * passivity observer and controller in the time domain (Hannaford and Ryu 2002) that uses the force
 * actually sent.
 *
 * A force F_k is held while the hand moves from x_k to x_k+1, so that its work is exactly F_k ·
 * (x_k+1 - x_k), regardless of the motion in between. The hold makes a spring K a generator of
 * energy: the held force is too small while pressing, and too large while releasing. Every hold
 * generates K |x_k+1 - x_k|²/2; a press and release at speed v generates F_max v T. No safety chain
 * can prevent this generation of energy; the damping b of the device itself must compensate it. In
 * a hold of length dt this damping dissipates at least b |x_k+1 - x_k|²/dt, and the stiffest spring
 * that a manufacturer may allow at the period T is 2b/T (Colgate and Schenkel 1997). Therefore,
 * with b = K_max T/2, the observer counts
 *   E_k+1 = E_k - F_k · d + b |d|²/dt,  d = x_k+1 - x_k,
 * and allows a force up to |F_k| = √(2 K_max E_k). Then, for any next d,
 *   E_k+1 >= E_k - |F_k| |d| + K_max |d|²/2 >= E_k - F_k²/(2 K_max) >= 0:
 * no motion, however sudden, extracts more energy than was put in, apart from the energy that the
 * device's own damping dissipates in the same holds. The method needs no prediction and no estimate
 * of velocity, and does not oscillate at rest. A device's specification has K_max = b/T. Then half
 * of the damping is credited, and the other half brings the device to rest.
 *
 * The control does not act on a passive scene: for F = -∇U with U >= 0 and no second derivative
 * above K_max,
 *   U_k+1 <= U_k - F_k · d + K_max |d|²/2,
 * so E_k >= U_k, and |F_k|² <= 2 K_max U_k, so that the force is never above the bound, regardless
 * of the motion. The sent force has the direction of the scene's force and is never larger; a
 * spring that is too stiff is rendered as a softer spring. A scene that uses all of the credit
 * would oscillate for ever, as a spring of K_max does on a device without a hand. Therefore, while
 * the requested force exceeds the bound, b and K_max above are multiplied by a fraction: the ratio
 * of bound and request, but at least SmallestShare. The fraction applies until the force is zero.
 * The remaining damping makes the motion decay.
 *
 * When readings are missing, the force is removed immediately, and the motion of the hand in the
 * last hold is unknown. Then the control counts the energy that the hand may have received, and no
 * energy that the hand may have put in. This energy is F · d up to the position in the next reading
 * or, if larger, F times the displacement along F at the last speed and the acceleration of a hand
 * (HandAcceleration). It is at most F²/(2 K_max), the most that any motion can extract from one
 * hold.
 *
 * A hold longer than T can make E negative, at most by the energy generated in this hold. Then no
 * force is sent until the motion has compensated this energy. A later instability could use the
 * energy that friction and damping took from the hand, and the credit accumulated during long
 * motion. Therefore E is limited to the energy that the scene can store now, max(|F| depth, F²/(2
 * K_max)), and to 0 without force. If the force is changed intentionally (a ramp, another body),
 * grant() counts the energy of the new force as put in.
 *
 * **Delay.** The control cannot detect whether a device reports its position or applies its force
 * with a delay. Given a bound n of both delays together, in ticks, the control counts for each
 * displacement the largest energy that any of the delayed forces may have returned, max_j F_k-j ·
 * d, j = 0..n. It allows a force for which the n + 1 holds in which this force may act, together
 * with the forces sent before, extract no more than E. The energy of these holds is Σ |F|²/(2
 * K_max) or, if that allows a larger force, the energy for a hand that continues at its present
 * speed with the acceleration HandAcceleration. Without delay, this rule gives bit for bit the same
 * results as the rule above. A spring passes unchanged up to about K_max/(2n + 1) (Colgate and
 * Schenkel's b > K (T/2 + nT)).
 *
 * **Torque.** Given the largest torsional stiffness K_θ, the control counts the work of force and
 * torque in one account, F · d + M · φ, where φ is the rotation in the hold. It credits b_θ = K_θ
 * T/2 for rotations, as it credits b for displacements. If torques are divided by ℓ = √(K_θ/K_max)
 * and rotations are multiplied by ℓ, all of the above, including the proof, is valid for vectors of
 * six components (SpatialVector): force and torque are scaled by one factor so that F²/(2 K_max) +
 * M²/(2 K_θ) <= E. M · φ is the exact work if the hold turns about one axis; otherwise it is exact
 * to second order in φ. An unknown rotation counts as the rotation that returns the most energy,
 * M²/(2 K_θ). Without torque, the results are bit for bit the same as without this extension.
 */
class PALPATE_EXPORT PassivityControl
{
public:
  /// Magnitude, J, of a negative energy that is ignored, so that rounding does not reduce the force
  /// of a passive scene.
  static constexpr double Slack = 1e-9;
  /// The least fraction of the device's damping that is credited to the scene while the control
  /// limits the force.
  static constexpr double SmallestShare = 0.5;
  /// While readings are missing, the hand is assumed to accelerate along a force F by at most
  /// HandAcceleration + F/LightestHandle, m/s². HandAcceleration, about 2 g, is the part of the
  /// hand itself. The second part is the acceleration by the force of a released handle with the
  /// mass LightestHandle (kg).
  static constexpr double HandAcceleration = 20.0;
  static constexpr double LightestHandle = 0.05;
  /// HandTurning and LightestInertia are the corresponding quantities for rotations, rad/s² and kg
  /// m².
  static constexpr double HandTurning = 1000.0;
  static constexpr double LightestInertia = 1e-5;

  /// `maximumStiffness` is K_max, N/m. If it is infinite, all forces pass; if it is negative or
  /// NaN, no force passes. `period` is T, s. `delay` is the bound of the delay, s, of which at most
  /// ForcesUnderWay::Most periods are taken into account. `maximumTorsionalStiffness` is K_θ, N
  /// m/rad. If it is infinite, torques pass and are not counted; if it is 0, negative or NaN, no
  /// torque passes.
  PassivityControl(double maximumStiffness, double period, double delay = 0.0,
    double maximumTorsionalStiffness = 0.0) noexcept;

  /// Counts the hold that ends at a new reading, whose position is in m. `time` (s) must not
  /// decrease.
  void observe(double time, const Eigen::Vector3d& position,
    const ToolOrientation& orientation = orientationNotTold()) noexcept;
  /// Limits E to the energy that the scene can store. This is the larger of two energies: `force`
  /// (N) times `depth` (m; infinite if unknown), and the energy of springs with K_max and K_θ under
  /// `force` and `torque` (N m).
  void bound(double force, double depth, double torque = 0.0) noexcept;
  /// Adds to E the energy that this force, depth and torque can store, as if the hand had put it
  /// in.
  void grant(double force, double depth, double torque = 0.0) noexcept;
  /// Returns the part of the force that may be sent now.
  Eigen::Vector3d limit(const Eigen::Vector3d& force) noexcept;
  Wrench limit(const Wrench& wrench) noexcept;
  /// Stores the force that the safety chain sends in this tick at `time` (s).
  void sent(double time, const Eigen::Vector3d& force) noexcept;
  void sent(double time, const Wrench& wrench) noexcept;
  /// Begins an interruption, in which readings are missing and the force is zero until the next
  /// reading.
  void interrupt(double time) noexcept;
  void reset() noexcept;

  /// The longest time, s, for which the last force may be held without returning more than E to a
  /// hand, even if the host stops. Infinite if the force is zero. The hand is assumed to move as it
  /// is while readings are missing.
  double holdTime() const noexcept;

  /// The part of E, J, that the last force does not need. It may be transferred to the account of
  /// another device in the same scene. It is 0 while readings are missing, and for a device with
  /// delay.
  double spare() const noexcept;
  /// Adds `energy` (J) to E. A negative `energy` must not exceed spare() in magnitude. If the
  /// energy that is taken from one account is added to another account, all hands together receive
  /// no more energy than they have put in.
  void transfer(double energy) noexcept { this->Energy += energy; }

  /// The energy E, J.
  double energy() const noexcept { return this->Energy; }
  /// Whether no reading has been observed since construction or reset().
  bool isNew() const noexcept { return !this->HasPosition; }

private:
  SpatialVector scaled(const Wrench& wrench) const noexcept;
  /// The displacement and rotation from the last reading to this reading.
  SpatialVector movedTo(
    const Eigen::Vector3d& position, const ToolOrientation& orientation) const noexcept;
  /// The largest energy that an unknown rotation may have returned, J.
  double givenByTurn() const noexcept;
  double storable(double force, double depth, double torque) const noexcept;
  double givenInGap(const SpatialVector& moved) const noexcept;
  double accelerationOfHand(const SpatialVector& direction) const noexcept;
  double handleAlong(const SpatialVector& direction) const noexcept;
  double wayOfHand(const SpatialVector& direction, double time) const noexcept;
  double allowedUnderWay(const SpatialVector& force, double size, double energy) const noexcept;
  /// The largest magnitude, N and at most `size`, that the force may have when it is sent.
  double allowed(const SpatialVector& force, double size) noexcept;
  void send(double time, const SpatialVector& force) noexcept;

  double Stiffness;
  double Period;
  double Delay;
  double TorsionalStiffness;
  double Lever;              ///< ℓ, m; 0 if torques are not counted
  std::size_t SentTicks = 0; ///< number of ticks since ReadTime
  double Energy = 0.0;
  double Share = 1.0; ///< fraction of the device's damping that is credited
  bool HasPosition = false;
  Eigen::Vector3d Position = Eigen::Vector3d::Zero(); ///< position of the last reading
  ToolOrientation Orientation = orientationNotTold(); ///< orientation of the last reading
  double ReadTime = 0.0;                              ///< time of the last reading, s
  SpatialVector Force;                                ///< the last sent force
  double SentTime = 0.0;
  SpatialVector Impulse;      ///< impulse of the forces sent since ReadTime, N s
  SpatialVector Velocity;     ///< mean velocity between the last two readings, m/s
  bool IsInterrupted = false; ///< whether readings have been missing since ReadTime
  SpatialVector Taken;        ///< the force before the interruption, N
  double Held = 0.0;          ///< duration for which Taken had been held, s
  ForcesUnderWay UnderWay;    ///< last member, because it is large and rarely read
};
} // namespace palpate

#endif
