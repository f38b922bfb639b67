// SPDX-License-Identifier: BSD-3-Clause
// The wake-up delay of the servo thread and the duration of its ticks, at several rates, on an idle
// machine and during rendering. Normal scheduling and SCHED_FIFO alternate. A simulated hand slides
// about 1 mm deep along a bumpy sphere. See README.md.
#include "BackgroundLoad.h"
#include "BumpySphere.h"
#include "Contact/ContactBody.h"
#include "SampleResponses.h"
#include "Haptics/Servo/ServoLoop.h"
#include "ServoReport.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace palpate;
using namespace palpate::benchmarks;
using palpate::testing::Surface;

constexpr double Triangles = 200e3;
constexpr double Depth = 1.0;    // mm
constexpr double Speed = 100.0;  // mm/s
constexpr int OutsideTicks = 20; // the device starts outside the body, as the safety chain requires
constexpr double SliceTime =
  1.0; // s; the two scheduling policies alternate in slices of this length
constexpr double Rehearsal = 50e-6; // s of SCHED_FIFO: twice the longest wake-up time

struct Options
{
  std::vector<double> rates{ 1000.0, 4000.0, 8000.0 };
  double seconds = 5.0;
  std::string load = "auto";
  std::string output = ".";
  bool quick = false;
};

/// A hand that repeatedly winds around the body and back.
class WindingDevice final : public HapticDevice
{
public:
  explicit WindingDevice(double rate)
    : Rate(rate)
    , Tips(testing::windingTips(TipCount, Depth, Speed / rate))
  {
  }
  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  DeviceSample read(double time) noexcept override
  {
    this->Reads = time > 0.0 ? this->Reads + 1 : 0;
    const auto tick = static_cast<std::size_t>(time * this->Rate + 0.5);
    const std::size_t turn = tick % (2 * TipCount);
    const Vector3& tip = this->Tips[turn < TipCount ? turn : 2 * TipCount - 1 - turn];
    DeviceSample sample;
    // At 2 % more distance the tip is outside the body, because the bumps are 1 % of the radius.
    sample.position = (this->Reads < OutsideTicks ? 1.02e-3 : 1e-3) * tip;
    sample.valid = true;
    return sample;
  }
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    this->Pressed += force.isZero() ? 0 : 1;
    return true;
  }
  /// Number of ticks with a force. Read it only while no loop runs.
  std::uint64_t Pressed = 0;

private:
  static constexpr std::size_t TipCount = 20000;

  DeviceSpecification Limits;
  double Rate;
  std::vector<Vector3> Tips;
  int Reads = 0; ///< number of reads since the loop was started
};

std::shared_ptr<const ContactBody> makeBody()
{
  const Surface surface = testing::bumpySphere(testing::bumpyCuts(Triangles));
  testing::ResponseStore responses(surface.points.size());
  responses.normalsFromPoints(surface);
  return testing::contactBody(surface, responses);
}

/// A loop and its device. Runners run alternately.
struct Runner
{
  Runner(const std::shared_ptr<const ContactBody>& body, double rate, int priority,
    double rehearsal = 0.0)
    : device(rate)
    , loop(device, makeStep(body, this->device), settingsOf(rate, priority, rehearsal))
  {
  }
  static ServoStep makeStep(
    const std::shared_ptr<const ContactBody>& body, const HapticDevice& device)
  {
    ContactSettings contact;
    contact.friction.coefficient = 0.5;
    return { std::make_unique<ServoScene>(body, contact), WorkspaceMapping(),
      SafetySettings::of(device.specification()) };
  }
  static ServoLoopSettings settingsOf(double rate, int priority, double rehearsal)
  {
    ServoLoopSettings settings;
    settings.rate = rate;
    settings.rehearsal = rehearsal;
    settings.recordedSeconds = 2.0 * SliceTime + 1.0;
    settings.realTime = { priority, true };
    return settings;
  }
  /// Runs the loop under the load. Returns false if the system refused the requested scheduling.
  bool runBeside(BackgroundLoad& load, double seconds)
  {
    const std::string fault = this->loop.start();
    if (!fault.empty() || this->loop.grant().priority != this->loop.grant().request.priority)
    {
      this->loop.stop();
      std::printf(
        "not run: %s\n", fault.empty() ? this->loop.grant().describe().c_str() : fault.c_str());
      return false;
    }
    load.runFor(seconds);
    this->loop.stop();
    this->loop.drain([](const Tick&) {});
    return true;
  }

  WindingDevice device;
  ServoLoop loop;
};

/// Processor time, summed over all processors since the start of the machine, in the kernel's unit
/// of time.
struct ProcessorTime
{
  double all = 0.0;
  double idle = 0.0;
};

ProcessorTime processorTime()
{
  constexpr int Idle = 3;
  constexpr int IdleForInput = 4;
  constexpr int Stolen = 7; // the later fields are included in the first two
  ProcessorTime time;
  std::ifstream file("/proc/stat");
  std::string name;
  file >> name;
  double ticks = 0.0;
  for (int field = 0; field <= Stolen && file >> ticks; ++field)
  {
    time.all += ticks;
    time.idle += field == Idle || field == IdleForInput ? ticks : 0.0;
  }
  return time;
}

/// Measures the rows of one rate under one load and appends them to `rows`. Returns false if a loop
/// had no contact.
bool runRate(const std::shared_ptr<const ContactBody>& body, double rate, BackgroundLoad& load,
  double seconds, std::vector<ServoRow>& rows)
{
  struct Turn
  {
    const char* policy;
    std::unique_ptr<Runner> runner;
    bool granted = true;
  };
  std::vector<Turn> turns;
  turns.push_back({ "SCHED_OTHER", std::make_unique<Runner>(body, rate, 0) });
  turns.push_back({ "SCHED_FIFO", std::make_unique<Runner>(body, rate, 80) });
  turns.push_back({ "rehearsed", std::make_unique<Runner>(body, rate, 80, Rehearsal) });
  const double slice = std::min(seconds, SliceTime);
  for (double passed = 0.0; passed < seconds - 0.5 * slice; passed += slice)
  {
    for (Turn& turn : turns)
    {
      turn.granted = turn.granted && turn.runner->runBeside(load, slice);
    }
  }
  bool felt = true;
  for (const Turn& turn : turns)
  {
    if (turn.granted)
    {
      rows.push_back({ rate, load.name(), turn.policy, turn.runner->loop.statistics() });
      printServoRow(rows.back());
      felt = felt && turn.runner->device.Pressed > turn.runner->loop.ticks() / 4;
    }
  }
  return felt;
}

std::vector<std::unique_ptr<BackgroundLoad>> makeLoads(const Options& options)
{
  std::vector<std::unique_ptr<BackgroundLoad>> loads;
  loads.push_back(makeIdleLoad());
  if (options.load != "memory")
  {
    loads.push_back(makeRenderLoad());
    if (!loads.back())
    {
      std::printf("No DISPLAY: nothing is drawn\n");
      loads.pop_back();
    }
  }
  if (options.load != "rendering" && loads.size() == 1)
  {
    loads.push_back(makeMemoryLoad());
  }
  return loads;
}

int run(const Options& options)
{
  const std::shared_ptr<const ContactBody> body = makeBody();
  const auto loads = makeLoads(options);
  {
    Runner trial(body, options.rates.front(), 80);
    trial.loop.start();
    std::printf("Asked of the system and answered: %s\n", trial.loop.grant().describe().c_str());
  }
  for (const auto& load : loads)
  {
    std::printf("%s: %s\n", load->name().c_str(), load->describe().c_str());
  }
  printServoHeader();
  std::vector<ServoRow> rows;
  for (const auto& load : loads)
  {
    const ProcessorTime before = processorTime();
    for (const double rate : options.rates)
    {
      if (!runRate(body, rate, *load, options.seconds, rows))
      {
        std::fprintf(stderr, "palpateServoBenchmark: the tip did not touch the body\n");
        return 1;
      }
    }
    const ProcessorTime after = processorTime();
    const unsigned processors = std::thread::hardware_concurrency();
    std::printf("  %s: %.2f of %u processors were at work, for this and all other programs\n",
      load->name().c_str(),
      processors * (1.0 - (after.idle - before.idle) / (after.all - before.all)), processors);
  }
  const std::string csv = (std::filesystem::path(options.output) / "servo.csv").string();
  if (!writeServoCsv(csv, rows))
  {
    std::fprintf(stderr, "palpateServoBenchmark: cannot write '%s'\n", csv.c_str());
    return 1;
  }
  std::printf("\nresults in %s\n", csv.c_str());
  return 0;
}
} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app{ "How late the servo thread wakes up, and how long its ticks take.",
    "palpateServoBenchmark" };
  app.add_option("--rates", options.rates, "ticks per second, separated by commas")
    ->delimiter(',')
    ->check(CLI::Range(1.0, ServoLoopSettings::MaximumRate));
  app.add_option("--seconds", options.seconds, "per row")->check(CLI::Range(0.2, 3600.0));
  app
    .add_option("--load", options.load,
      "beside nothing: rendering, memory, or auto (rendering where there is a display)")
    ->check(CLI::IsMember({ "auto", "rendering", "memory" }));
  app.add_option("--output", options.output, "folder for servo.csv")->check(CLI::ExistingDirectory);
  app.add_flag("--quick", options.quick, "0.3 s per row: all rows, but poor percentiles");
  bool draw = false;
  app.add_flag(DrawOption, draw)->group(""); // used when this program starts itself
  CLI11_PARSE(app, argc, argv);
  if (draw)
  {
    drawForEver();
  }
  if (options.quick)
  {
    options.seconds = 0.3;
  }
  return run(options);
}
