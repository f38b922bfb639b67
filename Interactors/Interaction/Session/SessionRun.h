// SPDX-License-Identifier: BSD-3-Clause
#ifndef SessionRun_h
#define SessionRun_h

#include "Haptics/Servo/HandsStep.h"
#include "Haptics/Servo/ServoLoop.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Servo/TickHistory.h"
#include "Interaction/Session/TicksKept.h"

#include "vtkType.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// The devices of a session, at least one.
using SessionHands = std::vector<std::shared_ptr<HapticDevice>>;

/// The devices and their servo step, from one Start of a session to the next. For the thread that
/// owns the session. History and tape are of the first device.
class SessionRun
{
public:
  /// `rate` in ticks per second.
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

  /// Leaves no force on the devices.
  virtual void stop() = 0;
  virtual bool isRunning() const = 0;
  /// Changes the force to another servo scene.
  virtual void change(std::unique_ptr<ServoScene> scene) = 0;
  /// In virtual time, runs all ticks due in the next `seconds`.
  virtual void step(double seconds) = 0;
  /// Virtual time, s, of the next tick; 0 in real time.
  virtual double time() const = 0;

  std::size_t hands() const { return this->Hands.size(); }
  /// The newest tick of a device; a default one before the first.
  virtual const Tick& newest(std::size_t hand) = 0;
  /// Collects what has been recorded meanwhile.
  virtual void collect() = 0;
  virtual std::uint64_t ticksMade() const = 0;
  /// The loop of the servo thread; null in virtual time.
  virtual ServoLoop* loop() { return nullptr; }

  /// Every tick of a device up to the last collect(), if recorded.
  const std::vector<Tick>& ticks(std::size_t hand) const { return this->Kept[hand].ticks; }
  /// The last ticks, as far as they are kept.
  const TickHistory& history() const { return this->History; }
  const TickSummary& summary(std::size_t hand) const { return this->Kept[hand].summary; }
  /// Time each recorded tick took, in virtual time.
  const std::vector<double>& nanoseconds() const { return this->Nanoseconds; }

  vtkIdType firstPoly = 0; ///< cell id of the newest body's first triangle

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

/// In virtual time, on the caller's thread; nothing depends on the machine but nanoseconds().
class VirtualRun final : public SessionRun
{
public:
  VirtualRun(
    std::shared_ptr<HapticDevice> hand, ServoStep servo, double rate, const TicksKept& kept);
  /// Of several devices.
  VirtualRun(SessionHands hands, HandsStep servo, double rate, const TicksKept& kept);
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
  void stepAll(double time);

  std::optional<ServoStep> Step;     ///< of one device
  std::optional<HandsStep> Together; ///< of several, instead
  double Period;
  double Reached = 0.0; ///< time stepped to so far, s; ticks fall behind by less than one
  bool Running = true;
  std::vector<Tick> Newest;
};

/// On the servo thread.
class RealTimeRun final : public SessionRun
{
public:
  RealTimeRun(std::shared_ptr<HapticDevice> hand, ServoStep servo,
    const ServoLoopSettings& settings, const TicksKept& kept);
  /// Of several devices.
  RealTimeRun(
    SessionHands hands, HandsStep servo, const ServoLoopSettings& settings, const TicksKept& kept);

  /// Returns an error, or "".
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
  ServoLoop Loop; ///< after the devices, so that it is destroyed first
};
} // namespace palpate

#endif
