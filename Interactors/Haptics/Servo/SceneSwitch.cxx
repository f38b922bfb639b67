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

/// Computes the force of one contact of a scene. `contacts` are the scene's contacts or a copy of
/// them, so that both are computed by the same code.
[[gnu::hot, gnu::noinline]] SceneForce feel(const ServoScene& scene, CoupledContacts& contacts,
  std::size_t hand, const ToolPose& pose, const StiffnessLimits& limits) noexcept
{
  SceneForce felt;
  felt.contact = contacts.felt()[hand];
  const Contact& contact = felt.contact;
  const bool isCapped = contact.normalForce > 0.0 && !std::isinf(limits.straight);
  const double share =
    isCapped ? contacts.cappedShare(hand, limits.straight / scene.forceFactor) : 1.0;
  felt.forceFactor = scene.forceFactor;
  felt.idealForce = contact.force;
  felt.cappedForce = share * contact.force;
  if (pose.hasAxis())
  {
    // A smaller force belongs to a smaller indentation, and its torque is smaller by the same
    // factor.
    const double turning = cappedTorqueShare(contact, limits.turning / scene.forceFactor);
    felt.idealTorque = contact.torque;
    felt.cappedTorque = std::min(share, turning) * contact.torque;
  }
  felt.reach = reachOf(contact, scene.settings.friction) + contacts.sunk(hand);
  felt.outside = contact.state == ContactState::None;
  return felt;
}
} // namespace

SceneSwitch::SceneSwitch(std::unique_ptr<ServoScene> scene) noexcept
  : Current(std::move(scene))
{
}

SceneSwitch::SceneSwitch(const SceneSwitch& other)
  : Ramp(other.Ramp)
  , Moves(other.Moves)
  , Entering(other.Entering)
  , Changes(other.Changes)
{
  copy(other.Current, this->Current);
  copy(other.Leaving, this->Leaving);
  copy(other.Waiting, this->Waiting);
}

bool SceneSwitch::change(std::unique_ptr<ServoScene> next) noexcept
{
  if (!next || next->contacts.count() != this->hands())
  {
    this->retire(std::move(next));
    return false;
  }
  if (this->Leaving)
  {
    this->retire(std::move(this->Waiting));
    this->Waiting = std::move(next);
  }
  else
  {
    this->begin(std::move(next));
  }
  return true;
}

void SceneSwitch::begin(std::unique_ptr<ServoScene> next) noexcept
{
  this->Leaving = std::move(this->Current);
  this->Current = std::move(next);
  this->Ramp = ForceRamp(0.0);
  this->Entering.set();
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
  this->Current->contacts.lose();
}

void SceneSwitch::forget(std::size_t hand) noexcept
{
  this->Current->contacts.lose(hand);
  if (this->Leaving)
  {
    this->Leaving->contacts.lose(hand);
  }
}

void SceneSwitch::reset() noexcept
{
  this->forget();
  this->Current->contacts.reset();
}

[[gnu::hot]] void SceneSwitch::update(const std::optional<ToolPose>* poses, double elapsed) noexcept
{
  const bool isAnyThere =
    std::any_of(poses, poses + this->hands(), [](const auto& pose) { return pose.has_value(); });
  this->Moves = this->Leaving && isAnyThere && !this->Entering.all();
  if (this->Moves && this->Ramp.advance(1.0, elapsed) >= 1.0)
  {
    this->end();
  }
  if (this->Leaving)
  {
    this->Leaving->contacts.step(poses, elapsed);
    this->enter(poses);
  }
  this->Current->contacts.step(poses, elapsed);
}

void SceneSwitch::enter(const std::optional<ToolPose>* poses) noexcept
{
  // Fraction of the old deflection. At this depth the tip is near the surface of the old contact,
  // but below most other surfaces.
  constexpr double Depth = 0.1;
  for (std::size_t i = 0; i < this->hands(); ++i)
  {
    const Contact& old = this->Leaving->contacts.felt()[i];
    if (this->Entering[i] && poses[i] && old.triangle >= 0 && old.deflection > 0.0)
    {
      ToolPose near = *poses[i];
      near.tip = old.contactPoint + Depth * (near.tip - old.contactPoint);
      this->Current->contacts.move(i, near);
      this->Current->contacts.assumeFriction(i, this->Leaving->contacts);
    }
    this->Entering[i] = this->Entering[i] && !poses[i];
  }
}

[[gnu::hot]] SceneForce SceneSwitch::force(
  std::size_t hand, const ToolPose& pose, const StiffnessLimits& limits) const noexcept
{
  SceneForce felt = feel(*this->Current, this->Current->contacts, hand, pose, limits);
  if (this->Leaving)
  {
    this->blend(feel(*this->Leaving, this->Leaving->contacts, hand, pose, limits), felt);
  }
  felt.changing = this->Moves;
  return felt;
}

void SceneSwitch::rehearse(const std::optional<ToolPose>* poses, double elapsed) const noexcept
{
  for (ServoScene* scene : { this->Leaving.get(), this->Current.get() })
  {
    if (scene)
    {
      scene->rehearsed.assume(scene->contacts);
      scene->rehearsed.step(poses, elapsed);
    }
  }
}

SceneForce SceneSwitch::rehearsedForce(
  std::size_t hand, const ToolPose& pose, const StiffnessLimits& limits) const noexcept
{
  return feel(*this->Current, this->Current->rehearsed, hand, pose, limits);
}

void SceneSwitch::blend(const SceneForce& before, SceneForce& felt) const noexcept
{
  const double way = this->Ramp.share();
  const double rest = (1.0 - way) * before.forceFactor;
  const double factor = rest + way * felt.forceFactor;
  // With these fractions and the blended factor, the sent force is a linear function of `way`.
  felt.share = factor > 0.0 ? way * felt.forceFactor / factor : way;
  const double shareBefore = factor > 0.0 ? rest / factor : 1.0 - way;
  felt.idealForce = shareBefore * before.idealForce + felt.share * felt.idealForce;
  felt.cappedForce = shareBefore * before.cappedForce + felt.share * felt.cappedForce;
  felt.idealTorque = shareBefore * before.idealTorque + felt.share * felt.idealTorque;
  felt.cappedTorque = shareBefore * before.cappedTorque + felt.share * felt.cappedTorque;
  felt.forceFactor = factor;
  felt.reach = std::max(before.reach, felt.reach);
  felt.outside = before.outside && felt.outside;
}
} // namespace palpate
