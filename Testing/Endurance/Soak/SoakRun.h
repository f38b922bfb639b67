// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_SoakRun_h
#define palpate_endurance_SoakRun_h

#include "DeviceSupply.h"
#include "DrawingThread.h"
#include "MemoryWatch.h"
#include "SceneSupply.h"
#include "SoakResult.h"
#include "SwapWatch.h"
#include "TickChecker.h"
#include "UnsteadyDevice.h"

#include "vtkHapticSession.h"
#include "vtkSmartPointer.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
struct Tick;
}

namespace palpate::endurance
{
struct SoakOptions
{
  double seconds = 3600.0;
  double rate = 4000.0;   ///< Hz
  double swapEvery = 1.0; ///< s
  unsigned seed = 1;
  bool draws = true;
};

/**
 * A session in real time, as in an application (vtkHapticSession: servo thread, safety chain,
 * mapping, scenes handed over). Devices are plugged in and unplugged, bodies are swapped during
 * contact, and a picture is drawn at the same time. The calling thread drains and checks every
 * tick.
 */
class SoakRun
{
public:
  explicit SoakRun(const SoakOptions& options);

  /// Starts the run. Returns the reason why it cannot start, or "".
  std::string start();
  /// Runs for the whole time.
  void run();
  /// Ends the run.
  SoakResult finish();

private:
  using Clock = std::chrono::steady_clock;

  void swap();
  void drain();
  void check(const Tick& tick, const DeviceRecord& record);
  bool isSettled() const;
  std::size_t bodiesAlive() const;
  void readTiming(SoakResult& result);

  SoakOptions Options;
  DeviceFrame Frame;
  DeviceSpecification Specification;
  SceneSupply Scenes;
  DeviceSupply Devices;
  MemoryWatch Memory;
  DrawingThread Drawing;
  std::unique_ptr<TickChecker> Checker;
  vtkSmartPointer<vtkHapticSession> Session;
  UnsteadyDevice* Device = nullptr; ///< owned by the session

  std::vector<DeviceRecord> Records; ///< records whose ticks have not been drained yet
  std::uint64_t Checked = 0;
  std::uint64_t CheckedBefore = 0; ///< number of ticks checked when the last drain began
  SwapWatch Swaps;
  std::uint64_t SettledAt = 0; ///< the first tick with only one body in contact
  /// All bodies that may still exist.
  std::vector<std::weak_ptr<const palpate::ContactBody>> Bodies;
  SoakResult Result;
};
} // namespace palpate::endurance

#endif
