// SPDX-License-Identifier: BSD-3-Clause
#ifndef TickTape_h
#define TickTape_h

#include "Haptics/Servo/ServoStep.h"

#include <vector>

namespace palpate
{
/// The ticks between two moments of a session.
class TickTape
{
public:
  /// From the next tick on; what it held is gone.
  void start()
  {
    this->Ticks.clear();
    this->Running = true;
  }
  void stop() { this->Running = false; }
  void add(const Tick& tick)
  {
    if (this->Running)
    {
      this->Ticks.push_back(tick);
    }
  }

  bool isRunning() const { return this->Running; }
  const std::vector<Tick>& ticks() const { return this->Ticks; }

private:
  std::vector<Tick> Ticks;
  bool Running = false;
};
} // namespace palpate

#endif
