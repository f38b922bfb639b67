// SPDX-License-Identifier: BSD-3-Clause
#ifndef SessionRun_h
#define SessionRun_h

#include "Haptics/Servo/ServoLoop.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Servo/TickHistory.h"
#include "Interaction/Session/TicksKept.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// A device and its servo step, from one Start of a session to the next. For the thread that owns
/// the session.
class SessionRun
{
public:
  /// `rate` in ticks per second.
  SessionRun(std::shared_ptr<HapticDevice> hand, double rate, const TicksKept& kept)
    : Device(std::move(hand))
    , KeepsAll(kept.all)
    , Tape(kept.tape)
    , History(kept.historySeconds, rate)
  {
  }
  virtual ~SessionRun() = default;
  SessionRun(const SessionRun&) = delete;
  SessionRun& operator=(const SessionRun&) = delete;

  /// Leaves no force on the device.
  virtual void stop() = 0;
  virtual bool isRunning() const = 0;
  /// The force goes over to another scene.
  virtual void change(std::unique_ptr<ServoScene> scene) = 0;
  /// Runs all ticks due in the next `seconds`, where time is virtual.
  virtual void step(double seconds) = 0;
  /// Virtual time, s, of the next tick; 0 in real time.
  virtual double time() const = 0;

  /// A default one before the first.
  virtual const Tick& newest() = 0;
  /// Takes over what has been recorded meanwhile.
  virtual void collect() = 0;
  virtual std::uint64_t ticksMade() const = 0;
  /// Of the servo thread; null where there is none.
  virtual ServoLoop* loop() { return nullptr; }

  HapticDevice& device() { return *this->Device; }
  /// Every tick, if it is recorded, until the last collect().
  const std::vector<Tick>& ticks() const { return this->Ticks; }
  /// The last ones, likewise.
  const TickHistory& history() const { return this->History; }
  const TickSummary& summary() const { return this->Summary; }
  /// Time each recorded tick took, in virtual time.
  const std::vector<double>& nanoseconds() const { return this->Nanoseconds; }

  vtkIdType firstPoly = 0; ///< cell id of the newest body's first triangle

protected:
  void keep(const Tick& tick)
  {
    this->Summary.add(tick);
    this->History.add(tick);
    this->Tape->add(tick);
    if (this->KeepsAll)
    {
      this->Ticks.push_back(tick);
    }
  }

  std::shared_ptr<HapticDevice> Device;
  bool KeepsAll;
  std::shared_ptr<TickTape> Tape;
  TickHistory History;
  std::vector<Tick> Ticks;
  std::vector<double> Nanoseconds;
  TickSummary Summary;
};

/// In virtual time, on the caller's thread; nothing depends on the machine but nanoseconds().
class VirtualRun final : public SessionRun
{
public:
  VirtualRun(
    std::shared_ptr<HapticDevice> hand, ServoStep servo, double rate, const TicksKept& kept);
  ~VirtualRun() override { this->stop(); }

  void stop() override;
  bool isRunning() const override { return this->Running; }
  void change(std::unique_ptr<ServoScene> scene) override;
  void step(double seconds) override;
  double time() const override;
  const Tick& newest() override { return this->Newest; }
  void collect() override {}
  std::uint64_t ticksMade() const override { return this->Summary.ticks; }

private:
  void tick();

  ServoStep Step;
  double Period;
  double Reached = 0.0; ///< time stepped to so far, s; ticks fall behind by less than one
  bool Running = true;
  Tick Newest;
};

/// On the servo thread.
class RealTimeRun final : public SessionRun
{
public:
  RealTimeRun(std::shared_ptr<HapticDevice> hand, ServoStep servo,
    const ServoLoopSettings& settings, const TicksKept& kept);

  /// Returns an error, or "".
  std::string start() { return this->Loop.start(); }
  void stop() override { this->Loop.stop(); }
  bool isRunning() const override { return this->Loop.isRunning(); }
  void change(std::unique_ptr<ServoScene> scene) override;
  void step(double) override {}
  double time() const override { return 0.0; }
  const Tick& newest() override;
  void collect() override;
  std::uint64_t ticksMade() const override { return this->Loop.ticks(); }
  ServoLoop* loop() override { return &this->Loop; }

private:
  ServoLoop Loop; ///< after the device, so that it ends before
};
} // namespace palpate

#endif
