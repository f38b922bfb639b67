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
 * A factor of a force that changes between 0 and 1 without a jump: linear in time, in 50 ms for the
 * whole range.
 *
 * Among all ramps of 50 ms the linear one has the smallest maximum rate (a smooth step has 1.5
 * times that rate). Therefore the change of a force s(t) F per tick of length T is at most the
 * change of F plus |F| T / 50 ms. The step of a late tick is limited to MaximumStep: a stall makes
 * the ramp longer, not the step larger.
 */
class ForceRamp
{
public:
  static constexpr double Duration = 0.05;   ///< s
  static constexpr double MaximumStep = 0.1; ///< fraction of the range per tick: 5 ms

  explicit ForceRamp(double share) noexcept
    : Share(share)
  {
  }

  /// Changes the factor towards `target` (0 to 1) for `elapsed` s, >= 0; returns the new factor.
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
 * The first link. A session that begins, or continues after a loss, with the tool inside the body
 * must not push the tool out with the force of its depth. The gate is closed until the tip has been
 * outside once. With a ramp, the first contact after that is soft: the factor grows linearly from 0
 * over the given time after the start of that contact.
 */
class EntryGate
{
public:
  /// `ramp` in s; 0 or NaN: no ramp. If `closes` is false, the gate is always open.
  EntryGate(bool closes, double ramp) noexcept
    : Closes(closes)
    , Ramp(ramp)
  {
  }

  /// The fraction of the force that may pass now, 0 to 1; time in s.
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
        return 1.0; // there is no force to scale
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
 * The slew limit: between two ticks the force changes along the straight line to its target, by no
 * more than the rate times the time between the ticks. The line starts at the last sent force,
 * initially zero, so that a force which later links remove does not return in one step.
 */
class ForceRateLimit
{
public:
  /// `rate` in N/s; infinite: no limit; negative or NaN: the force does not change.
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
  /// Stores the force that the safety chain sends in this tick.
  void sent(double time, const Eigen::Vector3d& force) noexcept
  {
    this->Last = force;
    this->LastTime = time;
    this->HasTime = true;
  }
  /// Restarts from zero force.
  void reset() noexcept
  {
    this->Last.setZero();
    this->HasTime = false;
  }

private:
  double Rate;
  Eigen::Vector3d Last = Eigen::Vector3d::Zero();
  bool HasTime = false; ///< false: there is no preceding tick
  double LastTime = 0.0;
};

/// Limits the magnitude of the force; the direction is unchanged.
class ForceLimit
{
public:
  /// `maximum` in N; infinite: no limit; negative or NaN: no force.
  explicit ForceLimit(double maximum) noexcept
    : Maximum(maximum > 0.0 ? maximum : 0.0)
  {
  }

  /// `force` must be finite.
  Eigen::Vector3d limit(const Eigen::Vector3d& force) const noexcept
  {
    // The ordinary norm, unless its squares overflow or underflow; this keeps the results of
    // earlier versions bit for bit.
    const double plain = force.norm();
    const double size = plain > 1e-100 && plain < 1e100 ? plain : force.stableNorm();
    return size <= this->Maximum ? force : Eigen::Vector3d(this->Maximum / size * force);
  }

private:
  double Maximum;
};

/**
 * Checks whether the device still reports the hand. A device without a new reading for longer than
 * its time-out is lost, until it reports again. It is also lost after a pause of the loop of this
 * length, and when the clock decreases.
 */
class SampleWatchdog
{
public:
  /// `timeOut` in s; infinite: the device is never lost; negative or NaN: always.
  explicit SampleWatchdog(double timeOut) noexcept
    : TimeOut(timeOut)
  {
  }

  /// Must be called in every tick with a valid sample; `fresh`: the sample is new. If the result is
  /// true, there must be no force now.
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
      this->LastFresh = time; // the time of the new clock
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
  /// Whether readings that are missing or not valid now are a gap: the last new reading is not
  /// older than the time-out, or than LongestGap if there is no time-out.
  bool isGap(double time) const noexcept
  {
    const double longest = std::isinf(this->TimeOut) ? LongestGap : this->TimeOut;
    return this->HasTime && time >= this->LastTime && time - this->LastFresh <= longest;
  }
  /// Restarts the time-out with the next call.
  void reset() noexcept { this->HasTime = false; }

  static constexpr double LongestGap = 0.02; ///< s: the usual time-out

private:
  double TimeOut;
  bool HasTime = false;
  double LastTime = 0.0;  ///< time of the last call
  double LastFresh = 0.0; ///< time of the last new sample
};
} // namespace palpate

#endif
