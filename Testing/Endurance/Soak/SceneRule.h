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
/// Which scenes are felt, and how much of each: one, or for 50 ms after a change the old and the
/// new, straight in time, no tick counting for more than a tenth of the way.
class SceneRule
{
public:
  explicit SceneRule(FeltScene first) { this->Scenes.emplace(0, std::move(first)); }

  /// The next one that may come.
  void offer(FeltScene next) { this->Scenes.emplace(++this->Offered, std::move(next)); }
  std::uint32_t offered() const { return this->Offered; }
  /// Which one is felt, or gone over to.
  std::uint32_t current() const { return this->Current; }

  /// What a tick says it feels; false if that was not offered, or one was passed over.
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
  /// A tick that touches, `elapsed` s after the one before.
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
  /// Of the newer scene.
  double share() const { return this->IsChanging ? this->Share : 1.0; }
  const FeltScene& newer() const { return this->Scenes.at(this->Current); }
  /// While changing.
  const FeltScene& older() const { return this->Scenes.at(this->Current - 1); }

private:
  /// Of two hundred steps added up.
  static constexpr double Rounding = 1e-9;

  std::map<std::uint32_t, FeltScene> Scenes; ///< from the older one on
  std::uint32_t Offered = 0;
  std::uint32_t Current = 0;
  bool IsChanging = false;
  bool IsFirst = false;
  double Share = 1.0;
};
} // namespace palpate::endurance

#endif
