// SPDX-License-Identifier: BSD-3-Clause
// Starts a session: makes body, settings, devices and safety from its properties.
#include "vtkHapticSession.h"

#include "Haptics/Devices/DeviceFit.h"
#include "Haptics/Devices/RecordedSetup.h"
#include "Haptics/Safety/SafetySettings.h"
#include "Interaction/Session/HapticSessionState.h"
#include "Response/BodyConversion.h"
#include "Response/Bodies/SoundBody.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{
vtkIdType firstPolyOf(vtkPolyData* body)
{
  return body->GetNumberOfVerts() + body->GetNumberOfLines();
}
} // namespace

int vtkHapticSession::AddDevice(const std::string& name)
{
  constexpr int most = palpate::ServoStep::Most;
  if (this->GetNumberOfDevices() >= most)
  {
    vtkErrorMacro(<< "Device '" << name << "' cannot be added: a session has at most " << most
                  << " devices.");
    return -1;
  }
  auto device = vtkSmartPointer<vtkHapticDevice>::New();
  if (!device->Open(name))
  {
    return -1;
  }
  this->Added.push_back(device);
  this->Modified();
  return this->GetNumberOfDevices() - 1;
}

void vtkHapticSession::RemoveAddedDevices()
{
  this->Added.clear();
  this->Modified();
}

std::vector<vtkHapticDevice*> vtkHapticSession::Devices() const
{
  std::vector<vtkHapticDevice*> devices{ this->Device };
  devices.insert(devices.end(), this->Added.begin(), this->Added.end());
  return devices;
}

bool vtkHapticSession::Start()
{
  this->Run.reset();
  this->Recorder->Follow(nullptr);
  this->ReleaseDevices();
  if (!this->Known->given)
  {
    *this->Known = {}; // the known kernels are not reused, because the body may have been changed
                       // in place
  }
  this->Known->given = false;
  const auto body = this->CheckSettings() ? this->ReadBody(this->ResponseName) : nullptr;
  if (!body)
  {
    return false;
  }
  this->WarnOfDefects(*body);
  std::vector<Hand> hands;
  if (this->PrepareDevices() && this->ReadSafety(hands) && this->StartRun(hands))
  {
    return true;
  }
  this->ReleaseDevices();
  return false;
}

bool vtkHapticSession::PrepareDevices()
{
  double bounds[6];
  this->Body->GetBounds(bounds);
  const auto body = this->ReadBody(this->ResponseName);
  const auto devices = this->Devices();
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    const bool isTwice =
      std::find(devices.begin(), devices.begin() + static_cast<std::ptrdiff_t>(i), devices[i]) !=
      devices.begin() + static_cast<std::ptrdiff_t>(i);
    const std::string fault = isTwice
      ? "It is the same object as another device"
      : devices[i]->Prepare(body, bounds, this->RealTime, this->Rate);
    if (!fault.empty())
    {
      const std::string which = i > 0 ? "Device " + std::to_string(i) + ": " : std::string();
      vtkErrorMacro(<< which << fault << ".");
      return false;
    }
  }
  return true;
}

void vtkHapticSession::ReleaseDevices()
{
  for (vtkHapticDevice* device : this->Devices())
  {
    device->Release();
  }
}

bool vtkHapticSession::ApplyChanges()
{
  if (!this->Run || !this->Run->run->isRunning())
  {
    return true;
  }
  auto scene = this->MakeScene(this->Run->hands);
  if (!scene)
  {
    return false;
  }
  this->Run->run->change(std::move(scene));
  this->Run->run->firstPoly = firstPolyOf(this->Body);
  this->Recorder->AddSetup(this->Newest(0).time, this->GetSetup());
  for (vtkHapticDevice* device : this->Devices())
  {
    device->ChangeBody(this->ReadBody(this->ResponseName));
  }
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
  this->WarnOfDefects(*kernel);
  return kernel;
}

/// Warns of the defects of the mesh, once for each body.
void vtkHapticSession::WarnOfDefects(const palpate::ContactBody& kernel)
{
  const std::string defects = palpate::describeDefects(kernel.surface.defects());
  const bool isKnown = this->Unsound == this->Body && this->UnsoundTime == this->Body->GetMTime();
  if (!defects.empty() && !isKnown)
  {
    vtkWarningMacro(<< "The mesh of the body is not sound: " << defects << ".");
    this->Unsound = this->Body;
    this->UnsoundTime = this->Body->GetMTime();
  }
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

bool vtkHapticSession::ReadSafety(std::vector<Hand>& hands)
{
  for (vtkHapticDevice* device : this->Devices())
  {
    const palpate::SafetySettings safety =
      this->Safety->GetSettings(device->GetHand()->specification(), device->IsStiff());
    if (const palpate::SettingFault fault = palpate::faultOf(safety))
    {
      vtkErrorMacro(<< fault.words() << ".");
      return false;
    }
    hands.push_back({ safety, device->GetMapping().scale() });
  }
  return true;
}

std::unique_ptr<palpate::ServoScene> vtkHapticSession::MakeScene(const std::vector<Hand>& hands)
{
  auto body = this->CheckSettings() ? this->ReadBody(this->ResponseName) : nullptr;
  if (!body)
  {
    return nullptr;
  }
  double factor = 1.0; // all devices share one factor, so that their forces can be compared
  std::string reason;
  for (const Hand& hand : hands)
  {
    double fitted = 1.0;
    std::string why;
    if (!this->FitToDevice(hand.safety, hand.scale, fitted, why))
    {
      return nullptr;
    }
    reason = fitted < factor ? why : reason;
    factor = std::min(factor, fitted);
  }
  this->FittedFactor = factor;
  this->FitReason = reason;
  return std::make_unique<palpate::ServoScene>(
    std::move(body), this->Settings->GetKernel(), factor, hands.size());
}

bool vtkHapticSession::FitToDevice(
  const palpate::SafetySettings& safety, double scale, double& factor, std::string& reason)
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
  reason = all.reason();
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

std::shared_ptr<palpate::SessionRun> vtkHapticSession::MakeRun(const std::vector<Hand>& hands)
{
  auto scene = this->MakeScene(hands);
  if (!scene)
  {
    return nullptr;
  }
  vtkHapticRecorder* recorder = this->Recorder;
  const palpate::TicksKept kept{ recorder->GetRecording(), recorder->GetHistorySeconds(),
    recorder->GetTape() };
  palpate::ServoLoopSettings settings;
  settings.rate = this->Rate;
  settings.recordedSeconds = kept.all
    ? recorder->GetRecordedSeconds()
    : std::min(recorder->GetRecordedSeconds(), kept.historySeconds);
  settings.realTime.lockMemory = this->LockMemory;
  settings.rehearsal = this->Rehearsal;
  palpate::SessionHands devices;
  std::vector<palpate::ServoStep::Hand> ends;
  for (vtkHapticDevice* device : this->Devices())
  {
    ends.push_back(
      { device->GetMapping(), hands[devices.size()].safety, device->GetClutchButtons() });
    devices.push_back(device->GetHand());
  }
  palpate::ServoStep step(std::move(scene), ends);
  if (!this->RealTime)
  {
    return std::make_shared<palpate::VirtualRun>(
      std::move(devices), std::move(step), this->Rate, kept);
  }
  auto live =
    std::make_shared<palpate::RealTimeRun>(std::move(devices), std::move(step), settings, kept);
  const std::string error = live->start();
  if (!error.empty())
  {
    vtkErrorMacro(<< "The servo thread does not start: " << error << ".");
    return nullptr;
  }
  return live;
}

bool vtkHapticSession::StartRun(const std::vector<Hand>& hands)
{
  auto run = this->MakeRun(hands);
  if (!run)
  {
    return false;
  }
  run->firstPoly = firstPolyOf(this->Body);
  this->Recorder->Follow(run);
  this->Recorder->AddSetup(0.0, this->GetSetup());
  this->Run = std::make_unique<Started>(Started{ hands, std::move(run) });
  ++this->Starts;
  return true;
}
