// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_SceneRule_h
#define palpate_endurance_SceneRule_h

#include "TickFacts.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace palpate::endurance
{
/// The scenes in contact and their shares. Usually one scene is in contact. For 50 ms after a
/// change, both the old and the new scene are in contact. The share of the new scene grows linearly
/// with time, but by at most a tenth per tick.
class SceneRule
{
public:
  explicit SceneRule(FeltScene first) { this->Scenes.emplace(0, std::move(first)); }

  /// Adds the next scene that the loop may use.
  void offer(FeltScene next) { this->Scenes.emplace(++this->Offered, std::move(next)); }
  std::uint32_t offered() const { return this->Offered; }
  /// Number of the scene in contact; during a change, of the new scene.
  std::uint32_t current() const { return this->Current; }

  /// Checks the scene that a tick reports. Returns false if that scene was not offered, or if a
  /// scene was skipped.
  bool enter(std::uint32_t scene)
  {
    if (scene == this->Current)
    {
      return true;
    }
    if (scene != this->Current + 1 || scene > this->Offered)
    {
      return false;
    }
    this->Scenes.erase(this->Scenes.begin(), this->Scenes.find(this->Current));
    this->Current = scene;
    this->IsChanging = true;
    this->Share = 0.0;
    this->IsFirst = true;
    return true;
  }
  /// Updates the share for a tick in contact, `elapsed` s after the previous tick.
  void advance(double elapsed)
  {
    constexpr double ramp = 0.05;
    if (this->IsChanging && !std::exchange(this->IsFirst, false))
    {
      this->Share += std::min(elapsed / ramp, 0.1);
      this->IsChanging = this->Share < 1.0 - Rounding;
    }
  }
  void lose() { this->IsChanging = false; }

  bool isChanging() const { return this->IsChanging; }
  /// Share of the newer scene, 0 to 1.
  double share() const { return this->IsChanging ? this->Share : 1.0; }
  const FeltScene& newer() const { return this->Scenes.at(this->Current); }
  /// The older scene. May be called only during a change.
  const FeltScene& older() const { return this->Scenes.at(this->Current - 1); }

private:
  /// Rounding error of a sum of two hundred steps.
  static constexpr double Rounding = 1e-9;

  std::map<std::uint32_t, FeltScene> Scenes; ///< the older scene and all later scenes
  std::uint32_t Offered = 0;
  std::uint32_t Current = 0;
  bool IsChanging = false;
  bool IsFirst = false;
  double Share = 1.0;
};
} // namespace palpate::endurance

#endif
