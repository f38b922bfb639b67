// SPDX-License-Identifier: BSD-3-Clause
// Properties and results of a session. vtkHapticSessionStart.cxx starts it.
#include "vtkHapticSession.h"

#include "Haptics/Safety/SafetyText.h"
#include "Interaction/Session/HapticSessionState.h"
#include "Interaction/Session/SessionSetup.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

vtkStandardNewMacro(vtkHapticSession);

vtkHapticSession::vtkHapticSession()
  : Settings(vtkSmartPointer<vtkContactSettings>::New())
  , Device(vtkSmartPointer<vtkHapticDevice>::New())
  , Safety(vtkSmartPointer<vtkHapticSafety>::New())
  , Recorder(vtkSmartPointer<vtkHapticRecorder>::New())
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

template <class Part>
void vtkHapticSession::Exchange(vtkSmartPointer<Part>& held, Part* part)
{
  if (held != part)
  {
    held = part ? vtkSmartPointer<Part>(part) : vtkSmartPointer<Part>::New();
    this->Modified();
  }
}

void vtkHapticSession::SetSettings(vtkContactSettings* settings)
{
  this->Exchange(this->Settings, settings);
}

vtkContactSettings* vtkHapticSession::GetSettings()
{
  return this->Settings;
}

void vtkHapticSession::SetDevice(vtkHapticDevice* device)
{
  this->Exchange(this->Device, device);
}

vtkHapticDevice* vtkHapticSession::GetDevice()
{
  return this->Device;
}

vtkHapticDevice* vtkHapticSession::GetDevice(int index)
{
  const auto devices = this->Devices();
  const auto place = static_cast<std::size_t>(index);
  return index >= 0 && place < devices.size() ? devices[place] : nullptr;
}

void vtkHapticSession::SetSafety(vtkHapticSafety* safety)
{
  this->Exchange(this->Safety, safety);
}

vtkHapticSafety* vtkHapticSession::GetSafety()
{
  return this->Safety;
}

void vtkHapticSession::SetRecorder(vtkHapticRecorder* recorder)
{
  this->Exchange(this->Recorder, recorder);
}

vtkHapticRecorder* vtkHapticSession::GetRecorder()
{
  return this->Recorder;
}

vtkIdType vtkHapticSession::GetNumberOfTicks() const
{
  return this->Run ? static_cast<vtkIdType>(this->Run->run->ticksMade()) : 0;
}

void vtkHapticSession::Stop()
{
  if (this->Run)
  {
    this->Run->run->stop();
  }
}

void vtkHapticSession::Toggle()
{
  if (this->GetState() == Stopped)
  {
    this->Start();
  }
  else
  {
    this->Stop();
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
  return this->GetState(0);
}

int vtkHapticSession::GetState(int device) const
{
  if (!this->Run || !this->Run->run->isRunning())
  {
    return Stopped;
  }
  constexpr unsigned lost = static_cast<unsigned>(palpate::SafetyLink::NoSample) |
    static_cast<unsigned>(palpate::SafetyLink::Watchdog);
  return (this->Newest(device).acted & lost) != 0 ? DeviceLost : Running;
}

double vtkHapticSession::GetTime() const
{
  return this->Run ? this->Run->run->time() : 0.0;
}

const palpate::Tick& vtkHapticSession::Newest(int device) const
{
  static const palpate::Tick none;
  const auto hand = static_cast<std::size_t>(device);
  const bool isThere = this->Run && device >= 0 && hand < this->Run->run->hands();
  return isThere ? this->Run->run->newest(hand) : none;
}

void vtkHapticSession::GetTip(double tip[3])
{
  this->GetTip(0, tip);
}

void vtkHapticSession::GetTip(int device, double tip[3])
{
  std::copy_n(this->Newest(device).tip.data(), 3, tip);
}

void vtkHapticSession::GetContactPoint(double point[3])
{
  this->GetContactPoint(0, point);
}

void vtkHapticSession::GetContactPoint(int device, double point[3])
{
  std::copy_n(this->Newest(device).contact.contactPoint.data(), 3, point);
}

void vtkHapticSession::GetIdealForce(double force[3])
{
  this->GetIdealForce(0, force);
}

void vtkHapticSession::GetIdealForce(int device, double force[3])
{
  std::copy_n(this->Newest(device).idealForce.data(), 3, force);
}

void vtkHapticSession::GetForce(double force[3])
{
  this->GetForce(0, force);
}

void vtkHapticSession::GetForce(int device, double force[3])
{
  // A stopped session exerts no force, regardless of the force of the last tick.
  std::fill_n(force, 3, 0.0);
  if (this->GetState(device) == Running)
  {
    std::copy_n(this->Newest(device).appliedForce.data(), 3, force);
  }
}

double vtkHapticSession::GetForceFactor()
{
  return this->GetNumberOfTicks() > 0 ? this->Newest(0).forceFactor : this->FittedFactor;
}

double vtkHapticSession::GetMaximumForce()
{
  return std::min(this->Safety->GetForceLimit(), this->Device->GetMaximumForce());
}

std::string vtkHapticSession::GetSafetyText()
{
  return this->GetSafetyText(0);
}

std::string vtkHapticSession::GetSafetyText(int device)
{
  const palpate::Tick& newest = this->Newest(device);
  return palpate::describeSafety(newest.acted, newest.forceFactor, this->FitReason);
}

void vtkHapticSession::GetFrictionForce(double force[3])
{
  this->GetFrictionForce(0, force);
}

void vtkHapticSession::GetFrictionForce(int device, double force[3])
{
  std::copy_n(this->Newest(device).contact.friction.data(), 3, force);
}

void vtkHapticSession::GetNormal(double normal[3])
{
  this->GetNormal(0, normal);
}

void vtkHapticSession::GetNormal(int device, double normal[3])
{
  std::copy_n(this->Newest(device).contact.normal.data(), 3, normal);
}

vtkIdType vtkHapticSession::GetContactCell()
{
  return this->GetContactCell(0);
}

vtkIdType vtkHapticSession::GetContactCell(int device)
{
  const std::int32_t triangle = this->Newest(device).contact.triangle;
  return triangle < 0 ? -1 : this->Run->run->firstPoly + static_cast<vtkIdType>(triangle);
}

double vtkHapticSession::GetDeflection()
{
  return this->GetDeflection(0);
}

double vtkHapticSession::GetDeflection(int device)
{
  return this->Newest(device).contact.deflection;
}

int vtkHapticSession::GetContactState()
{
  return this->GetContactState(0);
}

int vtkHapticSession::GetContactState(int device)
{
  return static_cast<int>(this->Newest(device).contact.state);
}

void vtkHapticSession::GetAxis(double axis[3])
{
  this->GetAxis(0, axis);
}

void vtkHapticSession::GetAxis(int device, double axis[3])
{
  std::copy_n(this->Newest(device).axis.data(), 3, axis);
}

void vtkHapticSession::GetIdealTorque(double torque[3])
{
  this->GetIdealTorque(0, torque);
}

void vtkHapticSession::GetIdealTorque(int device, double torque[3])
{
  std::copy_n(this->Newest(device).idealTorque.data(), 3, torque);
}

void vtkHapticSession::GetTorque(double torque[3])
{
  this->GetTorque(0, torque);
}

void vtkHapticSession::GetTorque(int device, double torque[3])
{
  std::fill_n(torque, 3, 0.0); // zero if the session does not run; see GetForce
  if (this->GetState(device) == Running)
  {
    std::copy_n(this->Newest(device).appliedTorque.data(), 3, torque);
  }
}

double vtkHapticSession::GetTilt()
{
  return this->GetTilt(0);
}

double vtkHapticSession::GetTilt(int device)
{
  return vtkMath::DegreesFromRadians(this->Newest(device).contact.tilt);
}

const palpate::Tick& vtkHapticSession::GetNewestTick()
{
  return this->GetNewestTick(0);
}

const palpate::Tick& vtkHapticSession::GetNewestTick(int device)
{
  return this->Newest(device);
}

palpate::RecordedSetup vtkHapticSession::GetSetup()
{
  return palpate::setupOf(this->Body, this->ResponseName, this->BodyName, this->Material,
    this->Settings->GetKernel().friction);
}

std::string vtkHapticSession::GetReplayText()
{
  return this->Device->IsReplay() ? palpate::replayInWords(this->Device->GetRecordedSetups(),
                                      this->Newest(0).time, this->GetSetup())
                                  : std::string();
}

vtkMTimeType vtkHapticSession::GetMTime()
{
  vtkMTimeType newest = std::max({ this->Superclass::GetMTime(), this->Settings->GetMTime(),
    this->Safety->GetMTime(), this->Recorder->GetMTime() });
  for (vtkHapticDevice* device : this->Devices())
  {
    newest = std::max(newest, device->GetMTime());
  }
  return newest;
}

void vtkHapticSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Body: " << this->Body.Get() << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "BodyName: " << this->BodyName << "\n";
  os << indent << "Material: " << this->Material << "\n";
  os << indent << "Rate: " << this->Rate << " Hz\n";
  os << indent << "RealTime: " << this->RealTime << "\n";
  os << indent << "LockMemory: " << this->LockMemory << "\n";
  os << indent << "Rehearsal: " << this->Rehearsal << " s\n";
  os << indent << "Time: " << this->GetTime() << " s\n";
  os << indent << "NumberOfDevices: " << this->GetNumberOfDevices() << "\n";
  const std::initializer_list<std::pair<const char*, vtkObject*>> parts = { { "Settings",
                                                                              this->Settings },
    { "Device", this->Device }, { "Safety", this->Safety }, { "Recorder", this->Recorder } };
  for (const auto& [name, part] : parts)
  {
    os << indent << name << ":\n";
    part->PrintSelf(os, indent.GetNextIndent());
  }
}
