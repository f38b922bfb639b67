// SPDX-License-Identifier: BSD-3-Clause
// What is set, and what is read; vtkHapticSessionStart.cxx is what happens in between.
#include "vtkHapticSession.h"

#include "Haptics/Devices/DeviceList.h"
#include "Interaction/Session/HapticSessionState.h"
#include "Haptics/Safety/SafetyText.h"
#include "Interaction/Session/SessionDevice.h"
#include "Interaction/Session/TickRecording.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkHapticSession);

vtkHapticSession::vtkHapticSession()
  : Settings(vtkSmartPointer<vtkContactSettings>::New())
  , Chosen(std::make_unique<palpate::SessionDevice>())
  , Known(std::make_unique<Kernels>())
{
}

vtkHapticSession::~vtkHapticSession() = default;

void vtkHapticSession::SetBody(vtkPolyData* body)
{
  this->Body = body;
  this->Modified();
}

void vtkHapticSession::SetBody(vtkPolyData* body, palpate::BodyKernels kernels)
{
  this->SetBody(body);
  static_cast<palpate::BodyKernels&>(*this->Known) = std::move(kernels);
  this->Known->body = body;
  this->Known->time = body ? body->GetMTime() : 0;
  this->Known->given = true;
}

vtkPolyData* vtkHapticSession::GetBody()
{
  return this->Body;
}

void vtkHapticSession::SetPath(vtkPolyData* path)
{
  this->Path = path;
  this->Modified();
}

bool vtkHapticSession::SetDevice(const std::string& device)
{
  const std::string error = palpate::openSessionDevice(device, *this->Chosen);
  if (!error.empty())
  {
    vtkErrorMacro(<< "Device '" << device << "': " << error << ".");
    return false;
  }
  this->Modified();
  return true;
}

void vtkHapticSession::SetDevice(std::unique_ptr<palpate::HapticDevice> device)
{
  if (!device)
  {
    vtkErrorMacro(<< "The device given is null.");
    return;
  }
  *this->Chosen = { palpate::SessionDevice::OfTheCaller, std::move(device), {}, {} };
  this->Modified();
}

std::string vtkHapticSession::GetDeviceStatus()
{
  if (this->Run)
  {
    return this->Run->run->device().status();
  }
  return this->Chosen->device ? this->Chosen->device->status() : "not started";
}

bool vtkHapticSession::GetDeviceOutputsForce()
{
  return this->Chosen->device && this->Chosen->device->specification().outputsForce;
}

double vtkHapticSession::GetDeviceForceLimit()
{
  const auto limits = this->Chosen->specification(this->Rate);
  return std::min(this->ForceLimit, limits.maximumForce);
}

bool vtkHapticSession::IsDevicePhysical()
{
  return this->Chosen->kind == palpate::SessionDevice::Opened;
}

bool vtkHapticSession::IsDeviceSimulated()
{
  return this->Chosen->isSimulated();
}

std::string vtkHapticSession::ListDevices()
{
  return palpate::listDevices().describe();
}

void vtkHapticSession::AddFitResponse(const std::string& responseName)
{
  this->FitResponses.push_back(responseName);
  this->Modified();
}

void vtkHapticSession::ClearFitResponses()
{
  this->FitResponses.clear();
  this->Modified();
}

void vtkHapticSession::SteerTo(const double tip[3])
{
  std::copy_n(tip, 3, this->Steered);
  if (this->Run && this->Run->steered)
  {
    this->Run->steered->steerTo(this->Run->mapping.toDevice(Eigen::Vector3d(tip)));
  }
}

vtkIdType vtkHapticSession::GetNumberOfTicks() const
{
  return this->Run ? static_cast<vtkIdType>(this->Run->run->ticksMade()) : 0;
}

vtkIdType vtkHapticSession::GetNumberOfMissedTicks() const
{
  const palpate::ServoLoop* loop = this->Run ? this->Run->run->loop() : nullptr;
  return loop ? static_cast<vtkIdType>(loop->missed()) : 0;
}

vtkIdType vtkHapticSession::GetNumberOfLostTicks() const
{
  const palpate::ServoLoop* loop = this->Run ? this->Run->run->loop() : nullptr;
  return loop ? static_cast<vtkIdType>(loop->overruns()) : 0;
}

void vtkHapticSession::Stop()
{
  if (this->Run)
  {
    this->Run->run->stop();
  }
}

void vtkHapticSession::Step(double seconds)
{
  if (this->Run && this->Run->run->isRunning() && seconds > 0.0 && std::isfinite(seconds))
  {
    this->Run->run->step(seconds);
  }
}

int vtkHapticSession::GetState() const
{
  if (!this->Run || !this->Run->run->isRunning())
  {
    return Stopped;
  }
  constexpr unsigned lost = static_cast<unsigned>(palpate::SafetyLink::NoSample) |
    static_cast<unsigned>(palpate::SafetyLink::Watchdog);
  return (this->Run->run->newest().acted & lost) != 0 ? DeviceLost : Running;
}

double vtkHapticSession::GetTime() const
{
  return this->Run ? this->Run->run->time() : 0.0;
}

double vtkHapticSession::GetPathDuration() const
{
  return this->Run ? this->Run->pathDuration : 0.0;
}

const palpate::Tick& vtkHapticSession::Newest() const
{
  static const palpate::Tick none;
  return this->Run ? this->Run->run->newest() : none;
}

void vtkHapticSession::GetTip(double tip[3])
{
  std::copy_n(this->Newest().tip.data(), 3, tip);
}

void vtkHapticSession::GetContactPoint(double point[3])
{
  std::copy_n(this->Newest().contact.contactPoint.data(), 3, point);
}

void vtkHapticSession::GetIdealForce(double force[3])
{
  std::copy_n(this->Newest().idealForce.data(), 3, force);
}

void vtkHapticSession::GetForce(double force[3])
{
  // A stopped session exerts nothing, whatever the last tick was.
  std::fill_n(force, 3, 0.0);
  if (this->GetState() == Running)
  {
    std::copy_n(this->Newest().appliedForce.data(), 3, force);
  }
}

double vtkHapticSession::GetForceFactor()
{
  return this->GetNumberOfTicks() > 0 ? this->Newest().forceFactor : this->FittedFactor;
}

std::string vtkHapticSession::GetSafetyText()
{
  const palpate::Tick& newest = this->Newest();
  return palpate::describeSafety(newest.acted, newest.forceFactor);
}

void vtkHapticSession::GetFrictionForce(double force[3])
{
  std::copy_n(this->Newest().contact.friction.data(), 3, force);
}

void vtkHapticSession::GetNormal(double normal[3])
{
  std::copy_n(this->Newest().contact.normal.data(), 3, normal);
}

vtkIdType vtkHapticSession::GetContactCell()
{
  const std::int32_t triangle = this->Newest().contact.triangle;
  return triangle < 0 ? -1 : this->FirstPoly + static_cast<vtkIdType>(triangle);
}

double vtkHapticSession::GetDeflection()
{
  return this->Newest().contact.deflection;
}

int vtkHapticSession::GetContactState()
{
  return static_cast<int>(this->Newest().contact.state);
}

const std::vector<palpate::Tick>& vtkHapticSession::GetTicks()
{
  static const std::vector<palpate::Tick> none;
  if (!this->Run)
  {
    return none;
  }
  this->Run->run->collect();
  return this->Run->run->ticks();
}

const palpate::Tick& vtkHapticSession::GetNewestTick()
{
  return this->Newest();
}

const palpate::TickHistory& vtkHapticSession::GetLastTicks()
{
  static const palpate::TickHistory none(0.0, 1.0);
  if (!this->Run)
  {
    return none;
  }
  this->Run->run->collect();
  return this->Run->run->history();
}

void vtkHapticSession::GetRecording(vtkPolyData* recording)
{
  palpate::fillRecording(this->GetTicks(), this->FirstPoly, recording);
}

void vtkHapticSession::GetHistory(vtkPolyData* history)
{
  palpate::fillRecording(this->GetLastTicks(), this->FirstPoly, history);
}

void vtkHapticSession::GetStatistics(vtkTable* statistics)
{
  if (!this->Run)
  {
    palpate::fillStatistics({}, std::vector<double>(), statistics);
    return;
  }
  palpate::SessionRun& run = *this->Run->run;
  run.collect();
  if (const palpate::ServoLoop* loop = run.loop())
  {
    palpate::fillStatistics(run.summary(), loop->statistics(), statistics);
  }
  else
  {
    palpate::fillStatistics(run.summary(), run.nanoseconds(), statistics);
  }
}

void vtkHapticSession::GetTiming(vtkTable* timing)
{
  timing->Initialize();
  if (const palpate::ServoLoop* loop = this->Run ? this->Run->run->loop() : nullptr)
  {
    palpate::fillTiming(loop->statistics(), timing);
  }
}

void vtkHapticSession::GetTimingHistogram(vtkTable* histogram)
{
  histogram->Initialize();
  if (const palpate::ServoLoop* loop = this->Run ? this->Run->run->loop() : nullptr)
  {
    palpate::fillTimingHistogram(loop->statistics(), histogram);
  }
}

std::string vtkHapticSession::GetStatisticsText()
{
  const palpate::ServoLoop* loop = this->Run ? this->Run->run->loop() : nullptr;
  return loop ? loop->statistics().describe() : std::string();
}

std::string vtkHapticSession::GetRealTimeGrant()
{
  const palpate::ServoLoop* loop = this->Run ? this->Run->run->loop() : nullptr;
  return loop ? loop->grant().describe() : std::string();
}

vtkMTimeType vtkHapticSession::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Settings->GetMTime());
}

void vtkHapticSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Body: " << this->Body.Get() << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "Settings:\n";
  this->Settings->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Rate: " << this->Rate << " Hz\n";
  os << indent << "RealTime: " << this->RealTime << "\n";
  os << indent << "HistorySeconds: " << this->HistorySeconds << " s\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Gate: " << this->Gate << "\n";
  os << indent << "EntryRamp: " << this->EntryRamp << " s\n";
  os << indent << "StiffnessCap: " << this->StiffnessCap << "\n";
  os << indent << "PassivityControl: " << this->PassivityControl << "\n";
  os << indent << "ForceLimit: " << this->ForceLimit << " N\n";
  os << indent << "StiffnessLimit: " << this->StiffnessLimit << " N/m\n";
  os << indent << "FitForce: " << this->FitForce << "\n";
  os << indent << "Time: " << this->GetTime() << " s\n";
}
