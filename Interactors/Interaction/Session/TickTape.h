// SPDX-License-Identifier: BSD-3-Clause
#ifndef TickTape_h
#define TickTape_h

#include "Haptics/Servo/TickHistory.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace palpate
{
/// The ticks between two moments of a session, copied from its history bit by bit.
class TickTape
{
public:
  /// From the ticks after those of the history on.
  void start(const TickHistory& history)
  {
    this->Ticks.clear();
    this->Seen = history.added();
    this->Running = true;
  }
  /// Takes over what is new, at least once per length of the history.
  void take(const TickHistory& history)
  {
    if (history.added() < this->Seen)
    {
      this->Seen = 0; // the session has started anew
    }
    const std::uint64_t fresh =
      std::min<std::uint64_t>(history.added() - this->Seen, history.size());
    for (std::size_t i = history.size() - fresh; i < history.size(); ++i)
    {
      this->Ticks.push_back(history[i]);
    }
    this->Seen = history.added();
  }
  void stop() { this->Running = false; }

  bool isRunning() const { return this->Running; }
  const std::vector<Tick>& ticks() const { return this->Ticks; }

private:
  std::vector<Tick> Ticks;
  std::uint64_t Seen = 0;
  bool Running = false;
};
} // namespace palpate

#endif
