// SPDX-License-Identifier: BSD-3-Clause
// From what a session was told to what runs: body, settings, device, safety.
#include "vtkHapticSession.h"

#include "Haptics/Devices/DeviceFit.h"
#include "Haptics/Safety/SafetySettings.h"
#include "Interaction/Session/HapticSessionState.h"
#include "Response/BodyConversion.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkIdType firstPolyOf(vtkPolyData* body)
{
  return body->GetNumberOfVerts() + body->GetNumberOfLines();
}
} // namespace

bool vtkHapticSession::Start()
{
  this->Run.reset();
  this->Recorder->Follow(nullptr);
  this->Device->Release();
  if (!this->Known->given)
  {
    *this->Known = {}; // the body may have been changed in place
  }
  this->Known->given = false;
  if (!this->CheckSettings() || !this->ReadBody(this->ResponseName))
  {
    return false;
  }
  double bounds[6];
  this->Body->GetBounds(bounds);
  const std::string fault = this->Device->Prepare(bounds, this->RealTime, this->Rate);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return false;
  }
  palpate::SafetySettings safety;
  if (this->ReadSafety(safety) && this->StartRun(safety))
  {
    return true;
  }
  this->Device->Release();
  return false;
}

bool vtkHapticSession::ApplyChanges()
{
  if (!this->Run || !this->Run->run->isRunning())
  {
    return true;
  }
  auto scene = this->MakeScene(this->Run->safety, this->Run->scale);
  if (!scene)
  {
    return false;
  }
  this->Run->run->change(std::move(scene));
  this->Run->run->firstPoly = firstPolyOf(this->Body);
  return true;
}

std::shared_ptr<const palpate::ContactBody> vtkHapticSession::ReadBody(
  const std::string& responseName)
{
  if (!this->Body)
  {
    vtkErrorMacro(<< "A body is required: call SetBody.");
    return nullptr;
  }
  if (this->Known->body != this->Body || this->Known->time != this->Body->GetMTime())
  {
    *this->Known = {};
    this->Known->body = this->Body;
    this->Known->time = this->Body->GetMTime();
  }
  auto& kernel = this->Known->read[responseName];
  if (kernel)
  {
    return kernel;
  }
  std::string error;
  kernel = palpate::makeContactBody(this->Body, responseName, error);
  if (!kernel)
  {
    vtkErrorMacro(<< "Wrong body: " << error << ".");
    return nullptr;
  }
  const std::string defects = palpate::describeDefects(*kernel);
  const bool isKnown = this->Unsound == this->Body && this->UnsoundTime == this->Body->GetMTime();
  if (!defects.empty() && !isKnown)
  {
    vtkWarningMacro(<< "The mesh of the body is not sound: " << defects << ".");
    this->Unsound = this->Body;
    this->UnsoundTime = this->Body->GetMTime();
  }
  return kernel;
}

bool vtkHapticSession::CheckSettings()
{
  const std::string fault = this->Settings->GetFault();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
  }
  return fault.empty();
}

bool vtkHapticSession::ReadSafety(palpate::SafetySettings& safety)
{
  safety =
    this->Safety->GetSettings(this->Device->GetHand()->specification(), this->Device->IsStiff());
  const palpate::SettingFault fault = palpate::faultOf(safety);
  if (fault)
  {
    vtkErrorMacro(<< fault.name << " " << fault.remark << ".");
  }
  return !fault;
}

std::unique_ptr<palpate::ServoScene> vtkHapticSession::MakeScene(
  const palpate::SafetySettings& safety, double scale)
{
  auto body = this->CheckSettings() ? this->ReadBody(this->ResponseName) : nullptr;
  double factor = 1.0;
  if (!body || !this->FitToDevice(safety, scale, factor))
  {
    return nullptr;
  }
  this->FittedFactor = factor;
  return std::make_unique<palpate::ServoScene>(
    std::move(body), this->Settings->GetKernel(), factor);
}

bool vtkHapticSession::FitToDevice(
  const palpate::SafetySettings& safety, double scale, double& factor)
{
  factor = 1.0;
  if (!this->Safety->GetFitForce())
  {
    return true;
  }
  const double depth = this->Safety->GetFitDepth();
  if (!(depth > 0.0 && std::isfinite(depth)))
  {
    vtkErrorMacro(<< "FitDepth must be finite and positive, but is " << depth << ".");
    return false;
  }
  palpate::DeviceSpecification device;
  device.maximumForce = safety.maximumForce;
  device.maximumStiffness = safety.maximumStiffness;
  palpate::DeviceFit all(device, scale);
  auto names = this->Safety->GetFitResponses();
  names.push_back(this->ResponseName);
  for (const std::string& name : names)
  {
    const auto body = this->ReadBody(name);
    if (!body)
    {
      return false;
    }
    auto& peaks = this->Known->peaks[{ name, depth }];
    if (!peaks)
    {
      palpate::DeviceFit one(device);
      one.include(*body, depth);
      peaks = { one.peakForce(), one.peakStiffness() };
    }
    all.include(peaks->first, peaks->second);
  }
  factor = all.factor();
  if (!(factor > 0.0))
  {
    vtkErrorMacro(
      << "The responses of the body cannot be fitted to the device: their largest force "
      << "is " << all.peakForce() << " N, their largest stiffness " << all.peakStiffness()
      << " N/mm.");
    return false;
  }
  return true;
}

bool vtkHapticSession::StartRun(const palpate::SafetySettings& safety)
{
  const palpate::WorkspaceMapping& mapping = this->Device->GetMapping();
  auto scene = this->MakeScene(safety, mapping.scale());
  if (!scene)
  {
    return false;
  }
  palpate::ServoStep step(std::move(scene), mapping, safety, this->Device->GetClutchButtons());
  vtkHapticRecorder* recorder = this->Recorder;
  const palpate::TicksKept kept{ recorder->GetRecording(), recorder->GetHistorySeconds(),
    recorder->GetTape() };
  std::shared_ptr<palpate::SessionRun> run;
  if (!this->RealTime)
  {
    run = std::make_shared<palpate::VirtualRun>(
      this->Device->GetHand(), std::move(step), this->Rate, kept);
  }
  else
  {
    palpate::ServoLoopSettings settings;
    settings.rate = this->Rate;
    settings.recordedSeconds = kept.all
      ? recorder->GetRecordedSeconds()
      : std::min(recorder->GetRecordedSeconds(), kept.historySeconds);
    settings.realTime.lockMemory = this->LockMemory;
    auto live = std::make_shared<palpate::RealTimeRun>(
      this->Device->GetHand(), std::move(step), settings, kept);
    const std::string error = live->start();
    if (!error.empty())
    {
      vtkErrorMacro(<< "The servo thread does not start: " << error << ".");
      return false;
    }
    run = std::move(live);
  }
  run->firstPoly = firstPolyOf(this->Body);
  recorder->Follow(run);
  this->Run = std::make_unique<Started>(Started{ safety, mapping.scale(), std::move(run) });
  ++this->Starts;
  return true;
}
