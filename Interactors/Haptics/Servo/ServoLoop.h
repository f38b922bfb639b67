// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoLoop_h
#define palpate_ServoLoop_h

#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Servo/HandsStep.h"
#include "Haptics/Servo/LatestValue.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/RealTimeGrant.h"
#include "Haptics/Servo/SampleRing.h"
#include "Haptics/Servo/SceneExchange.h"
#include "Haptics/Servo/ServoMeter.h"
#include "Haptics/Servo/ServoStep.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace palpate
{
/// How fast the loop ticks, what it keeps, what it asks of the system.
struct PALPATE_EXPORT ServoLoopSettings
{
  static constexpr double MaximumRate = 100000.0;
  static constexpr double MaximumRecordedTicks = 1e7; ///< some gigabytes

  double rate = 1000.0; ///< ticks per second, 1 to MaximumRate
  /// How long (s) ticks are kept for drain() before they are lost; 0: there is no recording. The
  /// memory is taken at once, some 600 bytes per tick and device.
  double recordedSeconds = 0.0;
  /// How long (s) before each tick is due the thread wakes up, makes the tick beforehand
  /// (ServoStep::rehearse; of several devices their contacts) and then waits without sleeping: the
  /// sample is read in time, and its force comes sooner. Takes so much of a processor; 0 (none) to
  /// half a period.
  double rehearsal = 0.0;
  RealTimeRequest realTime;

  /// What is wrong with them, or "".
  std::string fault() const;
};

/**
 * The servo thread: device → ServoStep → device at a fixed rate. The newest tick is published in a
 * slot, every tick in a ring. Or several devices → HandsStep → devices: all are read, then stepped,
 * then written, in one thread and at one time; each has a slot and a ring of its own.
 *
 * Deadlines are absolute: tick k is due k periods after the start, and that is the time it is
 * given, whenever it wakes up. A tick that cannot begin before the next one is due is missed:
 * skipped and counted, so that a loop which cannot keep up still sleeps between ticks. So the k of
 * the newest tick is ticks + missed - 1.
 *
 * The thread asks for real-time scheduling and, if told to, for locked memory; grant() tells what
 * it got. A tick neither allocates, frees, locks, logs nor throws.
 *
 * Zero force is written when the loop is stopped or destroyed, so also when an exception unwinds
 * its owner. A device or step that throws in spite of its word ends the process: see
 * releaseForceOnTerminate. The last tick published after a stop has no force and says
 * SafetyLink::Stopped.
 *
 * All that is public is for one owning thread; the device must outlive the loop, the bodies of its
 * scenes are kept alive by them.
 */
class PALPATE_EXPORT ServoLoop
{
public:
  ServoLoop(HapticDevice& device, ServoStep step, const ServoLoopSettings& settings);
  /// `rate` in ticks per second.
  ServoLoop(HapticDevice& device, ServoStep step, double rate);
  /// As many devices as the step has hands, none of them null.
  ServoLoop(std::vector<HapticDevice*> devices, HandsStep step, const ServoLoopSettings& settings);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  /// Begins to tick at time 0, or goes on if it runs. Returns what is wrong with the settings or
  /// why there is no thread, or "". Waits until the system has granted or refused, not for a tick.
  std::string start();
  /// Waits for the tick under way, at most a period.
  void stop();
  bool isRunning() const noexcept { return this->Thread.joinable(); }
  /// What the thread of the newest start was granted.
  const RealTimeGrant& grant() const noexcept { return this->Grant; }

  std::size_t devices() const noexcept { return this->Devices.size(); }
  /// The newest tick of a device; a default one before the first.
  const Tick& newest(std::size_t device = 0) noexcept
  {
    return this->Channels[device]->latest.read();
  }
  /// Calls sink(const Tick&) for every tick since the last drain, oldest first; returns how
  /// many. Also after a stop. Ticks for which there was no room are counted in the statistics.
  template <class Sink>
  std::size_t drain(Sink&& sink, std::size_t device = 0)
  {
    return this->Channels[device]->recording.drain(sink);
  }

  /// Renders another scene from the next tick on, or from the next start: the force goes over to
  /// it within 50 ms (ServoStep). Of several in quick succession the newest is certain to be
  /// rendered. Frees the scenes that are no longer in use. Of several devices: a scene made for as
  /// many, HandsStep.
  void changeScene(std::unique_ptr<ServoScene> scene);
  /// The same without another scene, some time later; returns how many were freed.
  std::size_t freeScenes() noexcept { return this->Scenes.collect(); }

  /// Since the loop was made, or since the last reset; see ServoMeter for what may differ by a
  /// tick. Samples, forces and errors are counted of each device, and summed.
  ServoStatistics statistics() const;
  void resetStatistics();
  /// Since the loop was made.
  std::uint64_t ticks() const noexcept { return this->Meter.ticks.total(); }
  std::uint64_t missed() const noexcept { return this->Meter.missed.total(); }
  /// Ticks that drain() will never see.
  std::uint64_t overruns() const noexcept;

private:
  /// What the owner is told of one device.
  struct Channel
  {
    explicit Channel(std::size_t recordedTicks)
      : recording(recordedTicks)
    {
    }
    LatestValue<Tick> latest;
    SampleRing<Tick> recording;
  };

  void run(std::promise<RealTimeGrant>& granted) noexcept;
  bool goesOn() const noexcept;
  void tick(double time) noexcept;
  void write(std::size_t device, const DeviceSample& sample, const Tick& tick) noexcept;
  void takeScene() noexcept;
  void foresee() const noexcept;
  /// Until a deadline, ns, with a rehearsal before it; `time` (s) is that of the tick then.
  void wait(std::int64_t deadline, double time) noexcept;
  /// The tick that is to come, and where it will be kept.
  void rehearse(double time) noexcept;
  /// Leaves no force: on the devices, in the step, in what is published.
  void finish() noexcept;
  DeviceErrors errors() const;

  std::vector<HapticDevice*> Devices;
  std::optional<ServoStep> Step;  ///< of one device
  std::optional<HandsStep> Hands; ///< of several, instead
  ServoLoopSettings Settings;
  std::vector<std::unique_ptr<Channel>> Channels;
  Tick Newest;         ///< of one device
  DeviceSample Likely; ///< the last sample of one device, moved on as it moved last
  Eigen::Vector3d LastPosition = Eigen::Vector3d::Zero(); ///< of that sample
  SceneExchange<ServoScene> Scenes;
  ServoMeter Meter;
  std::atomic<bool> Stopping{ false };

  RealTimeGrant Grant;              ///< the owner's, as all below
  DeviceErrors ErrorsBefore;        ///< at the last reset of the statistics
  std::uint64_t OverrunsBefore = 0; ///< likewise
  std::thread Thread;
};
} // namespace palpate

#endif
