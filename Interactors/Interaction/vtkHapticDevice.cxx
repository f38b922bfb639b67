// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticDevice.h"

#include "Haptics/Devices/DeviceTransports.h"
#include "Haptics/Devices/ReplayDevice.h"
#include "Haptics/Devices/WorkspaceMapping.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Interaction/Session/SessionDevice.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
constexpr double FreeMargin = 10.0; // mm, free space around a body that is fitted into a workspace
} // namespace

struct vtkHapticDevice::Parts
{
  palpate::SessionDevice chosen;

  // The mapping that was prepared at the last Start of the session.
  palpate::WorkspaceMapping mapping;
  std::shared_ptr<palpate::HapticDevice> hand;
  palpate::SimulatedDevice* steered = nullptr; ///< the simulated hand if it is steered, else null
  double pathDuration = 0.0;                   ///< s
  double rate = 1000.0;                        ///< Hz
  double simulatedForce = 10.0;                ///< N

  palpate::DeviceSpecification specification() const
  {
    palpate::DeviceSpecification specification = this->chosen.specification(this->rate);
    if (this->chosen.kind == palpate::SessionDevice::Simulated)
    {
      specification.maximumForce = this->simulatedForce;
    }
    return specification;
  }
  /// Makes a simulated device that follows a path or starts at a point. The device is either a
  /// stiff hand or a plant that is held by a hand.
  template <class Way>
  std::shared_ptr<palpate::SimulatedDevice> makeSimulated(Way way) const
  {
    const palpate::HeldPlant& held = this->chosen.held;
    return this->chosen.isStiff()
      ? std::make_shared<palpate::SimulatedDevice>(std::move(way), this->specification())
      : std::make_shared<palpate::SimulatedDevice>(
          held.plant, held.hand, std::move(way), this->specification());
  }
};

vtkStandardNewMacro(vtkHapticDevice);

vtkHapticDevice::vtkHapticDevice()
  : Kept(std::make_unique<Parts>())
{
}

vtkHapticDevice::~vtkHapticDevice() = default;

bool vtkHapticDevice::Open(const std::string& name)
{
  const std::string error = palpate::openSessionDevice(name, this->Kept->chosen);
  if (!error.empty())
  {
    vtkErrorMacro(<< "Device '" << name << "': " << error << ".");
    return false;
  }
  this->Modified();
  return true;
}

void vtkHapticDevice::Use(std::unique_ptr<palpate::HapticDevice> device)
{
  if (!device)
  {
    vtkErrorMacro(<< "The device given is null.");
    return;
  }
  this->Kept->chosen = { palpate::SessionDevice::OfTheCaller, std::move(device), {}, {} };
  this->Modified();
}

std::string vtkHapticDevice::ListDevices()
{
  return palpate::pluggedDevices().text;
}

std::string vtkHapticDevice::GetStatus()
{
  const auto& device = this->Kept->hand ? this->Kept->hand : this->Kept->chosen.device;
  return device ? device->status() : "not started";
}

bool vtkHapticDevice::GetOutputsForce()
{
  const auto& opened = this->Kept->chosen.device;
  return opened && opened->specification().outputsForce;
}

double vtkHapticDevice::GetMaximumForce()
{
  this->Kept->simulatedForce = this->SimulatedForce;
  return this->Kept->specification().maximumForce;
}

bool vtkHapticDevice::IsPhysical()
{
  return this->Kept->chosen.kind == palpate::SessionDevice::Opened;
}

bool vtkHapticDevice::IsSimulated()
{
  return this->Kept->chosen.isSimulated();
}

bool vtkHapticDevice::IsReplay()
{
  return this->Kept->chosen.kind == palpate::SessionDevice::Replay;
}

const palpate::RecordedSetups& vtkHapticDevice::GetRecordedSetups()
{
  return this->Kept->chosen.trajectory.setups;
}

bool vtkHapticDevice::IsStiff() const
{
  return this->Kept->chosen.isStiff();
}

std::shared_ptr<palpate::HapticDevice> vtkHapticDevice::GetHand() const
{
  return this->Kept->hand;
}

const palpate::WorkspaceMapping& vtkHapticDevice::GetMapping() const
{
  return this->Kept->mapping;
}

void vtkHapticDevice::SetPath(vtkPolyData* path)
{
  this->Path = path;
  this->Modified();
}

double vtkHapticDevice::GetPathDuration()
{
  return this->Kept->pathDuration;
}

void vtkHapticDevice::SteerTo(const double tip[3])
{
  this->Touches = false;
  std::copy_n(tip, 3, this->Steered);
  if (this->Kept->steered)
  {
    this->Kept->steered->steerTo(this->Kept->mapping.toDevice(Eigen::Vector3d(tip)));
  }
}

void vtkHapticDevice::TouchAt(const double point[3], const double normal[3], double height)
{
  double tip[3];
  for (int k = 0; k < 3; ++k)
  {
    tip[k] = point[k] + height * normal[k];
  }
  if (this->Kept->mapping.isPlanar())
  {
    this->SteerTo(tip);
    return;
  }
  std::copy_n(tip, 3, this->Steered);
  std::copy_n(point, 3, this->TouchedPoint);
  std::copy_n(normal, 3, this->TouchedNormal);
  this->TouchedHeight = height;
  this->Touches = true;
  this->Touch();
}

void vtkHapticDevice::Touch()
{
  if (this->Kept->steered && this->Touches)
  {
    this->Kept->steered->touch(Eigen::Vector3d(this->TouchedPoint),
      Eigen::Vector3d(this->TouchedNormal), this->TouchedHeight);
  }
}

void vtkHapticDevice::ChangeBody(const std::shared_ptr<const palpate::ContactBody>& body)
{
  if (this->Kept->steered)
  {
    this->Kept->steered->setBody(body, this->Kept->mapping);
    this->Touch();
  }
}

void vtkHapticDevice::TurnTo(const double axis[3])
{
  std::copy_n(axis, 3, this->Axis);
  if (this->Kept->steered)
  {
    this->Kept->steered->turnTo(this->Kept->mapping.axisToDevice(Eigen::Vector3d(axis)));
  }
}

std::string vtkHapticDevice::Prepare(const std::shared_ptr<const palpate::ContactBody>& body,
  const double bounds[6], bool realTime, double rate)
{
  this->Release();
  Parts& kept = *this->Kept;
  kept.rate = rate;
  kept.simulatedForce = this->SimulatedForce;
  if (this->IsPhysical() && !realTime)
  {
    return "This device has no virtual time: set RealTime";
  }
  kept.mapping = this->ReadMapping(bounds);
  if (const palpate::SettingFault fault = kept.mapping.fault())
  {
    return "Workspace mapping: " + fault.words();
  }
  if (kept.chosen.kind == palpate::SessionDevice::Replay)
  {
    const auto replay = std::make_shared<palpate::ReplayDevice>(
      kept.chosen.trajectory, kept.mapping, kept.specification());
    kept.pathDuration = replay->duration();
    kept.hand = replay;
  }
  else if (kept.chosen.isSimulated() && realTime)
  {
    const auto hand = kept.makeSimulated(kept.mapping.toDevice(Eigen::Vector3d(this->Steered)));
    kept.steered = hand.get();
    hand->turnTo(kept.mapping.axisToDevice(Eigen::Vector3d(this->Axis)));
    kept.hand = hand;
    this->Touches = this->Touches && !kept.mapping.isPlanar();
    this->ChangeBody(body);
  }
  else if (kept.chosen.isSimulated())
  {
    return this->MakeHandOnPath();
  }
  else
  {
    kept.hand = kept.chosen.device;
  }
  return {};
}

void vtkHapticDevice::Release()
{
  this->Kept->hand = nullptr;
  this->Kept->steered = nullptr;
  this->Kept->pathDuration = 0.0;
}

palpate::WorkspaceMapping vtkHapticDevice::ReadMapping(const double bounds[6]) const
{
  const Eigen::Vector3d right(this->Right);
  const Eigen::Vector3d up(this->Up);
  Eigen::Matrix3d axes;
  axes << right.normalized(), up.normalized(), right.cross(up).normalized();
  palpate::WorkspaceMapping mapping(axes, Eigen::Vector3d(this->Origin), this->Scale);
  if (this->Planar)
  {
    mapping = mapping.planar();
  }
  if (this->FitWorkspace)
  {
    mapping = mapping.fitted({ bounds[0], bounds[2], bounds[4] },
      { bounds[1], bounds[3], bounds[5] }, this->Kept->specification().workspace, FreeMargin);
  }
  return mapping;
}

std::string vtkHapticDevice::MakeHandOnPath()
{
  vtkDataArray* times = this->Path ? this->Path->GetPointData()->GetArray("Time") : nullptr;
  if (!times || this->Path->GetNumberOfPoints() == 0)
  {
    return "The simulated device needs a path with a point array 'Time' (s)";
  }
  vtkDataArray* axes = this->Path->GetPointData()->GetArray("ToolAxis");
  if (axes && axes->GetNumberOfComponents() != 3)
  {
    return "The point array 'ToolAxis' of the path must have 3 components, but has " +
      std::to_string(axes->GetNumberOfComponents());
  }
  std::vector<palpate::WayPoint> path;
  for (vtkIdType i = 0; i < this->Path->GetNumberOfPoints(); ++i)
  {
    Eigen::Vector3d position;
    this->Path->GetPoint(i, position.data());
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    if (axes)
    {
      axes->GetTuple(i, axis.data());
    }
    const palpate::WorkspaceMapping& mapping = this->Kept->mapping;
    path.push_back({ times->GetTuple1(i), mapping.toDevice(position), mapping.axisToDevice(axis) });
    if (!(std::isfinite(path.back().time) && position.allFinite() && axis.allFinite()) ||
      (i > 0 && path[path.size() - 2].time > path.back().time))
    {
      return "Point " + std::to_string(i) + " of the path is not finite or goes back in time";
    }
  }
  this->Kept->pathDuration = path.back().time;
  this->Kept->hand = this->Kept->makeSimulated(std::move(path));
  return {};
}

void vtkHapticDevice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Status: " << this->GetStatus() << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "SimulatedForce: " << this->SimulatedForce << " N\n";
  os << indent << "Planar: " << this->Planar << "\n";
  os << indent << "FitWorkspace: " << this->FitWorkspace << "\n";
  os << indent << "ClutchButtons: " << this->ClutchButtons << "\n";
}
