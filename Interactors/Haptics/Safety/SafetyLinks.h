// SPDX-License-Identifier: BSD-3-Clause
// Links that reduce or end a force: the ramp of intended changes, then the small links of
// SafetyChain, in its order.
#ifndef palpate_SafetyLinks_h
#define palpate_SafetyLinks_h

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace palpate
{
/**
 * A factor of a force that changes between 0 and 1 without a jump. The change is linear in time and
 * takes 50 ms for the whole range.
 *
 * Among all ramps of 50 ms the linear one has the smallest maximum rate (a smooth step has 1.5
 * times this rate). Therefore the change of a force s(t) F per tick of length T is at most the
 * change of F plus |F| T / 50 ms. The step of a late tick is limited to MaximumStep, so that a
 * stall prolongs the ramp instead of making the step larger.
 */
class ForceRamp
{
public:
  static constexpr double Duration = 0.05; ///< s
  /// Largest change of the factor per tick; corresponds to 5 ms.
  static constexpr double MaximumStep = 0.1;

  explicit ForceRamp(double share) noexcept
    : Share(share)
  {
  }

  /// Moves the factor towards `target` (0 to 1) for `elapsed` s (>= 0). Returns the new factor.
  double advance(double target, double elapsed) noexcept
  {
    const double step = std::min(elapsed / Duration, MaximumStep);
    this->Share += std::clamp(target - this->Share, -step, step);
    return this->Share;
  }
  double share() const noexcept { return this->Share; }

private:
  double Share;
};

/**
 * The first link of the safety chain. If a session begins, or continues after a loss, while the
 * tool is inside the body, the force of this depth must not push the tool out. Therefore the gate
 * is closed until the tip has been outside once. If a ramp is given, the factor of the force grows
 * linearly from 0 to 1 over the time of the ramp after the start of the first contact.
 */
class EntryGate
{
public:
  /// `ramp` is the time of the ramp, s; there is no ramp if it is 0 or NaN. If `closes` is false,
  /// the gate is always open.
  EntryGate(bool closes, double ramp) noexcept
    : Closes(closes)
    , Ramp(ramp)
  {
  }

  /// The fraction of the force that may pass at `time` (s), 0 to 1. `outside` means that the tip is
  /// not in contact.
  double share(double time, bool outside) noexcept
  {
    this->HasBeenOutside = this->HasBeenOutside || outside;
    if (this->Closes && !this->HasBeenOutside)
    {
      return 0.0;
    }
    if (!this->HasTouched)
    {
      if (outside)
      {
        return 1.0; // there is no force to be scaled
      }
      this->HasTouched = true;
      this->TouchTime = time;
    }
    const double since = time - this->TouchTime;
    return this->Ramp > 0.0 && since < this->Ramp ? std::max(0.0, since / this->Ramp) : 1.0;
  }
  void close() noexcept
  {
    this->HasBeenOutside = false;
    this->HasTouched = false;
  }

private:
  bool Closes;
  double Ramp;
  bool HasBeenOutside = false;
  bool HasTouched = false;
  double TouchTime = 0.0;
};

/**
 * The slew limit. Between two ticks the force changes on the straight line to its target by no more
 * than the rate times the time between the ticks. The line starts at the last sent force, which is
 * initially zero. Therefore a force that was removed by later links does not return in one step.
 */
class ForceRateLimit
{
public:
  /// `rate` is in N/s. An infinite rate means no limit. If the rate is negative or NaN, the force
  /// does not change.
  explicit ForceRateLimit(double rate) noexcept
    : Rate(rate)
  {
  }

  Eigen::Vector3d limit(double time, const Eigen::Vector3d& force) const noexcept
  {
    if (this->Rate > 0.0 && std::isinf(this->Rate))
    {
      return force;
    }
    const double passed = this->HasTime ? time - this->LastTime : 0.0;
    const double most = this->Rate * passed;
    const Eigen::Vector3d change = force - this->Last;
    const double size = change.stableNorm();
    if (size <= most)
    {
      return force;
    }
    return most > 0.0 ? Eigen::Vector3d(this->Last + most / size * change) : this->Last;
  }
  /// Stores the force that the safety chain sends in this tick at `time` (s).
  void sent(double time, const Eigen::Vector3d& force) noexcept
  {
    this->Last = force;
    this->LastTime = time;
    this->HasTime = true;
  }
  /// Restarts the limit at zero force.
  void reset() noexcept
  {
    this->Last.setZero();
    this->HasTime = false;
  }

private:
  double Rate;
  Eigen::Vector3d Last = Eigen::Vector3d::Zero();
  bool HasTime = false; ///< false if there is no preceding tick
  double LastTime = 0.0;
};

/// Limits the magnitude of the force; the direction is unchanged.
class ForceLimit
{
public:
  /// `maximum` is in N. An infinite maximum means no limit. If the maximum is negative or NaN, the
  /// force is zero.
  explicit ForceLimit(double maximum) noexcept
    : Maximum(maximum > 0.0 ? maximum : 0.0)
  {
  }

  /// `force` must be finite.
  Eigen::Vector3d limit(const Eigen::Vector3d& force) const noexcept
  {
    // The ordinary norm is used unless its squares overflow or underflow, so that results are bit
    // for bit those of earlier versions.
    const double plain = force.norm();
    const double size = plain > 1e-100 && plain < 1e100 ? plain : force.stableNorm();
    return size <= this->Maximum ? force : Eigen::Vector3d(this->Maximum / size * force);
  }

private:
  double Maximum;
};

/**
 * Checks whether the device still reports the position of the hand. A device without a new reading
 * for longer than its time-out is lost until the next new reading. It is also lost if the loop
 * pauses for longer than the time-out, or if the clock decreases.
 */
class SampleWatchdog
{
public:
  /// `timeOut` is in s. If it is infinite, the device is never lost. If it is negative or NaN, the
  /// device is always lost.
  explicit SampleWatchdog(double timeOut) noexcept
    : TimeOut(timeOut)
  {
  }

  /// Returns whether the device is lost; then the force must be zero. Must be called in every tick
  /// with a valid sample. `fresh` means that the sample is new.
  bool isLost(double time, bool fresh) noexcept
  {
    if (!this->HasTime)
    {
      this->HasTime = true;
      this->LastTime = time;
      this->LastFresh = time;
    }
    const bool wentBack = time < this->LastTime;
    if (wentBack)
    {
      this->LastFresh = time; // LastFresh restarts with the time of the new clock
    }
    const bool isOld = !(time - this->LastFresh <= this->TimeOut);
    this->LastTime = time;
    if (fresh)
    {
      this->LastFresh = time;
    }
    return wentBack || isOld;
  }
  /// The result that isLost would have at the time `time`.
  bool wouldBeLost(double time) const noexcept
  {
    const double since = this->HasTime ? time - this->LastFresh : 0.0;
    return (this->HasTime && time < this->LastTime) || !(since <= this->TimeOut);
  }
  /// Whether missing or invalid readings at `time` are a gap. They are a gap if the last new
  /// reading is not older than the time-out, or not older than LongestGap if there is no time-out.
  bool isGap(double time) const noexcept
  {
    const double longest = std::isinf(this->TimeOut) ? LongestGap : this->TimeOut;
    return this->HasTime && time >= this->LastTime && time - this->LastFresh <= longest;
  }
  /// Restarts the time-out at the next call of isLost.
  void reset() noexcept { this->HasTime = false; }

  static constexpr double LongestGap = 0.02; ///< s, the usual time-out

private:
  double TimeOut;
  bool HasTime = false;
  double LastTime = 0.0;  ///< time of the last call
  double LastFresh = 0.0; ///< time of the last new sample
};
} // namespace palpate

#endif
