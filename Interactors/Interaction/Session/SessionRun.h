// SPDX-License-Identifier: BSD-3-Clause
#ifndef SessionRun_h
#define SessionRun_h

#include "Haptics/Servo/ServoLoop.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Servo/TickHistory.h"
#include "Interaction/Session/TicksKept.h"

#include "vtkType.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// The devices of a session, at least one.
using SessionHands = std::vector<std::shared_ptr<HapticDevice>>;

/// The devices and their servo step from one Start of a session to the next. Only the thread of the
/// session may use it. History and tape record the first device.
class SessionRun
{
public:
  /// `rate` is in ticks per second.
  SessionRun(SessionHands hands, double rate, const TicksKept& kept)
    : Hands(std::move(hands))
    , KeepsAll(kept.all)
    , Tape(kept.tape)
    , History(kept.historySeconds, rate)
    , Kept(this->Hands.size())
  {
  }
  virtual ~SessionRun() = default;
  SessionRun(const SessionRun&) = delete;
  SessionRun& operator=(const SessionRun&) = delete;

  /// Stops the run. After the stop no device exerts a force.
  virtual void stop() = 0;
  virtual bool isRunning() const = 0;
  /// Replaces the servo scene.
  virtual void change(std::unique_ptr<ServoScene> scene) = 0;
  /// In virtual time, computes all ticks that are due in the next `seconds` s.
  virtual void step(double seconds) = 0;
  /// Virtual time of the next tick, s. 0 in real time.
  virtual double time() const = 0;

  std::size_t hands() const { return this->Hands.size(); }
  /// Newest tick of a device. Before the first tick it is a default tick.
  virtual const Tick& newest(std::size_t hand) = 0;
  /// Collects the ticks recorded since the last call.
  virtual void collect() = 0;
  virtual std::uint64_t ticksMade() const = 0;
  /// The loop of the servo thread; null in virtual time.
  virtual ServoLoop* loop() { return nullptr; }

  /// All ticks of a device until the last collect(), if ticks are recorded.
  const std::vector<Tick>& ticks(std::size_t hand) const { return this->Kept[hand].ticks; }
  /// The ticks of the history.
  const TickHistory& history() const { return this->History; }
  const TickSummary& summary(std::size_t hand) const { return this->Kept[hand].summary; }
  /// In virtual time, the duration of each recorded tick, ns.
  const std::vector<double>& nanoseconds() const { return this->Nanoseconds; }

  vtkIdType firstPoly = 0; ///< cell id of the first triangle of the newest body

protected:
  struct HandTicks
  {
    std::vector<Tick> ticks;
    TickSummary summary;
  };

  void keep(std::size_t hand, const Tick& tick)
  {
    this->Kept[hand].summary.add(tick);
    if (hand == 0)
    {
      this->History.add(tick);
      this->Tape->add(tick);
    }
    if (this->KeepsAll)
    {
      this->Kept[hand].ticks.push_back(tick);
    }
  }

  SessionHands Hands;
  bool KeepsAll;
  std::shared_ptr<TickTape> Tape;
  TickHistory History;
  std::vector<HandTicks> Kept;
  std::vector<double> Nanoseconds;
};

/// A run in virtual time, on the caller's thread. Only nanoseconds() depends on the machine.
class VirtualRun final : public SessionRun
{
public:
  VirtualRun(SessionHands hands, ServoStep servo, double rate, const TicksKept& kept);
  ~VirtualRun() override { this->stop(); }

  void stop() override;
  bool isRunning() const override { return this->Running; }
  void change(std::unique_ptr<ServoScene> scene) override;
  void step(double seconds) override;
  double time() const override;
  const Tick& newest(std::size_t hand) override { return this->Newest[hand]; }
  void collect() override {}
  std::uint64_t ticksMade() const override { return this->summary(0).ticks; }

private:
  void tick();

  ServoStep Step;
  double Period;
  double ReachedTime =
    0.0; ///< sum of all steps so far, s; the last tick is less than one period before it
  bool Running = true;
  std::vector<DeviceSample> Samples;
  std::vector<Tick> Newest;
};

/// A run on the servo thread.
class RealTimeRun final : public SessionRun
{
public:
  RealTimeRun(
    SessionHands hands, ServoStep servo, const ServoLoopSettings& settings, const TicksKept& kept);

  /// Starts the loop. Returns "" or an error.
  std::string start() { return this->Loop.start(); }
  void stop() override { this->Loop.stop(); }
  bool isRunning() const override { return this->Loop.isRunning(); }
  void change(std::unique_ptr<ServoScene> scene) override;
  void step(double) override {}
  double time() const override { return 0.0; }
  const Tick& newest(std::size_t hand) override;
  void collect() override;
  std::uint64_t ticksMade() const override { return this->Loop.ticks(); }
  ServoLoop* loop() override { return &this->Loop; }

private:
  ServoLoop Loop; ///< must be declared after the devices, so that it is destroyed before them
};
} // namespace palpate

#endif
