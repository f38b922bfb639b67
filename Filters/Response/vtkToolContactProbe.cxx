// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolContactProbe.h"

#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/Pieces/LoadedPieces.h"
#include "Response/ContactArrays.h"
#include "Response/Curves/StoredError.h"
#include "Response/Pieces/OwnPiece.h"
#include "Response/Pieces/Ranks.h"
#include "Response/Touch/CoupledTips.h"
#include "Response/Touch/TipContacts.h"
#include "Response/Touch/TipPoses.h"
#include "Response/Touch/TipTimes.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
/// Fraction of the progress that the creation of the kernel's copy of the body takes.
constexpr double BuildShare = 0.9;

/// Checks that the response of each piece can be read, and that all pieces have the same type of
/// response. Returns "" or an error message. Collective. `isSlow` is set to true if the body does
/// not relax. `isCoupled` is set to true if contacts can interact.
std::string checkPieces(const palpate::Ranks& ranks, vtkPolyData* piece, const std::string& name,
  bool& isSlow, bool& isCoupled)
{
  std::string fault;
  palpate::ResponseArrays arrays;
  const bool hasPiece = piece->GetNumberOfPoints() > 0;
  if (hasPiece)
  {
    fault = palpate::checkTriangles(piece);
    if (fault.empty() && !palpate::viewResponse(piece, name, arrays, fault))
    {
      fault = "no response '" + name + "' on the body: " + fault;
    }
  }
  fault = ranks.firstFault(fault);
  if (!fault.empty())
  {
    return fault;
  }
  using Kind = std::array<double, 11 + 2 * palpate::PronySeries::LargestCount>;
  const palpate::RelaxationTerms& terms = arrays.relaxation;
  const palpate::CouplingTerms& couples = arrays.coupling;
  Kind own{ static_cast<double>(arrays.samples), static_cast<double>(arrays.laws), arrays.exponent,
    static_cast<double>(terms.series.count), terms.strength ? 1.0 : 0.0,
    terms.elasticCompliance ? 1.0 : 0.0, couples.modulus, couples.thickness,
    static_cast<double>(couples.modeCount), couples.localModulus ? 1.0 : 0.0,
    couples.localThickness ? 1.0 : 0.0 };
  for (std::size_t i = 0; i < terms.series.count; ++i)
  {
    own[11 + 2 * i] = terms.series.strength[i];
    own[12 + 2 * i] = terms.series.time[i];
  }
  const auto all = ranks.gather(hasPiece ? std::vector<Kind>{ own } : std::vector<Kind>{});
  for (const std::vector<Kind>& each : all)
  {
    if (hasPiece && !each.empty() && each.front() != own)
    {
      fault = "the pieces of the body have responses '" + name +
        "' of different samples, laws, exponent, relaxation or coupling: make them together";
    }
  }
  isSlow = !ranks.any(terms.areFelt());
  isCoupled = ranks.any(couples.areFelt());
  return ranks.firstFault(fault);
}

std::string uncoupledFault(const std::string& name)
{
  return "Coupled is on, but response '" + name + "' has no coupling: " + "field array '" +
    palpate::arrayName(name, palpate::ResponseArray::Coupling) +
    "' is missing; make the response with Coupling on";
}

/// Checks that tips on several ranks can press at the same time. Returns "" or an error message.
/// Collective.
std::string checkTogether(const palpate::Ranks& ranks, vtkPolyData* tips)
{
  int count = 0;
  for (const std::vector<char>& each :
    ranks.gather(std::vector<char>(tips->GetNumberOfPoints() > 0 ? 1 : 0)))
  {
    count += static_cast<int>(each.size());
  }
  return count > 1
    ? palpate::joined("Coupled is on, but the tips are on ", count,
        " processes, and tips on different processes do not interact: give all tips to one process")
    : std::string();
}
} // namespace

vtkStandardNewMacro(vtkToolContactProbe);

vtkToolContactProbe::vtkToolContactProbe()
  : Controller(vtkMultiProcessController::GetGlobalController())
  , Settings(vtkSmartPointer<vtkContactSettings>::New())
{
  this->SetNumberOfInputPorts(2);
}

vtkToolContactProbe::~vtkToolContactProbe() = default;

void vtkToolContactProbe::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkToolContactProbe::GetController()
{
  return this->Controller;
}

int vtkToolContactProbe::FillInputPortInformation(int, vtkInformation* info)
{
  // Accepts any data, as a whole or block by block, because RequestData reports a wrong type
  // together with the remedy.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
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
  const std::string defects = palpate::describeDefects(this->Body->surface.defects());
  if (isNew && !defects.empty())
  {
    vtkWarningMacro(<< "The mesh of the body is not sound: " << defects << ".");
  }
  this->BodySource = body;
  this->BodyTime = body->GetMTime();
  this->BodyResponse = this->ResponseName;
  return true;
}

vtkMTimeType vtkToolContactProbe::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Settings->GetMTime());
}

int vtkToolContactProbe::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  palpate::passTimes(inputVector, outputVector->GetInformationObject(0));
  return 1;
}

int vtkToolContactProbe::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const palpate::Ranks ranks(this->Controller);
  std::string fault = palpate::checkType(inputVector[0]->GetInformationObject(0), "body");
  if (fault.empty())
  {
    fault = palpate::checkType(inputVector[1]->GetInformationObject(0), "tips");
  }
  fault = ranks.firstFault(fault);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << fault << ".");
    return 0;
  }
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* tips = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  palpate::passDataTime(body, tips, output);
  const bool hasTips = tips && tips->GetNumberOfPoints() > 0;
  if (!ranks.any(hasTips) || !ranks.any(body && body->GetNumberOfPoints() > 0))
  {
    return 1;
  }
  fault = this->Settings->GetFault();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  const palpate::ContactSettings& settings = this->Settings->GetKernel();
  if (!std::isfinite(this->Indentation))
  {
    vtkErrorMacro(<< "Indentation must be finite (mm), but is " << this->Indentation << ".");
    return 0;
  }
  fault = hasTips ? palpate::checkTips(tips) : std::string();
  if (fault.empty() && hasTips && this->Coupled)
  {
    fault = palpate::checkCoupledTips(tips);
  }
  fault = ranks.firstFault(fault);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong tips: " << fault << ".");
    return 0;
  }
  if (ranks.areAlone())
  {
    if (!this->PrepareBody(body))
    {
      return 0;
    }
    const vtkIdType firstPoly = body->GetNumberOfVerts() + body->GetNumberOfLines();
    if (this->Coupled && !this->Body->coupling)
    {
      vtkErrorMacro(<< uncoupledFault(this->ResponseName) << ".");
      return 0;
    }
    palpate::ContactArrays arrays(
      tips->GetNumberOfPoints(), this->Body->relaxation != nullptr, palpate::haveAxes(tips));
    const palpate::TipVisitor store =
      [&arrays, firstPoly](vtkIdType tip, const palpate::Contact& contact, const palpate::Vector3&)
    { arrays.store(tip, contact, firstPoly); };
    output->ShallowCopy(tips);
    std::vector<double> coupling;
    if (this->Coupled)
    {
      vtkNew<vtkDoubleArray> stiffness;
      stiffness->SetName("CoupledStiffness");
      palpate::touchTogether(
        *this->Body, tips, settings, this->Indentation, store, stiffness, &coupling);
      output->GetPointData()->AddArray(stiffness);
    }
    else
    {
      palpate::touchWithTips(*this->Body, tips, settings, this->Indentation, store);
    }
    arrays.attach(output);
    palpate::addContactErrors(body, this->ResponseName, output, coupling);
  }
  else if (!this->TouchPieces(ranks, body, tips, settings, output))
  {
    return 0;
  }
  palpate::passDataTime(body, tips, output);
  return 1;
}

bool vtkToolContactProbe::TouchPieces(const palpate::Ranks& ranks, vtkPolyData* body,
  vtkPolyData* givenTips, const palpate::ContactSettings& settings, vtkPolyData* output)
{
  const auto own = palpate::ownPiece(body, ranks);
  const auto tips = palpate::ownPiece(givenTips, ranks);
  bool isSlow = true;
  bool isCoupled = false;
  std::string fault = palpate::missingPieces(ranks);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return false;
  }
  fault = checkPieces(ranks, own, this->ResponseName, isSlow, isCoupled);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong body: " << fault << ".");
    return false;
  }
  if (this->Coupled)
  {
    fault = isCoupled ? checkTogether(ranks, tips) : uncoupledFault(this->ResponseName);
    if (!fault.empty())
    {
      vtkErrorMacro(<< fault << ".");
      return false;
    }
  }
  const palpate::PiecesModule& module = *palpate::loadedPieces().module;
  const vtkMTimeType time = body ? body->GetMTime() : 0;
  const bool isNew = ranks.any(!this->Piece || this->BodySource != body || this->BodyTime != time);
  if (isNew)
  {
    this->Piece = module.makePiece(own, palpate::BodySeam(ranks, own));
    this->BodySource = body;
    this->BodyTime = time;
    this->BodyResponse.clear();
    this->Body.reset();
  }
  const auto press = [&](const palpate::ContactBody& part, const palpate::TipVisitor& visit)
  {
    this->Coupled ? palpate::touchTogether(part, tips, settings, this->Indentation, visit)
                  : palpate::touchWithTips(part, tips, settings, this->Indentation, visit);
  };
  std::vector<palpate::PieceTouch> touched;
  std::string defects;
  fault = module.touch(ranks, *this->Piece, this->ResponseName,
    { tips, settings, this->Indentation, press }, touched, defects);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong body: " << fault << ".");
    return false;
  }
  if (isNew && !defects.empty())
  {
    vtkWarningMacro(<< "The mesh of the body around the tips is not sound: " << defects << ".");
  }
  palpate::ContactArrays arrays(tips->GetNumberOfPoints(), !isSlow, palpate::haveAxes(tips));
  vtkNew<vtkIntArray> rankOf;
  rankOf->SetName("ContactRank");
  for (std::size_t i = 0; i < touched.size(); ++i)
  {
    arrays.store(static_cast<vtkIdType>(i), touched[i].contact, 0);
    rankOf->InsertNextValue(touched[i].rank);
  }
  output->ShallowCopy(tips);
  if (tips->GetNumberOfPoints() > 0)
  {
    arrays.attach(output);
    output->GetPointData()->AddArray(rankOf);
  }
  return true;
}

void vtkToolContactProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "Settings:\n";
  this->Settings->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Coupled: " << this->Coupled << "\n";
  os << indent << "Indentation: " << this->Indentation << " mm\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}
