// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SafetyChain.h"

#include "Haptics/Devices/WorkspaceMapping.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

double factorOf(double given) noexcept
{
  return given > 0.0 ? std::fmin(given, 1.0) : 0.0;
}

void mark(std::uint16_t& acted, SafetyLink link, bool whether) noexcept
{
  acted = static_cast<std::uint16_t>(acted | (whether ? static_cast<std::uint16_t>(link) : 0));
}
} // namespace

SafetyChain::SafetyChain(const SafetySettings& settings) noexcept
  : Settings(settings)
  , UsesTime(!std::isinf(settings.sampleTimeOut) || !std::isinf(settings.maximumForceRate) ||
      settings.controlPassivity || settings.entryRamp > 0.0 ||
      (settings.maximumTorque > 0.0 && !std::isinf(settings.maximumTorqueRate)))
  , Gate(settings.gate, settings.entryRamp)
  , Slew(settings.maximumForceRate)
  , Magnitude(settings.maximumForce)
  , TorqueSlew(settings.maximumTorqueRate)
  , TorqueMagnitude(settings.maximumTorque)
  , Watchdog(settings.sampleTimeOut)
  , Passivity(settings.maximumStiffness, settings.period, settings.delay,
      settings.maximumTorque > 0.0 ? settings.maximumTorsionalStiffness : 0.0)
{
  this->setForceFactor(settings.forceFactor);
}

[[gnu::hot]] SafeForce SafetyChain::apply(const SafetyInput& input) noexcept
{
  SafeForce result;
  result.forceFactor = this->Settings.forceFactor;
  result.holdTime = this->Settings.sampleTimeOut;
  result.acted = this->losses(input);
  if (result.acted != 0)
  {
    result.isGap = this->Settings.controlPassivity && std::isfinite(input.time) &&
      result.acted == static_cast<std::uint16_t>(SafetyLink::NoSample) &&
      this->Watchdog.isGap(input.time);
    if (result.isGap)
    {
      this->interrupt(input.time);
    }
    else
    {
      this->restart();
    }
    return result;
  }
  const Wrench sent = this->shape(input, result);
  result.force = sent.force;
  result.torque = sent.torque;
  this->Slew.sent(input.time, result.force);
  this->TorqueSlew.sent(input.time, result.torque);
  if (this->Settings.controlPassivity)
  {
    this->Passivity.sent(input.time, sent);
    result.holdTime = this->holdTime();
  }
  return result;
}

[[gnu::hot]] double SafetyChain::holdTime() const noexcept
{
  const double least = std::fmin(LeastHold * this->Settings.period, this->Settings.sampleTimeOut);
  return std::clamp(this->Passivity.holdTime(), least, this->Settings.sampleTimeOut);
}

[[gnu::hot]] std::uint16_t SafetyChain::losses(const SafetyInput& input) noexcept
{
  std::uint16_t lost = 0;
  const bool hasSample = input.valid && input.position.allFinite() &&
    (!this->hasTorque() || input.orientation.coeffs().allFinite());
  const bool hasTime = !this->UsesTime || std::isfinite(input.time);
  const bool isFinite = input.idealForce.allFinite() && input.cappedForce.allFinite() &&
    (!this->hasTorque() || (input.idealTorque.allFinite() && input.cappedTorque.allFinite()));
  mark(lost, SafetyLink::Stopped, this->IsStopped);
  mark(lost, SafetyLink::NoSample, !hasSample);
  mark(lost, SafetyLink::NotFinite, hasSample && !(hasTime && isFinite));
  if (hasSample && hasTime && this->UsesTime)
  {
    mark(lost, SafetyLink::Watchdog, this->Watchdog.isLost(input.time, input.fresh));
  }
  return lost;
}

[[gnu::hot]] Wrench SafetyChain::shape(const SafetyInput& input, SafeForce& result) noexcept
{
  const SafetySettings& settings = this->Settings;
  const double gate = this->Gate.share(input.time, input.outside);
  mark(result.acted, SafetyLink::Gate, gate < 1.0);
  mark(result.acted, SafetyLink::Fit, settings.forceFactor < 1.0);
  mark(result.acted, SafetyLink::StiffnessCap,
    settings.capStiffness && input.cappedForce != input.idealForce);
  Wrench wanted;
  wanted.force =
    gate * settings.forceFactor * (settings.capStiffness ? input.cappedForce : input.idealForce);

  const Eigen::Vector3d slewed = this->Slew.limit(input.time, wanted.force);
  mark(result.acted, SafetyLink::Slew, slewed != wanted.force);
  Wrench limited;
  limited.force = this->Magnitude.limit(slewed);
  mark(result.acted, SafetyLink::Magnitude, limited.force != slewed);
  if (this->hasTorque() && isTold(input.orientation))
  {
    limited.torque = this->shapeTorque(input, gate * settings.forceFactor, wanted.torque, result);
  }
  if (!settings.controlPassivity)
  {
    return limited;
  }
  // The last step of a ramp is still part of the ramp.
  const bool changing = input.changing || gate < 1.0 || this->LastGateShare < 1.0;
  this->LastGateShare = gate;
  Wrench passive = this->controlPassivity(input, changing, wanted, limited);
  mark(result.acted, SafetyLink::Passivity,
    passive.force != limited.force || passive.torque != limited.torque);
  return passive;
}

Eigen::Vector3d SafetyChain::shapeTorque(
  const SafetyInput& input, double share, Eigen::Vector3d& wanted, SafeForce& result) noexcept
{
  const bool caps = this->Settings.capStiffness;
  mark(result.acted, SafetyLink::StiffnessCap, caps && input.cappedTorque != input.idealTorque);
  wanted = share * (caps ? input.cappedTorque : input.idealTorque);
  const Eigen::Vector3d slewed = this->TorqueSlew.limit(input.time, wanted);
  mark(result.acted, SafetyLink::Slew, slewed != wanted);
  Eigen::Vector3d limited = this->TorqueMagnitude.limit(slewed);
  mark(result.acted, SafetyLink::Magnitude, limited != slewed);
  return limited;
}

[[gnu::hot]] Wrench SafetyChain::controlPassivity(
  const SafetyInput& input, bool changing, const Wrench& wanted, const Wrench& limited) noexcept
{
  // If the chain has no gate, the energy of the first force is granted, because the caller has
  // chosen the missing gate.
  const bool isGiven = changing || this->Passivity.isNew();
  if (input.fresh || this->Passivity.isNew())
  {
    this->Passivity.observe(input.time, input.position, input.orientation);
  }
  const double force = wanted.force.stableNorm();
  const double torque = wanted.torque.stableNorm();
  this->Passivity.bound(force, input.depth, torque);
  if (isGiven)
  {
    this->Passivity.grant(force, input.depth, torque);
  }
  return this->Passivity.limit(limited);
}

void SafetyChain::stop() noexcept
{
  this->IsStopped = true;
  this->restart();
}

void SafetyChain::restart() noexcept
{
  this->Gate.close();
  this->Slew.reset();
  this->TorqueSlew.reset();
  this->Passivity.reset();
  this->LastGateShare = 1.0;
}

void SafetyChain::interrupt(double time) noexcept
{
  this->Slew.sent(time, Eigen::Vector3d::Zero());
  this->TorqueSlew.sent(time, Eigen::Vector3d::Zero());
  this->Passivity.interrupt(time);
}

void SafetyChain::reset() noexcept
{
  this->restart();
  this->Watchdog.reset();
}

[[gnu::hot]] void SafetyChain::setForceFactor(double factor) noexcept
{
  this->Settings.forceFactor = factorOf(factor);
}

double SafetyChain::bodyStiffnessLimit(double scale) const noexcept
{
  return this->Settings.capStiffness
    ? this->Settings.maximumStiffness / (MillimetresPerMetre * scale * this->Settings.forceFactor)
    : std::numeric_limits<double>::infinity();
}

double SafetyChain::bodyTorsionalLimit(double scale) const noexcept
{
  return this->Settings.capStiffness ? this->Settings.maximumTorsionalStiffness *
      (MillimetresPerMetre * scale) / this->Settings.forceFactor
                                     : std::numeric_limits<double>::infinity();
}
} // namespace palpate
