// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_SwapWatch_h
#define palpate_endurance_SwapWatch_h

#include <cstdint>

namespace palpate::endurance
{
/// Checks that each requested swap takes effect in the first tick that can use the new scene. Ticks
/// are numbered from 0. A swap is requested only after the previous swap has taken effect.
class SwapWatch
{
public:
  /// Records a requested swap. `made`: number of ticks completed when the scene had been handed
  /// over. One more tick may have been in progress and may still use the old scene. The tick after
  /// it must use the new scene.
  void ask(std::uint64_t made)
  {
    ++this->Asked;
    this->Due = made + 1;
    this->IsOpen = true;
  }
  /// Records a tick and the number of its scene.
  void see(std::uint64_t tick, std::uint32_t scene)
  {
    this->Seen += scene != this->Scene ? 1 : 0;
    if (this->IsOpen && tick >= this->Due)
    {
      this->Late += scene == this->Scene ? 1 : 0;
      this->IsOpen = false;
    }
    this->IsOpen = this->IsOpen && scene == this->Scene;
    this->Scene = scene;
  }

  std::uint64_t asked() const { return this->Asked; }
  std::uint64_t seen() const { return this->Seen; }
  /// Number of swaps that took effect too late or never.
  std::uint64_t late() const { return this->Late; }

private:
  std::uint64_t Asked = 0;
  std::uint64_t Seen = 0;
  std::uint64_t Late = 0;
  std::uint64_t Due = 0;
  bool IsOpen = false;
  std::uint32_t Scene = 0;
};
} // namespace palpate::endurance

#endif
