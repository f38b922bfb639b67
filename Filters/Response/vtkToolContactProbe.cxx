// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolContactProbe.h"

#include "BodyConversion.h"
#include "ContactArrays.h"
#include "GivenSettings.h"
#include "ToolContact.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <sstream>
#include <vector>

namespace
{
/// Of the progress, what building the kernel's copy of the body takes.
constexpr double BuildShare = 0.9;

/// The tip moved inward along the blended normal at its closest point.
palpate::Vector3 pressedTip(
  const palpate::ContactBody& body, const palpate::Vector3& tip, double indentation)
{
  if (indentation == 0.0)
  {
    return tip;
  }
  const palpate::SurfacePoint nearest = body.tree.closest(tip);
  if (nearest.triangle < 0)
  {
    return tip;
  }
  palpate::Vector3 normal = palpate::Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    normal += nearest.projection.weights[k] *
      body.response.normal(body.surface.corners(nearest.triangle)[static_cast<std::size_t>(k)]);
  }
  const double length = normal.norm();
  return length > 0.0 ? palpate::Vector3(tip - indentation / length * normal) : tip;
}

/// What is wrong with the polylines, or "".
std::string checkLines(vtkPolyData* tips)
{
  vtkCellArray* lines = tips->GetLines();
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(line, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (points[i] < 0 || points[i] >= tips->GetNumberOfPoints())
      {
        return "polyline " + std::to_string(line) + " goes through point " +
          std::to_string(points[i]) + ", but there are " +
          std::to_string(tips->GetNumberOfPoints()) + " points";
      }
    }
  }
  return {};
}

/// What is wrong with the times along the polylines of tips that have passed checkLines, or "".
std::string checkTimes(vtkPolyData* tips)
{
  vtkCellArray* lines = tips->GetLines();
  vtkAbstractArray* given = tips->GetPointData()->GetAbstractArray("Time");
  if (!given || lines->GetNumberOfCells() == 0)
  {
    return {};
  }
  auto* times = vtkDataArray::SafeDownCast(given);
  if (!times || times->GetNumberOfComponents() != 1 ||
    times->GetNumberOfTuples() != tips->GetNumberOfPoints())
  {
    return "the point array 'Time' must hold one number per point";
  }
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(line, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const double time = times->GetTuple1(points[i]);
      const double before = i > 0 ? times->GetTuple1(points[i - 1]) : time;
      if (!std::isfinite(time) || time < before)
      {
        std::ostringstream text;
        text << "the point array 'Time' is " << time << " at point " << points[i];
        if (std::isfinite(time))
        {
          text << ", after " << before << " at point " << points[i - 1];
        }
        text << " (polyline " << line << "), but must be finite and not decrease along a polyline";
        return text.str();
      }
    }
  }
  return {};
}
} // namespace

vtkStandardNewMacro(vtkToolContactProbe);

vtkToolContactProbe::vtkToolContactProbe()
{
  this->SetNumberOfInputPorts(2);
}

vtkToolContactProbe::~vtkToolContactProbe() = default;

int vtkToolContactProbe::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

bool vtkToolContactProbe::PrepareBody(vtkPolyData* body)
{
  if (this->Body && this->BodySource == body && this->BodyTime == body->GetMTime() &&
    this->BodyResponse == this->ResponseName)
  {
    return true;
  }
  std::string error;
  this->Body = palpate::makeContactBody(body, this->ResponseName, error,
    [this](double share) { this->UpdateProgress(BuildShare * share); });
  if (!this->Body)
  {
    vtkErrorMacro(<< "Wrong body: " << error << ".");
    return false;
  }
  const bool isNew = this->BodySource != body || this->BodyTime != body->GetMTime();
  const std::string defects = palpate::describeDefects(*this->Body);
  if (isNew && !defects.empty())
  {
    vtkWarningMacro(<< "The mesh of the body is not sound: " << defects << ".");
  }
  this->BodySource = body;
  this->BodyTime = body->GetMTime();
  this->BodyResponse = this->ResponseName;
  return true;
}

bool vtkToolContactProbe::ReadSettings(palpate::ContactSettings& settings)
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

int vtkToolContactProbe::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* tips = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!body || !tips || tips->GetNumberOfPoints() == 0 || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  palpate::ContactSettings settings;
  if (!this->ReadSettings(settings))
  {
    return 0;
  }
  if (!std::isfinite(this->Indentation))
  {
    vtkErrorMacro(<< "Indentation must be finite (mm), but is " << this->Indentation << ".");
    return 0;
  }
  std::string fault = checkLines(tips);
  if (fault.empty())
  {
    fault = checkTimes(tips);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong tips: " << fault << ".");
    return 0;
  }
  if (!this->PrepareBody(body))
  {
    return 0;
  }

  const palpate::ContactBody& kernel = *this->Body;
  const vtkIdType firstPoly = body->GetNumberOfVerts() + body->GetNumberOfLines();
  const vtkIdType count = tips->GetNumberOfPoints();
  palpate::ContactArrays arrays(count);
  const auto evaluate = [&](palpate::ToolContact& contact, vtkIdType tip)
  {
    palpate::Vector3 position;
    tips->GetPoint(tip, position.data());
    arrays.store(tip, contact.update(pressedTip(kernel, position, this->Indentation)), firstPoly);
  };

  std::vector<char> inHistory(static_cast<std::size_t>(count), 0);
  vtkCellArray* lines = tips->GetLines();
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(line, size, points);
    palpate::ToolContact history(kernel, settings);
    for (vtkIdType i = 0; i < size; ++i)
    {
      inHistory[static_cast<std::size_t>(points[i])] = 1;
      evaluate(history, points[i]);
    }
  }
  palpate::ContactSettings frictionless = settings;
  frictionless.friction.coefficient = 0.0;
  vtkSMPTools::For(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      palpate::ToolContact single(kernel, frictionless);
      for (vtkIdType tip = first; tip < last; ++tip)
      {
        if (!inHistory[static_cast<std::size_t>(tip)])
        {
          single.reset();
          evaluate(single, tip);
        }
      }
    });

  output->ShallowCopy(tips);
  arrays.attach(output);
  return 1;
}

void vtkToolContactProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ForceForm: " << this->ForceForm << "\n";
  os << indent << "ContactSurface: " << this->ContactSurface << "\n";
  os << indent << "FrictionCoefficient: " << this->FrictionCoefficient << "\n";
  os << indent << "FrictionModel: " << this->FrictionModel << "\n";
  os << indent << "TangentialStiffness: " << this->TangentialStiffness << " N/mm\n";
  os << indent << "FrictionBreakaway: " << this->FrictionBreakaway << "\n";
  os << indent << "FrictionStickRadius: " << this->FrictionStickRadius << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "Indentation: " << this->Indentation << " mm\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}
