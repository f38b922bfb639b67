// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/SceneSwitch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
void copy(const std::unique_ptr<ServoScene>& from, std::unique_ptr<ServoScene>& to)
{
  if (from)
  {
    to = std::make_unique<ServoScene>(*from);
  }
}

double reachOf(const Contact& contact, const FrictionSettings& friction) noexcept
{
  const double force = contact.friction.norm();
  if (!(force > 0.0))
  {
    return contact.deflection;
  }
  if (friction.model != FrictionModel::ShapeDerived)
  {
    return contact.deflection + force / friction.tangentialStiffness;
  }
  // A contact slides at a displacement of at most μ E*/G* δ (Jaeger; Ciavarella).
  const double poisson = friction.poissonRatio;
  const double ratio = (2.0 - poisson) / (2.0 - 2.0 * poisson);
  return contact.deflection * (1.0 + friction.coefficient * ratio);
}

/// The force of the scene's contact, or of a copy of it, computed by the same code.
[[gnu::hot, gnu::noinline]] SceneForce feel(const ServoScene& scene, ToolContact& touch,
  const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept
{
  const Contact contact = touch.update(pose, elapsed);
  const bool isCapped = contact.normalForce > 0.0 && !std::isinf(limits.straight);
  const double share =
    isCapped ? touch.cappedShare(contact, limits.straight / scene.forceFactor) : 1.0;
  return forceOf(scene, contact, share, pose, limits);
}
[[gnu::hot]] SceneForce feel(
  ServoScene& scene, const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept
{
  return feel(scene, scene.contact, pose, elapsed, limits);
}
SceneForce feelCopied(const ServoScene& scene, const ToolPose& pose, double elapsed,
  const StiffnessLimits& limits) noexcept
{
  ToolContact scratch(scene.contact);
  return feel(scene, scratch, pose, elapsed, limits);
}

/// Moves the contact to the side of the body on which `other` is, so that the next tick continues
/// there.
void enter(ToolContact& contact, const Contact& other, const ToolPose& pose) noexcept
{
  // Fraction of the deflection: near that side, yet below most other surfaces.
  constexpr double Depth = 0.1;
  if (other.triangle >= 0 && other.deflection > 0.0)
  {
    ToolPose near = pose;
    near.tip = other.contactPoint + Depth * (pose.tip - other.contactPoint);
    contact.update(near);
  }
}
} // namespace

[[gnu::hot]] SceneForce forceOf(const ServoScene& scene, const Contact& contact, double share,
  const ToolPose& pose, const StiffnessLimits& limits) noexcept
{
  SceneForce felt;
  felt.contact = contact;
  felt.forceFactor = scene.forceFactor;
  felt.idealForce = contact.force;
  felt.cappedForce = share * contact.force;
  if (pose.hasAxis())
  {
    // A smaller force causes a smaller indentation, and its torque is smaller by the same factor.
    const double turning = cappedTorqueShare(contact, limits.turning / scene.forceFactor);
    felt.idealTorque = contact.torque;
    felt.cappedTorque = std::min(share, turning) * contact.torque;
  }
  felt.reach = reachOf(contact, scene.settings.friction);
  felt.outside = contact.state == ContactState::None;
  return felt;
}

SceneSwitch::SceneSwitch(std::unique_ptr<ServoScene> scene) noexcept
  : Current(std::move(scene))
{
}

SceneSwitch::SceneSwitch(const SceneSwitch& other)
  : Ramp(other.Ramp)
  , Entering(other.Entering)
  , Changes(other.Changes)
{
  copy(other.Current, this->Current);
  copy(other.Leaving, this->Leaving);
  copy(other.Waiting, this->Waiting);
}

void SceneSwitch::change(std::unique_ptr<ServoScene> next) noexcept
{
  if (!next)
  {
    return;
  }
  if (!this->Leaving)
  {
    this->begin(std::move(next));
    return;
  }
  this->retire(std::move(this->Waiting));
  this->Waiting = std::move(next);
}

void SceneSwitch::begin(std::unique_ptr<ServoScene> next) noexcept
{
  this->Leaving = std::move(this->Current);
  this->Current = std::move(next);
  this->Ramp = ForceRamp(0.0);
  this->Entering = true;
  ++this->Changes;
}

void SceneSwitch::end() noexcept
{
  this->retire(std::move(this->Leaving));
  if (this->Waiting)
  {
    this->begin(std::move(this->Waiting));
  }
}

void SceneSwitch::retire(std::unique_ptr<ServoScene> scene) noexcept
{
  if (scene)
  {
    scene->next = std::move(this->Retired);
    this->Retired = std::move(scene);
  }
}

void SceneSwitch::forget() noexcept
{
  while (this->Leaving)
  {
    this->end();
  }
  this->Current->contact.lose();
}

void SceneSwitch::reset() noexcept
{
  this->forget();
  this->Current->contact.reset();
}

void SceneSwitch::pass(double elapsed) noexcept
{
  this->Current->contact.pass(elapsed);
  if (this->Leaving)
  {
    this->Leaving->contact.pass(elapsed);
  }
}

[[gnu::hot]] SceneForce SceneSwitch::update(
  const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept
{
  const bool moves = this->Leaving && !this->Entering;
  if (moves && this->Ramp.advance(1.0, elapsed) >= 1.0)
  {
    this->end();
  }
  SceneForce felt = this->Leaving ? this->blend(pose, elapsed, limits)
                                  : feel(*this->Current, pose, elapsed, limits);
  felt.changing = moves;
  return felt;
}

SceneForce SceneSwitch::rehearse(
  const ToolPose& pose, double elapsed, const StiffnessLimits& limits) const noexcept
{
  if (this->Leaving)
  {
    feelCopied(*this->Leaving, pose, elapsed, limits);
  }
  return feelCopied(*this->Current, pose, elapsed, limits);
}

SceneForce SceneSwitch::blend(
  const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept
{
  const SceneForce before = feel(*this->Leaving, pose, elapsed, limits);
  if (std::exchange(this->Entering, false))
  {
    enter(this->Current->contact, before.contact, pose);
  }
  SceneForce felt = feel(*this->Current, pose, elapsed, limits);
  const double way = this->Ramp.share();
  const double rest = (1.0 - way) * before.forceFactor;
  const double factor = rest + way * felt.forceFactor;
  // Forces blended by these fractions, times the blended factor, are linear in `way`.
  felt.share = factor > 0.0 ? way * felt.forceFactor / factor : way;
  const double shareBefore = factor > 0.0 ? rest / factor : 1.0 - way;
  felt.idealForce = shareBefore * before.idealForce + felt.share * felt.idealForce;
  felt.cappedForce = shareBefore * before.cappedForce + felt.share * felt.cappedForce;
  felt.idealTorque = shareBefore * before.idealTorque + felt.share * felt.idealTorque;
  felt.cappedTorque = shareBefore * before.cappedTorque + felt.share * felt.cappedTorque;
  felt.forceFactor = factor;
  felt.reach = std::max(before.reach, felt.reach);
  felt.outside = before.outside && felt.outside;
  return felt;
}
} // namespace palpate
