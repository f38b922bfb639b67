// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_PlacedDevice_h
#define palpate_testing_PlacedDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Response/FilterChecks.h"
#include "SceneBodies.h"

#include "vtkHapticSession.h"
#include "vtkToolContactResponse.h"

#include <atomic>
#include <memory>
#include <utility>

namespace palpate::testing
{
/// A device whose position is prescribed. It can be lost.
class PlacedDevice final : public palpate::HapticDevice
{
public:
  explicit PlacedDevice(const palpate::DeviceSpecification& specification)
    : Limits(specification)
  {
  }
  const palpate::DeviceSpecification& specification() const noexcept override
  {
    return this->Limits;
  }
  palpate::DeviceSample read(double) noexcept override
  {
    palpate::DeviceSample sample;
    sample.position = { 3e-4, 2e-4, this->Height };
    sample.valid = !this->Lost;
    return sample;
  }
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    this->Force = force.z();
    return true;
  }
  std::string status() const override { return this->Lost ? "pulled out" : "in place"; }

  std::atomic<double> Height{ 2e-3 }; ///< m
  std::atomic<bool> Lost{ false };
  std::atomic<double> Force{ 0.0 }; ///< last written force, N

private:
  palpate::DeviceSpecification Limits;
};

/// A plane z = 0 of the paper's rubber, with the responses of three tools: Flat, Sphere, and Small
/// (a small sphere).
inline Body threeTools()
{
  Body body = planeBody(20.0, 20);
  const std::pair<const char*, const char*> tools[] = { { "Flat", "flat:1.6" },
    { "Sphere", "sphere:6.35" }, { "Small", "sphere:1.6" } };
  for (const auto& [name, tool] : tools)
  {
    vtkNew<vtkToolContactResponse> filter;
    filter->SetInputData(body);
    filter->SetTool(makeTool(tool));
    filter->SetYoungsModulus(3.45);
    filter->SetPoissonRatio(0.0);
    filter->SetResponseName(name);
    makePlain(filter);
    filter->Update();
    body = Body::New();
    body->ShallowCopy(filter->GetOutput());
  }
  return body;
}

inline palpate::DeviceSpecification deviceOf(double force, double stiffness)
{
  palpate::DeviceSpecification specification;
  specification.maximumForce = force;
  specification.maximumStiffness = stiffness;
  return specification;
}

inline double appliedTo(vtkHapticSession* session)
{
  double force[3];
  session->GetForce(force);
  return vtkMath::Norm(force);
}

inline double idealOf(vtkHapticSession* session)
{
  double force[3];
  session->GetIdealForce(force);
  return vtkMath::Norm(force);
}

/// Starts the session with a device that presses 1 mm deep. The device belongs to the session.
inline PlacedDevice* pressed(
  vtkHapticSession* session, const palpate::DeviceSpecification& specification)
{
  auto owned = std::make_unique<PlacedDevice>(specification);
  PlacedDevice* device = owned.get();
  session->GetDevice()->Use(std::move(owned));
  // The position of the device is prescribed, so no loop is closed.
  session->GetSafety()->PassivityControlOff();
  PALPATE_CHECK(session->Start());
  session->Step(0.01);
  device->Height = -1e-3;
  session->Step(0.01);
  return device;
}
} // namespace palpate::testing

#endif
