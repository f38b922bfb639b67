// SPDX-License-Identifier: BSD-3-Clause
#include "SoakRun.h"

#include "Interaction/Session/BodyKernels.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Servo/TickHistory.h"

#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

namespace palpate::endurance
{
namespace
{
constexpr double KeptSeconds = 10.0; // longest delay of the checker, s
constexpr double LastSwapSeconds = 5.0;
constexpr std::size_t ToldFaults = 10;
constexpr std::chrono::milliseconds Pause{ 5 };

DeviceFrame makeFrame()
{
  DeviceFrame frame;
  frame.axes = Eigen::AngleAxisd(0.7, Vector3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  frame.origin = Vector3(10.0, -5.0, 2.0);
  frame.scale = 1.25;
  return frame;
}

BodyKernels kernelsOf(const SuppliedScene& scene)
{
  BodyKernels kernels;
  kernels.read[SceneSupply::ResponseName] = scene.kernel;
  return kernels;
}
} // namespace

SoakRun::SoakRun(const SoakOptions& options)
  : Options(options)
  , Frame(makeFrame())
  , Specification(specificationOf(DeviceLimits{}, options.rate))
  , Scenes(options.seed)
  , Devices(Frame, Specification, Scenes.centre(), SceneSupply::Radius, options.seed + 1)
  , Memory(static_cast<std::size_t>(2.0 * options.seconds / options.swapEvery) + 100)
{
}

std::string SoakRun::start()
{
  SuppliedScene first = this->Scenes.make();
  if (!first.kernel)
  {
    return first.error;
  }
  this->Checker = std::make_unique<TickChecker>(this->Frame, DeviceLimits{}, first.felt);
  this->Bodies.emplace_back(first.kernel);
  if (this->Options.draws)
  {
    this->Drawing.show(first.body);
    this->Drawing.start();
  }
  auto device = std::make_unique<UnsteadyDevice>(
    this->Specification, static_cast<std::size_t>(KeptSeconds * this->Options.rate));
  this->Device = device.get();
  this->Session = vtkSmartPointer<vtkHapticSession>::New();
  this->Session->GetDevice()->Use(std::move(device));
  this->Session->SetBody(first.body, kernelsOf(first));
  this->Session->SetResponseName(SceneSupply::ResponseName);
  this->Session->GetSettings()->SetFrictionCoefficient(first.felt.friction);
  this->Session->GetSettings()->SetRelaxationElements(first.felt.elements);
  const Vector3 right = this->Frame.axes.col(0);
  const Vector3 up = this->Frame.axes.col(1);
  this->Session->GetDevice()->SetRight(right.x(), right.y(), right.z());
  this->Session->GetDevice()->SetUp(up.x(), up.y(), up.z());
  this->Session->GetDevice()->SetOrigin(
    this->Frame.origin.x(), this->Frame.origin.y(), this->Frame.origin.z());
  this->Session->GetDevice()->SetScale(this->Frame.scale);
  this->Session->SetRate(this->Options.rate);
  this->Session->RealTimeOn();
  this->Session->GetRecorder()->RecordingOff();
  this->Session->GetRecorder()->SetRecordedSeconds(KeptSeconds);
  this->Session->GetRecorder()->SetHistorySeconds(KeptSeconds);
  return this->Session->Start() ? "" : "the session did not start";
}

void SoakRun::run()
{
  const auto begin = Clock::now();
  const auto period = std::chrono::duration_cast<Clock::duration>(
    std::chrono::duration<double>(this->Options.swapEvery));
  auto nextSwap = begin + period;
  std::chrono::duration<double> passed{};
  // The run waits for the last swap. If this swap does not occur, the end of the run reports it.
  const auto goesOn = [&]
  {
    return passed.count() < this->Options.seconds ||
      (!this->isSettled() && passed.count() < this->Options.seconds + LastSwapSeconds);
  };
  while (goesOn())
  {
    std::this_thread::sleep_for(Pause);
    this->drain();
    if (this->Device->wantsDevice())
    {
      this->Device->offer(this->Devices.make());
    }
    const auto now = Clock::now();
    if (now >= nextSwap && passed.count() < this->Options.seconds && this->isSettled())
    {
      this->Memory.read(); // always with one body alive
      this->swap();
      nextSwap = std::max(nextSwap + period, now);
    }
    passed = now - begin;
  }
  this->Result.seconds = passed.count();
}

/// Returns true if only one body is in contact, and the previous body was released some ticks
/// before the last drain began. That drain freed the previous body.
bool SoakRun::isSettled() const
{
  constexpr std::uint64_t some = 200;
  const SceneRule& scenes = this->Checker->scenes();
  return this->Swaps.seen() == this->Swaps.asked() && !scenes.isChanging() &&
    this->CheckedBefore > this->SettledAt + some;
}

void SoakRun::swap()
{
  this->Result.bodiesKept += this->bodiesAlive() > 1 ? 1 : 0;
  this->Bodies.erase(std::remove_if(this->Bodies.begin(), this->Bodies.end(),
                       [](const auto& body) { return body.expired(); }),
    this->Bodies.end());
  const SuppliedScene next = this->Scenes.make();
  if (!next.kernel)
  {
    this->Result.faults.push_back("no kernel: " + next.error);
    return;
  }
  this->Bodies.emplace_back(next.kernel);
  this->Checker->offer(next.felt);
  this->Session->SetBody(next.body, kernelsOf(next));
  this->Session->GetSettings()->SetFrictionCoefficient(next.felt.friction);
  this->Session->GetSettings()->SetRelaxationElements(next.felt.elements);
  if (!this->Session->ApplyChanges())
  {
    this->Result.faults.emplace_back("a swap was refused");
  }
  this->Swaps.ask(static_cast<std::uint64_t>(this->Session->GetNumberOfTicks()));
  if (this->Options.draws)
  {
    this->Drawing.show(next.body);
  }
}

void SoakRun::drain()
{
  this->CheckedBefore = this->Checked;
  const TickHistory& ticks = this->Session->GetRecorder()->GetLastTicks();
  // The records are drained after the ticks, because a tick's record is complete only when its
  // force has been written.
  this->Device->drain([this](const DeviceRecord& record) { this->Records.push_back(record); });
  const std::uint64_t fresh = ticks.added() - this->Checked;
  if (fresh > ticks.size() || fresh > this->Records.size())
  {
    this->Result.faults.push_back("ticks were recorded that can no more be seen");
    ++this->Result.overruns;
    this->Checked = ticks.added();
    this->Records.clear();
    return;
  }
  const std::size_t first = ticks.size() - fresh;
  for (std::size_t i = 0; i < fresh; ++i)
  {
    this->check(ticks[first + i], this->Records[i]);
  }
  this->Records.erase(
    this->Records.begin(), this->Records.begin() + static_cast<std::ptrdiff_t>(fresh));
  if (fresh > 0)
  {
    this->Drawing.move(ticks[ticks.size() - 1].tip);
  }
}

void SoakRun::check(const Tick& tick, const DeviceRecord& record)
{
  TickVerdict verdict =
    this->Checker->check(factsOf(record.time, record.sample, record.sent, tick));
  if (tick.time != record.time)
  {
    verdict = { TickFault::Record, "a tick was recorded with another time than the device's" };
    ++this->Result.overruns;
  }
  if (verdict && this->Result.faults.size() < ToldFaults)
  {
    this->Result.faults.push_back(verdict.text);
  }
  const std::uint64_t number = this->Checked++;
  this->Swaps.see(number, tick.scene);
  if (this->Checker->scenes().isChanging())
  {
    this->SettledAt = number;
  }
}

std::size_t SoakRun::bodiesAlive() const
{
  return static_cast<std::size_t>(std::count_if(
    this->Bodies.begin(), this->Bodies.end(), [](const auto& body) { return !body.expired(); }));
}

void SoakRun::readTiming(SoakResult& result)
{
  vtkNew<vtkTable> timing;
  this->Session->GetRecorder()->GetTiming(timing);
  for (vtkIdType row = 0; row < timing->GetNumberOfRows(); ++row)
  {
    const double share = timing->GetValueByName(row, "Share").ToDouble();
    const double wakeUp = timing->GetValueByName(row, "WakeUp (us)").ToDouble();
    const std::array<double, 3> shares = { 0.5, 0.99, 1.0 };
    for (std::size_t i = 0; i < shares.size(); ++i)
    {
      result.wakeUp[i] = std::abs(share - shares[i]) < 1e-9 ? wakeUp : result.wakeUp[i];
    }
  }
}

SoakResult SoakRun::finish()
{
  this->Session->Stop();
  this->drain();
  SoakResult& result = this->Result;
  result.rate = this->Options.rate;
  result.granted = this->Session->GetRecorder()->GetRealTimeGrant();
  result.ticks = static_cast<std::uint64_t>(this->Session->GetNumberOfTicks());
  result.missed =
    static_cast<std::uint64_t>(this->Session->GetRecorder()->GetNumberOfMissedTicks());
  result.overruns +=
    static_cast<std::uint64_t>(this->Session->GetRecorder()->GetNumberOfLostTicks());
  result.overruns += this->Device->overruns();
  result.tally = this->Checker->tally();
  result.swapsAsked = this->Swaps.asked();
  result.swapsSeen = this->Swaps.seen();
  result.swapsLate = this->Swaps.late();
  result.troubles = this->Device->troubles();
  result.isForceLeft = !(this->Device->lastForce().array() == 0.0).all();
  this->readTiming(result);
  result.resident = this->Memory.resident();
  result.heap = this->Memory.heap();
  this->Drawing.stop();
  result.isDrawn = this->Options.draws;
  result.frames = this->Drawing.frames();
  this->Session = nullptr;
  result.bodiesAlive = this->bodiesAlive();
  return result;
}
} // namespace palpate::endurance
