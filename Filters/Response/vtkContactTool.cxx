// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactTool.h"

#include "AxisymmetricTool.h"
#include "ReducedModulus.h"
#include "ToolSpecification.h"

#include "vtkObjectFactory.h"

#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
}

vtkStandardNewMacro(vtkContactTool);

vtkContactTool::vtkContactTool() = default;
vtkContactTool::~vtkContactTool() = default;

const palpate::AxisymmetricTool* vtkContactTool::GetKernel()
{
  if (this->KernelTime == this->GetMTime())
  {
    return this->Kernel.get();
  }
  this->Kernel.reset();
  if (this->Shape < Flat || this->Shape > Cone)
  {
    vtkErrorMacro(<< "Shape " << this->Shape
                  << " is not available: give 0 Flat, 1 Paraboloid, 2 Sphere or 3 Cone.");
    return nullptr;
  }
  const palpate::ToolSpecification specification = { static_cast<palpate::ToolShape>(this->Shape),
    this->Shape == Cone ? this->HalfAngle : this->Radius };
  this->Kernel = palpate::makeTool(specification);
  if (!this->Kernel)
  {
    vtkErrorMacro(<< "Invalid tool: " << palpate::checkTool(specification) << ".");
    return nullptr;
  }
  this->KernelTime = this->GetMTime();
  return this->Kernel.get();
}

bool vtkContactTool::SetSpecification(const std::string& specification)
{
  palpate::ToolSpecification read;
  std::string error;
  if (!palpate::parseTool(specification, read, error))
  {
    vtkErrorMacro(<< error << ".");
    return false;
  }
  this->SetShape(static_cast<int>(read.Shape));
  if (this->Shape == Cone)
  {
    this->SetHalfAngle(read.Parameter);
  }
  else
  {
    this->SetRadius(read.Parameter);
  }
  return true;
}

std::string vtkContactTool::GetSpecification()
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  return tool ? tool->specification() : std::string();
}

std::string vtkContactTool::GetDescription()
{
  // "name:value" already has the shortest decimals.
  const std::string specification = this->GetSpecification();
  const std::size_t colon = specification.find(':');
  if (colon == std::string::npos)
  {
    return {};
  }
  const std::string name = specification.substr(0, colon);
  const std::string value = specification.substr(colon + 1);
  return this->Shape == Cone ? name + ", half angle " + value + " degrees"
                             : name + ", radius " + value + " mm";
}

bool vtkContactTool::CheckModulus(double reducedModulus)
{
  if (!palpate::isYoungsModulus(reducedModulus))
  {
    vtkErrorMacro(<< "The reduced modulus must be positive and finite (MPa), but is "
                  << reducedModulus << ".");
    return false;
  }
  return true;
}

double vtkContactTool::GetForce(double deflection, double reducedModulus)
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  return tool && this->CheckModulus(reducedModulus) ? tool->force(deflection, reducedModulus) : NaN;
}

double vtkContactTool::GetStiffness(double deflection, double reducedModulus)
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  return tool && this->CheckModulus(reducedModulus) ? tool->stiffness(deflection, reducedModulus)
                                                    : NaN;
}

double vtkContactTool::GetContactRadius(double deflection)
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  return tool ? tool->contactRadius(deflection) : NaN;
}

double vtkContactTool::GetPressure(double r, double deflection, double reducedModulus)
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  return tool && this->CheckModulus(reducedModulus) ? tool->pressure(r, deflection, reducedModulus)
                                                    : NaN;
}

void vtkContactTool::GetSurfaceDisplacement(
  double r, double deflection, double poissonRatio, double u[2])
{
  u[0] = u[1] = NaN;
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  if (!tool)
  {
    return;
  }
  if (!palpate::isPoissonsRatio(poissonRatio))
  {
    vtkErrorMacro(<< "Poisson's ratio must lie between 0 and 0.5, but is " << poissonRatio << ".");
    return;
  }
  const palpate::SurfaceDisplacement found = tool->surfaceDisplacement(r, deflection, poissonRatio);
  u[0] = found.radial;
  u[1] = found.normal;
}

double vtkContactTool::GetProfile(double r)
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  return tool ? tool->profile(r) : NaN;
}

void vtkContactTool::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "Radius: " << this->Radius << " mm\n";
  os << indent << "HalfAngle: " << this->HalfAngle << " degrees\n";
}
