// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolTouch.h"

#include "Mechanics/Checked.h"
#include "Response/Touch/CoupledTips.h"
#include "Response/BodyConversion.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyField.h"
#include "Response/ContactArrays.h"
#include "Response/Pieces/Ranks.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/ResponseTool.h"
#include "Response/RoundNumber.h"
#include "Response/Touch/TouchStart.h"
#include "Response/Touch/TipContacts.h"
#include "Response/Touch/TouchText.h"
#include "Response/Touch/TouchedBody.h"
#include "vtkContactSettings.h"
#include "vtkContactTool.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double ProbeShare = 0.9; // fraction of the progress that the probe takes
// Length of the arrow for the force at half of Range, as a fraction of the body's diagonal.
constexpr double ArrowShare = 0.2;

using palpate::Vector3;

vtkSmartPointer<vtkPolyData> tipsAt(const std::vector<palpate::Touch>& touches)
{
  auto tips = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const palpate::Touch& touch : touches)
  {
    points->InsertNextPoint(touch.tip.data());
  }
  tips->SetPoints(points);
  return tips;
}

} // namespace

vtkStandardNewMacro(vtkToolTouch);

vtkToolTouch::vtkToolTouch()
  : Settings(vtkSmartPointer<vtkContactSettings>::New())
  , Touched(std::make_unique<palpate::TouchedBody>())
  , Field(std::make_unique<palpate::BodyField>())
  , SecondField(std::make_unique<palpate::BodyField>())
{
  this->SetNumberOfOutputPorts(4);
}

vtkToolTouch::~vtkToolTouch() = default;

int vtkToolTouch::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == TextPort ? "vtkTable" : "vtkPolyData");
  return 1;
}

void vtkToolTouch::SetSettings(vtkContactSettings* settings)
{
  if (this->Settings != settings)
  {
    this->Settings = settings ? settings : vtkSmartPointer<vtkContactSettings>::New().Get();
    this->Modified();
  }
}

vtkContactSettings* vtkToolTouch::GetSettings()
{
  return this->Settings;
}

vtkMTimeType vtkToolTouch::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Settings->GetMTime());
}

void vtkToolTouch::SetTipPosition(double x, double y, double z)
{
  const double position[3] = { x, y, z };
  if (!this->TipIsSet || !std::equal(position, position + 3, this->TipPosition))
  {
    std::copy_n(position, 3, this->TipPosition);
    this->TipIsSet = true;
    this->Modified();
  }
}

bool vtkToolTouch::FindStart(vtkPolyData* body, const std::string& responseName,
  const double towards[3], const double up[3], double start[3])
{
  palpate::Sight sight;
  sight.towards = Vector3(towards);
  sight.up = Vector3(up);
  const palpate::TouchedPlace place = palpate::findTouchStart(body, responseName, sight);
  if (place.cell >= 0)
  {
    std::copy_n(place.point.data(), 3, start);
  }
  return place.cell >= 0;
}

bool vtkToolTouch::Fail(const std::string& fault)
{
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
  }
  return !fault.empty();
}

bool vtkToolTouch::CheckSettings()
{
  const auto isLength = [](double value) { return std::isfinite(value) && value >= 0.0; };
  const Vector3 tip(this->TipPosition);
  const Vector3 second(this->SecondTipPosition);
  if (!tip.allFinite())
  {
    vtkErrorMacro(<< "Tip Position must be finite (mm), but is " << tip.transpose() << ".");
  }
  else if (this->SecondTip && !second.allFinite())
  {
    vtkErrorMacro(<< "Second Tip Position must be finite (mm), but is " << second.transpose()
                  << ".");
  }
  else if (!isLength(this->Indentation))
  {
    vtkErrorMacro(
      << "Indentation must be finite and not negative (mm, 0 for half of Range), but is "
      << this->Indentation << ".");
  }
  else if (!isLength(this->ForceScale) || !isLength(this->ToolLength))
  {
    vtkErrorMacro(
      << "Force Scale (mm/N) and Tool Length (mm) must be finite and not negative (0 for "
         "automatic), but are "
      << this->ForceScale << " and " << this->ToolLength << ".");
  }
  else if (!(this->Reach > 0.0 && std::isfinite(this->Reach)))
  {
    vtkErrorMacro(<< "Extent Of Dent (Reach) must be positive and finite (contact radii), but is "
                  << this->Reach << ".");
  }
  else if (!palpate::isPoissonsRatio(this->PoissonRatio))
  {
    vtkErrorMacro(<< "Poisson's Ratio must lie between 0 and 0.5, but is " << this->PoissonRatio
                  << ".");
  }
  else
  {
    return !this->Fail(this->Settings->GetFault());
  }
  return false;
}

bool vtkToolTouch::PrepareBody(vtkPolyData* body)
{
  if (this->Body && this->Source == body && this->SourceTime == body->GetMTime() &&
    this->SourceResponse == this->ResponseName)
  {
    return true;
  }
  this->Body = nullptr;
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(body); // the modification time of the copy does not change while the tip moves
  std::string fault;
  if (!this->Touched->take(copy, this->ResponseName, fault))
  {
    vtkErrorMacro(<< "Wrong body: " << fault << ".");
    return false;
  }
  this->Tool = palpate::findTool(nullptr, copy, this->ResponseName, fault);
  if (this->Fail(fault))
  {
    return false;
  }
  const double typical = this->Touched->typicalForce();
  const double wanted = ArrowShare * copy->GetLength() / typical;
  this->AutomaticScale = std::isfinite(wanted) && wanted > 0.0 ? palpate::roundDown(wanted) : 1.0;
  this->Contact = palpate::makeContactBody(copy, this->ResponseName, fault,
    [this](double share) { this->UpdateProgress(ProbeShare * share); });
  if (fault.empty())
  {
    fault = palpate::checkBody(copy, this->ResponseName);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong body: " << fault << ".");
    return false;
  }
  const std::string defects = palpate::describeDefects(this->Contact->surface.defects());
  if (!defects.empty())
  {
    vtkWarningMacro(<< "The mesh of the body is not sound: " << defects << ".");
  }
  this->StartIsFound = false;
  this->Body = copy;
  this->Source = body;
  this->SourceTime = body->GetMTime();
  this->SourceResponse = this->ResponseName;
  return true;
}

palpate::Touch vtkToolTouch::PressAlone(const double position[3])
{
  palpate::Touch touch;
  touch.tip = Vector3(position);
  touch.nearest = this->Touched->nearest(touch.tip);
  double depth = this->Indentation;
  if (this->Snap && touch.nearest.cell >= 0)
  {
    touch.tip = touch.nearest.point;
    depth = depth > 0.0 ? depth : 0.5 * this->Touched->range(touch.nearest);
  }
  // A single tip has no history and therefore no friction.
  palpate::touchWithTips(*this->Contact, tipsAt({ touch }), this->Settings->GetKernel(), depth,
    [&touch](vtkIdType, const palpate::Contact& contact, const Vector3&)
    { touch.contact = contact; });
  if (touch.contact.triangle >= 0)
  {
    touch.tip -= depth * touch.contact.normal;
  }
  else
  {
    const Vector3 away = touch.tip - touch.nearest.point;
    touch.contact.normal = away.norm() > 0.0 ? Vector3(away.normalized()) : Vector3::UnitZ();
  }
  return touch;
}

std::vector<palpate::Touch> vtkToolTouch::Probe()
{
  if (!this->TipIsSet && !this->StartIsFound)
  {
    const palpate::TouchedPlace place = palpate::findTouchStart(*this->Touched, this->Tool, {});
    std::copy_n(place.point.data(), 3, this->Start);
    this->StartIsFound = true;
  }
  std::vector<palpate::Touch> touches{ this->PressAlone(
    this->TipIsSet ? this->TipPosition : this->Start) };
  if (this->SecondTip)
  {
    touches.push_back(this->PressAlone(this->SecondTipPosition));
  }
  const bool isCoupled = touches.size() > 1 && this->Contact->coupling;
  this->Probed->ShallowCopy(tipsAt(touches));
  if (isCoupled)
  {
    palpate::touchTogether(*this->Contact, this->Probed, this->Settings->GetKernel(), 0.0,
      [&touches](vtkIdType tip, const palpate::Contact& contact, const Vector3&)
      {
        palpate::Touch& touch = touches[static_cast<std::size_t>(tip)];
        if (contact.triangle >= 0)
        {
          touch.sunk = touch.contact.deflection - contact.deflection;
          touch.contact = contact;
        }
      });
  }
  const vtkIdType firstPoly = this->Body->GetNumberOfVerts() + this->Body->GetNumberOfLines();
  palpate::ContactArrays arrays(static_cast<vtkIdType>(touches.size()));
  for (std::size_t i = 0; i < touches.size(); ++i)
  {
    palpate::Touch& touch = touches[i];
    const palpate::Contact& contact = touch.contact;
    palpate::Contact stored = contact;
    if (contact.triangle >= 0)
    {
      touch.place = this->Touched->placeIn(firstPoly + contact.triangle, contact.contactPoint);
      touch.range = this->Touched->range(touch.place);
      touch.stiffness = this->Touched->stiffness(touch.place, contact.deflection);
      touch.validity = this->Touched->validity(touch.place, contact.deflection);
    }
    else
    {
      stored.normal = Vector3::Zero(); // the displayed normal is not the normal of a contact
    }
    touch.isAlone = touches.size() > 1 && !isCoupled;
    touch.scale = this->ForceScale > 0.0 ? this->ForceScale : this->AutomaticScale;
    arrays.store(static_cast<vtkIdType>(i), stored, firstPoly);
  }
  arrays.attach(this->Probed);
  return touches;
}

int vtkToolTouch::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  const bool hasBody = body && body->GetNumberOfPoints() > 0;
  const palpate::Ranks ranks(vtkMultiProcessController::GetGlobalController());
  std::size_t pieces = 0;
  for (const auto& piece : ranks.gather(hasBody ? std::vector<char>(1) : std::vector<char>()))
  {
    pieces += piece.size();
  }
  if (pieces > 1)
  {
    vtkErrorMacro(<< "The body lies in pieces on " << pieces
                  << " processes, but must be on one: apply Aggregate Dataset first, or use Tool "
                     "Contact Probe and Contact Deflection.");
    return 0;
  }
  if (!hasBody)
  {
    return 1;
  }
  if (!this->CheckSettings() || !this->PrepareBody(body))
  {
    return 0;
  }
  const std::vector<palpate::Touch> touches = this->Probe();
  if (!this->MakeDent(touches, vtkPolyData::GetData(outputVector, BodyPort)) ||
    !this->MakeTools(touches, vtkPolyData::GetData(outputVector, ToolPort)))
  {
    return 0;
  }
  this->MakeArrows(touches, vtkPolyData::GetData(outputVector, ArrowPort));
  vtkNew<vtkStringArray> text;
  text->SetName("Text");
  text->InsertNextValue(palpate::describeTouches(touches, this->Tool->GetDescription()));
  vtkTable::GetData(outputVector, TextPort)->AddColumn(text);
  return 1;
}

void vtkToolTouch::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TipPosition: " << this->TipPosition[0] << ", " << this->TipPosition[1] << ", "
     << this->TipPosition[2] << (this->TipIsSet ? " mm\n" : " (not set)\n");
  os << indent << "SecondTip: " << this->SecondTip << "\n";
  os << indent << "SecondTipPosition: " << this->SecondTipPosition[0] << ", "
     << this->SecondTipPosition[1] << ", " << this->SecondTipPosition[2] << " mm\n";
  os << indent << "Snap: " << this->Snap << "\n";
  os << indent << "Indentation: " << this->Indentation << " mm\n";
  os << indent << "Settings:\n";
  this->Settings->PrintSelf(os, indent.GetNextIndent());
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "Reach: " << this->Reach << " contact radii\n";
  os << indent << "ForceScale: " << this->ForceScale << " mm/N\n";
  os << indent << "ToolLength: " << this->ToolLength << " mm\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}
