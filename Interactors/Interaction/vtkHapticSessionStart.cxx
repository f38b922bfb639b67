// SPDX-License-Identifier: BSD-3-Clause
// From what a session was told to what runs: body, settings, mapping, safety, device.
#include "vtkHapticSession.h"

#include "Response/BodyConversion.h"
#include "Haptics/Devices/DeviceFit.h"
#include "Interaction/Session/HapticSessionState.h"
#include "Haptics/Devices/ReplayDevice.h"
#include "Haptics/Safety/SafetyFault.h"
#include "Interaction/Session/SessionDevice.h"
#include "Haptics/Simulation/SimulatedDevice.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double FreeMargin = 10.0; // mm around a body that is fitted into a workspace

/// A polyline with times as the hand's way. Returns what is wrong, or "".
std::string readPath(
  vtkPolyData* line, const palpate::WorkspaceMapping& mapping, std::vector<palpate::WayPoint>& path)
{
  vtkDataArray* times = line ? line->GetPointData()->GetArray("Time") : nullptr;
  if (!times || line->GetNumberOfPoints() == 0)
  {
    return "The simulated device needs a path with a point array 'Time' (s)";
  }
  for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
  {
    Eigen::Vector3d position;
    line->GetPoint(i, position.data());
    path.push_back({ times->GetTuple1(i), mapping.toDevice(position) });
    if (!(std::isfinite(path.back().time) && position.allFinite()) ||
      (i > 0 && path[path.size() - 2].time > path.back().time))
    {
      return "Point " + std::to_string(i) + " of the path is not finite or goes back in time";
    }
  }
  return {};
}
} // namespace

bool vtkHapticSession::Start()
{
  this->Run.reset();
  if (!this->Known->given)
  {
    *this->Known = {}; // the body may have been changed in place
  }
  this->Known->given = false;
  if (!this->CheckSettings() || !this->ReadBody(this->ResponseName))
  {
    return false;
  }
  if (this->Chosen->kind == palpate::SessionDevice::Opened && !this->RealTime)
  {
    vtkErrorMacro(<< "This device is not in virtual time: set RealTime.");
    return false;
  }
  auto started = std::make_unique<Started>();
  return this->ReadMapping(*started) && this->MakeDevice(*started) && this->ReadSafety(*started) &&
    this->StartRun(std::move(started));
}

bool vtkHapticSession::ApplyChanges()
{
  if (!this->Run || !this->Run->run->isRunning())
  {
    return true;
  }
  auto scene = this->MakeScene(this->Run->safety, this->Run->mapping.scale());
  if (!scene)
  {
    return false;
  }
  this->Run->run->change(std::move(scene));
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

bool vtkHapticSession::ReadMapping(Started& started)
{
  const Eigen::Vector3d right(this->DeviceRight);
  const Eigen::Vector3d up(this->DeviceUp);
  Eigen::Matrix3d axes;
  axes << right.normalized(), up.normalized(), right.cross(up).normalized();
  palpate::WorkspaceMapping mapping(axes, Eigen::Vector3d(this->DeviceOrigin), this->Scale);
  if (this->Planar)
  {
    mapping = mapping.planar();
  }
  if (this->FitWorkspace)
  {
    double bounds[6];
    this->Body->GetBounds(bounds);
    mapping =
      mapping.fitted({ bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] },
        this->Chosen->specification(this->Rate).workspace, FreeMargin);
  }
  if (const palpate::SettingFault fault = mapping.fault())
  {
    vtkErrorMacro(<< "Workspace mapping: " << fault.name << " " << fault.remark << ".");
    return false;
  }
  started.mapping = mapping;
  return true;
}

bool vtkHapticSession::ReadSafety(Started& started)
{
  auto safety = palpate::SafetySettings::of(started.device->specification());
  // A limit that is NaN stays NaN, and is then named.
  safety.maximumForce = std::min(this->ForceLimit, safety.maximumForce);
  safety.maximumStiffness = std::min(this->StiffnessLimit, safety.maximumStiffness);
  safety.entryRamp = this->EntryRamp;
  safety.gate = this->Gate;
  safety.capStiffness = this->StiffnessCap;
  safety.controlPassivity = this->PassivityControl && !this->Chosen->isStiff();
  if (const palpate::SettingFault fault = palpate::faultOf(safety))
  {
    vtkErrorMacro(<< fault.name << " " << fault.remark << ".");
    return false;
  }
  started.safety = safety;
  return true;
}

bool vtkHapticSession::MakeDevice(Started& started)
{
  const palpate::DeviceSpecification limits = this->Chosen->specification(this->Rate);
  const palpate::HeldPlant& held = this->Chosen->held;
  const bool isStiff = this->Chosen->isStiff();
  started.device = this->Chosen->device;
  if (this->Chosen->kind == palpate::SessionDevice::Replay)
  {
    const auto replay =
      std::make_shared<palpate::ReplayDevice>(this->Chosen->trajectory, started.mapping, limits);
    started.pathDuration = replay->duration();
    started.device = replay;
  }
  else if (this->Chosen->isSimulated() && this->RealTime)
  {
    const Eigen::Vector3d start = started.mapping.toDevice(Eigen::Vector3d(this->Steered));
    const auto hand = isStiff
      ? std::make_shared<palpate::SimulatedDevice>(start, limits)
      : std::make_shared<palpate::SimulatedDevice>(held.plant, held.hand, start, limits);
    started.steered = hand.get();
    started.device = hand;
  }
  else if (this->Chosen->isSimulated())
  {
    std::vector<palpate::WayPoint> path;
    const std::string fault = readPath(this->Path, started.mapping, path);
    if (!fault.empty())
    {
      vtkErrorMacro(<< fault << ".");
      return false;
    }
    started.pathDuration = path.back().time;
    started.device = isStiff
      ? std::make_shared<palpate::SimulatedDevice>(std::move(path), limits)
      : std::make_shared<palpate::SimulatedDevice>(held.plant, held.hand, std::move(path), limits);
  }
  return true;
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
  this->FirstPoly = this->Body->GetNumberOfVerts() + this->Body->GetNumberOfLines();
  return std::make_unique<palpate::ServoScene>(
    std::move(body), this->Settings->GetKernel(), factor);
}

bool vtkHapticSession::FitToDevice(
  const palpate::SafetySettings& safety, double scale, double& factor)
{
  factor = 1.0;
  if (!this->FitForce)
  {
    return true;
  }
  if (!(this->FitDepth > 0.0 && std::isfinite(this->FitDepth)))
  {
    vtkErrorMacro(<< "FitDepth must be finite and positive, but is " << this->FitDepth << ".");
    return false;
  }
  palpate::DeviceSpecification device;
  device.maximumForce = safety.maximumForce;
  device.maximumStiffness = safety.maximumStiffness;
  palpate::DeviceFit all(device, scale);
  auto names = this->FitResponses;
  names.push_back(this->ResponseName);
  for (const std::string& name : names)
  {
    const auto body = this->ReadBody(name);
    if (!body)
    {
      return false;
    }
    auto& peaks = this->Known->peaks[{ name, this->FitDepth }];
    if (!peaks)
    {
      palpate::DeviceFit one(device);
      one.include(body->response, this->FitDepth);
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

bool vtkHapticSession::StartRun(std::unique_ptr<Started> started)
{
  auto scene = this->MakeScene(started->safety, started->mapping.scale());
  if (!scene)
  {
    return false;
  }
  palpate::ServoStep step(std::move(scene), started->mapping, started->safety, this->ClutchButtons);
  const palpate::TicksKept kept{ this->Recording, this->HistorySeconds };
  if (!this->RealTime)
  {
    started->run =
      std::make_unique<palpate::VirtualRun>(started->device, std::move(step), this->Rate, kept);
  }
  else
  {
    palpate::ServoLoopSettings settings;
    settings.rate = this->Rate;
    settings.recordedSeconds = this->Recording
      ? this->RecordedSeconds
      : std::min(this->RecordedSeconds, kept.historySeconds);
    settings.realTime.lockMemory = this->LockMemory;
    auto live =
      std::make_unique<palpate::RealTimeRun>(started->device, std::move(step), settings, kept);
    const std::string error = live->start();
    if (!error.empty())
    {
      vtkErrorMacro(<< "The servo thread does not start: " << error << ".");
      return false;
    }
    started->run = std::move(live);
  }
  this->Run = std::move(started);
  ++this->Starts;
  return true;
}
