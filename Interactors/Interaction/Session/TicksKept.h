// SPDX-License-Identifier: BSD-3-Clause
#ifndef TicksKept_h
#define TicksKept_h

#include "Haptics/Devices/RecordedSetup.h"
#include "Haptics/Servo/ServoStep.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// Counts and peaks over all ticks of a run, whether or not the ticks are stored.
struct TickSummary
{
  std::uint64_t ticks = 0;
  std::uint64_t inContact = 0;
  double peakForce = 0.0;      ///< peak of the ideal force, N
  double memoryAtPeak = 0.0;   ///< memory part of the ideal force at its peak, N
  double peakApplied = 0.0;    ///< peak of the applied force, N
  double peakFriction = 0.0;   ///< peak of the friction, N
  double peakDeflection = 0.0; ///< peak of the deflection, mm
  std::uint16_t acted = 0;     ///< all values of SafetyLink that acted in at least one tick

  void add(const Tick& tick)
  {
    this->ticks += 1;
    this->inContact += tick.contact.triangle >= 0 ? 1 : 0;
    const double force = tick.contact.force.norm();
    this->memoryAtPeak = force > this->peakForce ? tick.contact.memory : this->memoryAtPeak;
    this->peakForce = std::max(this->peakForce, force);
    this->peakApplied = std::max(this->peakApplied, tick.appliedForce.norm());
    this->peakFriction = std::max(this->peakFriction, tick.contact.friction.norm());
    this->peakDeflection = std::max(this->peakDeflection, tick.contact.deflection);
    this->acted = static_cast<std::uint16_t>(this->acted | tick.acted);
  }
};

/// Stores the ticks between start() and stop(), and the setups from which they are. The times of a
/// later run follow those of the run before.
class TickTape
{
public:
  /// Discards the stored ticks, and stores the next ticks. `present`: the setup at present; null:
  /// unknown.
  void start(const RecordedSetup* present)
  {
    this->Ticks.clear();
    this->Setups.clear();
    this->Offset = 0.0;
    if (present)
    {
      this->Setups.add(0.0, *present);
    }
    this->Running = true;
  }
  /// Called when another run begins, with the time 0.
  void beginRun()
  {
    const std::size_t count = this->Ticks.size();
    const double last = count > 0 ? this->Ticks.back().time : 0.0;
    this->Offset = count > 1 ? 2.0 * last - this->Ticks[count - 2].time : last;
  }
  /// The setup of the ticks from a time of the run on, s.
  void note(double time, const RecordedSetup& setup)
  {
    if (this->Running)
    {
      this->Setups.add(this->Offset + time, setup);
    }
  }
  void stop() { this->Running = false; }
  void add(const Tick& tick)
  {
    if (this->Running)
    {
      this->Ticks.push_back(tick);
      this->Ticks.back().time += this->Offset;
    }
  }

  bool isRunning() const { return this->Running; }
  const std::vector<Tick>& ticks() const { return this->Ticks; }
  const RecordedSetups& setups() const { return this->Setups; }

private:
  std::vector<Tick> Ticks;
  RecordedSetups Setups;
  double Offset = 0.0; ///< added to the times of the present run, s
  bool Running = false;
};

/// Settings that determine which ticks are stored.
struct TicksKept
{
  bool all = true;                ///< whether all ticks of the run are stored
  double historySeconds = 0.0;    ///< length of the history, s
  std::shared_ptr<TickTape> tape; ///< stores the ticks between its start() and stop()
};
} // namespace palpate

#endif
