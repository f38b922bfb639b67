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
  // A contact slides at the latest when it is displaced by μ E*/G* δ (Jaeger; Ciavarella).
  const double poisson = friction.poissonRatio;
  const double ratio = (2.0 - poisson) / (2.0 - 2.0 * poisson);
  return contact.deflection * (1.0 + friction.coefficient * ratio);
}

SceneForce feel(
  ServoScene& scene, const Vector3& tip, double elapsed, double stiffnessLimit) noexcept
{
  SceneForce felt;
  felt.contact = scene.contact.update(tip, elapsed);
  felt.forceFactor = scene.forceFactor;
  felt.idealForce = felt.contact.force;
  felt.cappedForce = felt.contact.force;
  if (felt.contact.normalForce > 0.0 && !std::isinf(stiffnessLimit))
  {
    felt.cappedForce *= scene.contact.cappedShare(felt.contact, stiffnessLimit / scene.forceFactor);
  }
  felt.reach = reachOf(felt.contact, scene.settings.friction);
  felt.outside = felt.contact.state == ContactState::None;
  return felt;
}

/// So that the next tick finds the contact on that side of the body where another has it.
void enter(ToolContact& contact, const Contact& other, const Vector3& tip) noexcept
{
  constexpr double Depth = 0.1; // of the deflection: near that side, yet under most other surfaces
  if (other.triangle >= 0 && other.deflection > 0.0)
  {
    contact.update(other.contactPoint + Depth * (tip - other.contactPoint));
  }
}
} // namespace

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

SceneForce SceneSwitch::update(const Vector3& tip, double elapsed, double stiffnessLimit) noexcept
{
  const bool moves = this->Leaving && !this->Entering;
  if (moves && this->Ramp.advance(1.0, elapsed) >= 1.0)
  {
    this->end();
  }
  SceneForce felt = this->Leaving ? this->blend(tip, elapsed, stiffnessLimit)
                                  : feel(*this->Current, tip, elapsed, stiffnessLimit);
  felt.changing = moves;
  return felt;
}

SceneForce SceneSwitch::blend(const Vector3& tip, double elapsed, double stiffnessLimit) noexcept
{
  const SceneForce before = feel(*this->Leaving, tip, elapsed, stiffnessLimit);
  if (std::exchange(this->Entering, false))
  {
    enter(this->Current->contact, before.contact, tip);
  }
  SceneForce felt = feel(*this->Current, tip, elapsed, stiffnessLimit);
  const double way = this->Ramp.share();
  const double rest = (1.0 - way) * before.forceFactor;
  const double factor = rest + way * felt.forceFactor;
  // Forces blended by these shares, times the blended factor, are on the straight line.
  felt.share = factor > 0.0 ? way * felt.forceFactor / factor : way;
  const double shareBefore = factor > 0.0 ? rest / factor : 1.0 - way;
  felt.idealForce = shareBefore * before.idealForce + felt.share * felt.idealForce;
  felt.cappedForce = shareBefore * before.cappedForce + felt.share * felt.cappedForce;
  felt.forceFactor = factor;
  felt.reach = std::max(before.reach, felt.reach);
  felt.outside = before.outside && felt.outside;
  return felt;
}
} // namespace palpate
