// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactTool.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
}

vtkStandardNewMacro(vtkContactTool);

vtkContactTool::vtkContactTool() = default;
vtkContactTool::~vtkContactTool() = default;

void vtkContactTool::SetProfile(vtkPoints* points)
{
  if (this->ProfilePoints != points)
  {
    this->ProfilePoints = points;
    this->Modified();
  }
}

vtkPoints* vtkContactTool::GetProfilePoints()
{
  return this->ProfilePoints;
}

void vtkContactTool::AddProfilePoint(double r, double f)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (this->ProfilePoints)
  {
    points->DeepCopy(this->ProfilePoints);
  }
  points->InsertNextPoint(r, f, 0.0);
  this->SetProfile(points);
}

void vtkContactTool::RemoveAllProfilePoints()
{
  this->SetProfile(nullptr);
}

bool vtkContactTool::HasSize()
{
  return this->Shape != PowerLaw && this->Shape != Profile;
}

bool vtkContactTool::IsSizeAngle()
{
  return this->Shape == Cone;
}

void vtkContactTool::SetSize(double size)
{
  if (this->IsSizeAngle())
  {
    this->SetHalfAngle(size);
  }
  else if (this->HasSize())
  {
    this->SetRadius(size);
  }
}

double vtkContactTool::GetSize()
{
  return !this->HasSize() ? 0.0 : this->IsSizeAngle() ? this->HalfAngle : this->Radius;
}

vtkMTimeType vtkContactTool::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ProfilePoints ? std::max(own, this->ProfilePoints->GetMTime()) : own;
}

palpate::ToolSpecification vtkContactTool::MakeSpecification()
{
  palpate::ToolSpecification specification;
  specification.Shape = static_cast<palpate::ToolShape>(this->Shape);
  specification.Radius = this->Radius;
  specification.HalfAngle = this->HalfAngle;
  specification.EdgeRadius = this->EdgeRadius;
  specification.Exponent = this->Exponent;
  specification.Coefficient = this->Coefficient;
  for (vtkIdType i = 0; this->ProfilePoints && i < this->ProfilePoints->GetNumberOfPoints(); ++i)
  {
    const double* point = this->ProfilePoints->GetPoint(i);
    specification.Profile.push_back({ point[0], point[1] });
  }
  return specification;
}

std::string vtkContactTool::FindFault()
{
  if (this->KernelTime == this->GetMTime())
  {
    return {};
  }
  this->Kernel.reset();
  if (this->Shape < Flat || this->Shape > Profile)
  {
    return palpate::joined("Shape ", this->Shape,
      " is unknown: give 0 Flat, 1 Paraboloid, 2 Sphere, 3 Cone, 4 TruncatedCone, 5 BluntedCone, "
      "6 RoundedFlat, 7 PowerLaw or 8 Profile");
  }
  const palpate::ToolSpecification specification = this->MakeSpecification();
  this->Kernel = palpate::makeTool(specification);
  if (!this->Kernel)
  {
    return "Invalid tool: " + palpate::checkTool(specification);
  }
  this->KernelTime = this->GetMTime();
  return {};
}

const palpate::AxisymmetricTool* vtkContactTool::GetKernel()
{
  const std::string fault = this->FindFault();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
  }
  return this->Kernel.get();
}

/// Returns the kernel if its law holds at the deflection. Otherwise reports an error and returns
/// null.
const palpate::AxisymmetricTool* vtkContactTool::GetKernelFor(double deflection)
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  const std::string fault = tool ? tool->checkDepth(deflection) : std::string();
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Too deep: " << fault << ".");
    return nullptr;
  }
  return tool;
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
  // Parameters that the shape does not use keep their values.
  this->SetShape(static_cast<int>(read.Shape));
  switch (this->Shape)
  {
    case PowerLaw:
      this->SetExponent(read.Exponent);
      this->SetCoefficient(read.Coefficient);
      break;
    case Profile:
    {
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      for (const palpate::ProfilePoint& point : read.Profile)
      {
        points->InsertNextPoint(point.r, point.f, 0.0);
      }
      this->SetProfile(points);
      break;
    }
    case Cone:
      this->SetHalfAngle(read.HalfAngle);
      break;
    case TruncatedCone:
    case BluntedCone:
      this->SetHalfAngle(read.HalfAngle);
      this->SetRadius(read.Radius);
      break;
    case RoundedFlat:
      this->SetEdgeRadius(read.EdgeRadius);
      this->SetRadius(read.Radius);
      break;
    default:
      this->SetRadius(read.Radius);
      break;
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
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  if (!tool)
  {
    return {};
  }
  const std::string radius = ", radius " + palpate::shortestDecimals(this->Radius) + " mm";
  const std::string angle =
    ", half angle " + palpate::shortestDecimals(this->HalfAngle) + " degrees";
  switch (this->Shape)
  {
    case Flat:
      return "flat" + radius;
    case Paraboloid:
      return "paraboloid" + radius;
    case Sphere:
      return "sphere" + radius;
    case Cone:
      return "cone" + angle;
    case TruncatedCone:
      return "truncated cone" + radius + angle;
    case BluntedCone:
      return "blunted cone" + radius + angle;
    case RoundedFlat:
      return "rounded flat" + radius + ", edge " + palpate::shortestDecimals(this->EdgeRadius) +
        " mm";
    case PowerLaw:
      return "power law, " + palpate::shortestDecimals(this->Coefficient) + " r^" +
        palpate::shortestDecimals(this->Exponent) + " mm";
    default:
      return "profile of " + std::to_string(this->ProfilePoints->GetNumberOfPoints()) +
        " points, radius " + palpate::shortestDecimals(tool->largestContactRadius()) + " mm";
  }
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
  const palpate::AxisymmetricTool* tool = this->GetKernelFor(deflection);
  return tool && this->CheckModulus(reducedModulus) ? tool->force(deflection, reducedModulus) : NaN;
}

double vtkContactTool::GetStiffness(double deflection, double reducedModulus)
{
  const palpate::AxisymmetricTool* tool = this->GetKernelFor(deflection);
  return tool && this->CheckModulus(reducedModulus) ? tool->stiffness(deflection, reducedModulus)
                                                    : NaN;
}

double vtkContactTool::GetContactRadius(double deflection)
{
  const palpate::AxisymmetricTool* tool = this->GetKernelFor(deflection);
  return tool ? tool->contactRadius(deflection) : NaN;
}

double vtkContactTool::GetPressure(double r, double deflection, double reducedModulus)
{
  const palpate::AxisymmetricTool* tool = this->GetKernelFor(deflection);
  return tool && this->CheckModulus(reducedModulus) ? tool->pressure(r, deflection, reducedModulus)
                                                    : NaN;
}

void vtkContactTool::GetSurfaceDisplacement(
  double r, double deflection, double poissonRatio, double u[2])
{
  u[0] = u[1] = NaN;
  const palpate::AxisymmetricTool* tool = this->GetKernelFor(deflection);
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

double vtkContactTool::GetDepthLimit()
{
  const palpate::AxisymmetricTool* tool = this->GetKernel();
  return tool ? tool->depthLimit().depth : NaN;
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
  os << indent << "EdgeRadius: " << this->EdgeRadius << " mm\n";
  os << indent << "Exponent: " << this->Exponent << "\n";
  os << indent << "Coefficient: " << this->Coefficient << " mm^(1-Exponent)\n";
  os << indent << "ProfilePoints: " << this->ProfilePoints.Get() << "\n";
}
