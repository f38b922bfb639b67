// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSession.h"

#include "BodyConversion.h"
#include "GivenSettings.h"
#include "ServoLoop.h"
#include "ServoStep.h"
#include "SimulatedDevice.h"
#include "SteeredDevice.h"
#include "TickRecording.h"

#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <chrono>
#include <cmath>

/// What lives from Start to the next Start.
struct vtkHapticSession::Loop
{
  std::shared_ptr<const palpate::ContactBody> body;
  palpate::WorkspaceMapping mapping;
  palpate::SimulatedDevice device;
  palpate::ServoStep servo;
  double period;
  double reached = 0.0; ///< virtual time stepped to so far, s; ticks fall behind by less than one
  bool running = true;
  std::vector<palpate::ServoTick> ticks;
  std::vector<double> nanoseconds;

  Loop(std::shared_ptr<const palpate::ContactBody> kernel, const palpate::ContactSettings& settings,
    std::vector<palpate::SimulatedDevice::WayPoint> path, double tickPeriod)
    : body(std::move(kernel))
    , device(std::move(path))
    , servo(*this->body, this->mapping, this->device.specification().maximumForce, settings)
    , period(tickPeriod)
  {
  }

  double nextTime() const { return static_cast<double>(this->ticks.size()) * this->period; }

  void tick()
  {
    const double time = this->nextTime();
    const auto begin = std::chrono::steady_clock::now();
    const palpate::ServoTick tick = this->servo.step(this->device.read(time), time);
    this->device.write(tick.deviceForce);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
    this->ticks.push_back(tick);
    this->nanoseconds.push_back(spent.count());
  }
};

/// The servo thread and what it needs, from Start to Stop.
struct vtkHapticSession::Thread
{
  std::shared_ptr<const palpate::ContactBody> body;
  palpate::WorkspaceMapping mapping;
  palpate::SteeredDevice device;
  palpate::ServoLoop servo;

  Thread(std::shared_ptr<const palpate::ContactBody> kernel,
    const palpate::ContactSettings& settings, const Eigen::Vector3d& start, double rate)
    : body(std::move(kernel))
    , device(this->mapping.toDevice(start))
    , servo(this->device,
        palpate::ServoStep(
          *this->body, this->mapping, this->device.specification().maximumForce, settings),
        rate)
  {
    this->servo.start();
  }
};

vtkStandardNewMacro(vtkHapticSession);

vtkHapticSession::vtkHapticSession() = default;
vtkHapticSession::~vtkHapticSession() = default;

void vtkHapticSession::SetBody(vtkPolyData* body)
{
  this->Body = body;
  this->Modified();
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
  if (device != "simulated")
  {
    vtkErrorMacro(<< "Device '" << device << "' is not available: give \"simulated\".");
    return false;
  }
  return true;
}

bool vtkHapticSession::Start()
{
  this->Active.reset();
  this->Live.reset();
  palpate::ContactSettings settings;
  if (!this->ReadSettings(settings))
  {
    return false;
  }
  auto kernel = this->ReadBody();
  if (!kernel)
  {
    return false;
  }
  this->FirstPoly = this->Body->GetNumberOfVerts() + this->Body->GetNumberOfLines();
  if (this->RealTime)
  {
    this->Live = std::make_unique<Thread>(
      std::move(kernel), settings, Eigen::Vector3d(this->Steered), this->Rate);
    return true;
  }
  return this->StartVirtual(std::move(kernel), settings);
}

std::shared_ptr<const palpate::ContactBody> vtkHapticSession::ReadBody()
{
  if (!this->Body)
  {
    vtkErrorMacro(<< "A body is required: call SetBody.");
    return nullptr;
  }
  std::string error;
  auto kernel = palpate::makeContactBody(this->Body, this->ResponseName, error);
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

bool vtkHapticSession::ReadSettings(palpate::ContactSettings& settings)
{
  palpate::GivenSettings given;
  given.forceForm = this->ForceForm;
  given.contactSurface = this->ContactSurface;
  given.frictionModel = this->FrictionModel;
  given.frictionCoefficient = this->FrictionCoefficient;
  given.tangentialStiffness = this->TangentialStiffness;
  given.frictionBreakaway = this->FrictionBreakaway;
  given.frictionStickRadius = this->FrictionStickRadius;
  given.poissonRatio = this->PoissonRatio;
  if (const palpate::SettingFault fault = given.fault())
  {
    vtkErrorMacro(<< fault.name << " " << fault.remark << ".");
    return false;
  }
  settings = given.settings();
  return true;
}

bool vtkHapticSession::StartVirtual(
  std::shared_ptr<const palpate::ContactBody> kernel, const palpate::ContactSettings& settings)
{
  vtkDataArray* times = this->Path ? this->Path->GetPointData()->GetArray("Time") : nullptr;
  if (!times || this->Path->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro(<< "The simulated device needs a path with a point array 'Time' (s).");
    return false;
  }
  const palpate::WorkspaceMapping mapping;
  std::vector<palpate::SimulatedDevice::WayPoint> path;
  for (vtkIdType i = 0; i < this->Path->GetNumberOfPoints(); ++i)
  {
    Eigen::Vector3d position;
    this->Path->GetPoint(i, position.data());
    path.push_back({ times->GetTuple1(i), mapping.toDevice(position) });
    if (!(std::isfinite(path.back().time) && position.allFinite()) ||
      (i > 0 && path[path.size() - 2].time > path.back().time))
    {
      vtkErrorMacro(<< "Point " << i << " of the path is not finite or goes back in time.");
      return false;
    }
  }
  this->Active =
    std::make_unique<Loop>(std::move(kernel), settings, std::move(path), 1.0 / this->Rate);
  return true;
}

void vtkHapticSession::SteerTo(const double tip[3])
{
  std::copy_n(tip, 3, this->Steered);
  if (this->Live)
  {
    this->Live->device.steerTo(this->Live->mapping.toDevice(Eigen::Vector3d(tip)));
  }
}

vtkIdType vtkHapticSession::GetNumberOfTicks() const
{
  return this->Live ? static_cast<vtkIdType>(this->Live->servo.ticks())
                    : static_cast<vtkIdType>(this->GetTicks().size());
}

vtkIdType vtkHapticSession::GetNumberOfMissedTicks() const
{
  return this->Live ? static_cast<vtkIdType>(this->Live->servo.missed()) : 0;
}

void vtkHapticSession::Stop()
{
  if (this->Live)
  {
    this->Live->servo.stop();
  }
  if (this->Active)
  {
    this->Active->running = false;
    this->Active->device.write(Eigen::Vector3d::Zero());
  }
}

void vtkHapticSession::Step(double seconds)
{
  if (!this->Active || !this->Active->running || !(seconds > 0.0 && std::isfinite(seconds)))
  {
    return;
  }
  // Half a tick of slack, so that steps which add up to a whole number of ticks run that many.
  this->Active->reached += seconds;
  const double end = this->Active->reached - 0.5 * this->Active->period;
  while (this->Active->nextTime() < end)
  {
    this->Active->tick();
  }
}

int vtkHapticSession::GetState() const
{
  const bool live = this->Live && this->Live->servo.isRunning();
  return live || (this->Active && this->Active->running) ? Running : Stopped;
}

double vtkHapticSession::GetTime() const
{
  return this->Active ? this->Active->nextTime() : 0.0;
}

double vtkHapticSession::GetPathDuration() const
{
  return this->Active ? this->Active->device.duration() : 0.0;
}

const palpate::ServoTick& vtkHapticSession::Newest()
{
  static const palpate::ServoTick none;
  if (this->Live)
  {
    return this->Live->servo.newest();
  }
  return this->Active && !this->Active->ticks.empty() ? this->Active->ticks.back() : none;
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
  std::copy_n(this->Newest().contact.force.data(), 3, force);
}

void vtkHapticSession::GetForce(double force[3])
{
  // A stopped session exerts nothing, whatever the last tick was. The mapping keeps the axes.
  std::fill_n(force, 3, 0.0);
  if (this->GetState() == Running)
  {
    std::copy_n(this->Newest().deviceForce.data(), 3, force);
  }
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

const std::vector<palpate::ServoTick>& vtkHapticSession::GetTicks() const
{
  static const std::vector<palpate::ServoTick> none;
  return this->Active ? this->Active->ticks : none;
}

void vtkHapticSession::GetRecording(vtkPolyData* recording)
{
  palpate::fillRecording(this->GetTicks(), this->FirstPoly, recording);
}

void vtkHapticSession::GetStatistics(vtkTable* statistics)
{
  palpate::fillStatistics(
    this->GetTicks(), this->Active ? this->Active->nanoseconds : std::vector<double>(), statistics);
}

void vtkHapticSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Body: " << this->Body.Get() << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "ForceForm: " << this->ForceForm << "\n";
  os << indent << "ContactSurface: " << this->ContactSurface << "\n";
  os << indent << "FrictionCoefficient: " << this->FrictionCoefficient << "\n";
  os << indent << "FrictionModel: " << this->FrictionModel << "\n";
  os << indent << "TangentialStiffness: " << this->TangentialStiffness << " N/mm\n";
  os << indent << "FrictionBreakaway: " << this->FrictionBreakaway << "\n";
  os << indent << "FrictionStickRadius: " << this->FrictionStickRadius << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "Rate: " << this->Rate << " Hz\n";
  os << indent << "Time: " << this->GetTime() << " s\n";
}
