// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoLoop_h
#define palpate_ServoLoop_h

#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Servo/LatestValue.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/RealTimeGrant.h"
#include "Haptics/Servo/SampleRing.h"
#include "Haptics/Servo/SceneExchange.h"
#include "Haptics/Servo/ServoMeter.h"
#include "Haptics/Servo/ServoStep.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace palpate
{
/// The rate and the recording of a servo loop, and its requests to the system.
struct PALPATE_EXPORT ServoLoopSettings
{
  static constexpr double MaximumRate = 100000.0;
  static constexpr double MaximumRecordedTicks = 1e7; ///< corresponds to a few gigabytes

  double rate = 1000.0; ///< ticks per second, 1 to MaximumRate
  /// Time, s, for which ticks are kept for drain() before they are lost. With 0 nothing is
  /// recorded. The constructor allocates the memory, about 600 bytes per tick and device.
  double recordedSeconds = 0.0;
  /// Time, s, before each deadline at which the thread wakes up, from 0 to half a period. The
  /// thread then computes the tick in advance (ServoStep::rehearse) and waits without sleeping.
  /// Therefore the sample is read on time, and the force is sent sooner. One processor is busy
  /// during this time. With 0 there is no rehearsal.
  double rehearsal = 0.0;
  RealTimeRequest realTime;

  /// Describes the first setting that is out of its range. Returns "" if there is none.
  std::string fault() const;
};

/**
 * The servo thread. At a fixed rate it reads the devices, computes a ServoStep and writes the
 * forces to the devices. It publishes the newest tick in a slot and every tick in a ring. If there
 * are several devices, one thread reads all of them, computes their steps and writes all forces, at
 * one common time. Each device has a separate slot and ring.
 *
 * Deadlines are absolute: tick k is due k periods after the start. This due time is the time of the
 * tick, regardless of when the thread wakes up. A tick that cannot begin before the next one is due
 * is missed. Missed ticks are skipped and counted, so that a loop that is too slow still sleeps
 * between ticks. Therefore the index of the newest tick is k = ticks + missed - 1.
 *
 * The thread requests real-time scheduling and, if the settings say so, locked memory; grant()
 * returns the granted rights. A tick neither allocates, frees, locks, logs nor throws.
 *
 * Zero force is written when the loop is stopped or destroyed, including its destruction by an
 * exception in the owner. A device or step that throws, although it must not, ends the process: see
 * releaseForceOnTerminate. The last tick published after a stop has no force and has
 * SafetyLink::Stopped set.
 *
 * All public functions must be called by one thread, the owner. The device must outlive the loop.
 * The scenes share the ownership of their bodies.
 */
class PALPATE_EXPORT ServoLoop
{
public:
  ServoLoop(HapticDevice& device, ServoStep step, const ServoLoopSettings& settings);
  /// `rate` in ticks per second.
  ServoLoop(HapticDevice& device, ServoStep step, double rate);
  /// `devices` contains one device per hand of the step, none of them null. Further devices are
  /// ignored.
  ServoLoop(std::vector<HapticDevice*> devices, ServoStep step, const ServoLoopSettings& settings);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  /// Starts the ticks at time 0. A loop that is already running continues. Returns "" on success,
  /// else the fault of the settings or the reason why no thread could be created. Waits until the
  /// system has granted or refused the requests, but not until the first tick.
  std::string start();
  /// Stops the ticks. Waits for the end of the present tick, at most one period. Then waits until
  /// the devices have accepted zero force, at most about 10 ms.
  void stop();
  bool isRunning() const noexcept { return this->Thread.joinable(); }
  /// The rights granted to the thread at the last start.
  const RealTimeGrant& grant() const noexcept { return this->Grant; }

  std::size_t devices() const noexcept { return this->Devices.size(); }
  /// The newest tick of a device. Before the first tick it is a default tick.
  const Tick& newest(std::size_t device = 0) noexcept
  {
    return this->Channels[device]->latest.read();
  }
  /// Calls sink(const Tick&) for every recorded tick since the last drain, oldest first. Returns
  /// the number of ticks. Also works after a stop. The statistics count the ticks that were lost
  /// because there was no space.
  template <class Sink>
  std::size_t drain(Sink&& sink, std::size_t device = 0)
  {
    return this->Channels[device]->recording.drain(sink);
  }

  /// Changes to another scene at the next tick, or at the next start. The force changes to that of
  /// the new scene within 50 ms (ServoStep). If several scenes are passed in quick succession, only
  /// the newest is certain to be rendered. Frees the scenes that are no longer in use. The scene
  /// must be made for the number of devices.
  void changeScene(std::unique_ptr<ServoScene> scene);
  /// Frees the scenes that are no longer in use. To be called some time after a change. Returns the
  /// number of freed scenes.
  std::size_t freeScenes() noexcept { return this->Scenes.collect(); }

  /// Statistics since the construction or the last reset. Some counts may differ by one tick, see
  /// ServoMeter. Samples, forces and errors are the sums over all devices.
  ServoStatistics statistics() const;
  void resetStatistics();
  /// Number of ticks since the construction.
  std::uint64_t ticks() const noexcept { return this->Meter.ticks.total(); }
  std::uint64_t missed() const noexcept { return this->Meter.missed.total(); }
  /// Number of ticks that drain() cannot return, because the ring was full.
  std::uint64_t overruns() const noexcept;

private:
  /// The data of one device that the owner reads.
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
  /// Waits until `deadline` (ns) and computes a rehearsal before it. `time` (s) is the time of the
  /// tick at the deadline.
  void wait(std::int64_t deadline, double time) noexcept;
  /// Computes the next tick in advance, and prefetches the memory to which the next tick will be
  /// written.
  void rehearse(double time) noexcept;
  /// Writes zero force to the devices and sets it in the step and in the published tick.
  void finish() noexcept;
  DeviceErrors errors() const;

  std::vector<HapticDevice*> Devices;
  ServoStep Step;
  ServoLoopSettings Settings;
  std::vector<std::unique_ptr<Channel>> Channels;
  // The arrays below have one element for each device.
  std::array<DeviceSample, ServoStep::Most> Samples;
  /// The last samples, extrapolated by their last displacements.
  std::array<DeviceSample, ServoStep::Most> Likely;
  std::array<Tick, ServoStep::Most> Newest;
  std::array<Tick, ServoStep::Most> Rehearsed;
  SceneExchange<ServoScene> Scenes;
  ServoMeter Meter;
  std::atomic<bool> Stopping{ false };

  RealTimeGrant Grant;       ///< this member and all members below are used only by the owner
  DeviceErrors ErrorsBefore; ///< errors at the last reset of the statistics
  std::uint64_t OverrunsBefore = 0; ///< overruns at the last reset of the statistics
  std::thread Thread;
};
} // namespace palpate

#endif
