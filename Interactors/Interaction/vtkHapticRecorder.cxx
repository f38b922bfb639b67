// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRecorder.h"

#include "Interaction/Session/SessionRun.h"
#include "Interaction/Session/TickRecording.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkHapticRecorder);

vtkHapticRecorder::vtkHapticRecorder()
  : Tape(std::make_shared<palpate::TickTape>())
  , Setups(std::make_unique<palpate::RecordedSetups>())
{
}

vtkHapticRecorder::~vtkHapticRecorder() = default;

void vtkHapticRecorder::Follow(const std::shared_ptr<palpate::SessionRun>& run)
{
  this->Run = run;
  this->Setups->clear();
  if (run)
  {
    this->Tape->beginRun();
  }
}

const palpate::RecordedSetups& vtkHapticRecorder::GetSetups() const
{
  return *this->Setups;
}

void vtkHapticRecorder::AddSetup(double time, const palpate::RecordedSetup& setup)
{
  this->Setups->add(time, setup);
  this->Tape->note(time, setup);
  if (!this->Recording)
  {
    this->Setups->keepNewest();
  }
}

/// Collects the newly recorded ticks. Returns the run of the session, or null if there is none.
palpate::SessionRun* vtkHapticRecorder::Collected()
{
  palpate::SessionRun* run = this->Run.lock().get();
  if (run)
  {
    run->collect();
  }
  return run;
}

const palpate::ServoLoop* vtkHapticRecorder::Loop()
{
  const auto run = this->Run.lock();
  return run ? run->loop() : nullptr;
}

namespace
{
bool has(const palpate::SessionRun* run, int device)
{
  return run && device >= 0 && static_cast<std::size_t>(device) < run->hands();
}
} // namespace

const std::vector<palpate::Tick>& vtkHapticRecorder::GetTicks()
{
  return this->GetTicks(0);
}

const std::vector<palpate::Tick>& vtkHapticRecorder::GetTicks(int device)
{
  static const std::vector<palpate::Tick> none;
  const palpate::SessionRun* run = this->Collected();
  return has(run, device) ? run->ticks(static_cast<std::size_t>(device)) : none;
}

const palpate::TickHistory& vtkHapticRecorder::GetLastTicks()
{
  static const palpate::TickHistory none(0.0, 1.0);
  const palpate::SessionRun* run = this->Collected();
  return run ? run->history() : none;
}

const std::shared_ptr<palpate::TickTape>& vtkHapticRecorder::GetTape()
{
  this->Collected();
  return this->Tape;
}

void vtkHapticRecorder::GetRecording(vtkPolyData* recording)
{
  this->GetRecording(recording, 0);
}

void vtkHapticRecorder::GetRecording(vtkPolyData* recording, int device)
{
  const auto& ticks = this->GetTicks(device);
  const auto run = this->Run.lock();
  palpate::fillRecording(ticks, run ? run->firstPoly : 0, recording);
}

void vtkHapticRecorder::GetHistory(vtkPolyData* history)
{
  const auto& ticks = this->GetLastTicks();
  const auto run = this->Run.lock();
  palpate::fillRecording(ticks, run ? run->firstPoly : 0, history);
}

vtkIdType vtkHapticRecorder::GetNumberOfMissedTicks()
{
  const palpate::ServoLoop* loop = this->Loop();
  return loop ? static_cast<vtkIdType>(loop->missed()) : 0;
}

vtkIdType vtkHapticRecorder::GetNumberOfLostTicks()
{
  const palpate::ServoLoop* loop = this->Loop();
  return loop ? static_cast<vtkIdType>(loop->overruns()) : 0;
}

void vtkHapticRecorder::GetStatistics(vtkTable* statistics)
{
  this->GetStatistics(statistics, 0);
}

void vtkHapticRecorder::GetStatistics(vtkTable* statistics, int device)
{
  palpate::SessionRun* run = this->Collected();
  const bool isThere = has(run, device);
  const auto hand = static_cast<std::size_t>(device);
  const palpate::ServoLoop* loop = this->Loop();
  if (isThere && loop)
  {
    palpate::fillStatistics(run->summary(hand), loop->statistics(), statistics);
  }
  else if (isThere)
  {
    palpate::fillStatistics(run->summary(hand), run->nanoseconds(), statistics);
  }
  else
  {
    palpate::fillStatistics({}, std::vector<double>(), statistics);
  }
}

std::string vtkHapticRecorder::GetStatisticsText()
{
  const palpate::ServoLoop* loop = this->Loop();
  return loop ? loop->statistics().describe() : std::string();
}

void vtkHapticRecorder::GetTiming(vtkTable* timing)
{
  timing->Initialize();
  if (const palpate::ServoLoop* loop = this->Loop())
  {
    palpate::fillTiming(loop->statistics(), timing);
  }
}

void vtkHapticRecorder::GetTimingHistogram(vtkTable* histogram)
{
  histogram->Initialize();
  if (const palpate::ServoLoop* loop = this->Loop())
  {
    palpate::fillTimingHistogram(loop->statistics(), histogram);
  }
}

std::string vtkHapticRecorder::GetRealTimeGrant()
{
  const palpate::ServoLoop* loop = this->Loop();
  return loop ? loop->grant().describe() : std::string();
}

void vtkHapticRecorder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Recording: " << this->Recording << "\n";
  os << indent << "RecordedSeconds: " << this->RecordedSeconds << " s\n";
  os << indent << "HistorySeconds: " << this->HistorySeconds << " s\n";
}
