// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBodySurface.h"

#include "Response/Bodies/BodyBlocks.h"
#include "Response/BodyConversion.h"
#include "Response/Pieces/LoadedPieces.h"
#include "Response/Bodies/InnerWalls.h"
#include "Mechanics/JoinedText.h"
#include "Response/Pieces/Ranks.h"
#include "Response/Pieces/SeamNormals.h"
#include "Response/Bodies/SurfaceTriangles.h"

#include "vtkAppendPolyData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr double SmallestBody = 5.0;   // smallest plausible value of the longest side, mm
constexpr double LargestBody = 5000.0; // largest plausible value of the longest side, mm
// Number of millimetres per unit, for each LengthUnitType.
constexpr std::array<double, 3> Millimetres = { 1.0, 10.0, 1000.0 };

vtkSmartPointer<vtkPolyData> turned(vtkPolyData* surface)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->Update();
  return reverse->GetOutput();
}

std::vector<std::string> names(const std::vector<palpate::BodyBlock>& blocks)
{
  std::vector<std::string> all;
  for (const palpate::BodyBlock& block : blocks)
  {
    all.push_back(block.name);
  }
  return all;
}

} // namespace

vtkStandardNewMacro(vtkBodySurface);

//------------------------------------------------------------------------------
vtkBodySurface::vtkBodySurface()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkBodySurface::~vtkBodySurface() = default;

//------------------------------------------------------------------------------
void vtkBodySurface::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkBodySurface::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
void vtkBodySurface::SetLengthUnit(int unit)
{
  this->SetLengthScale(Millimetres[static_cast<std::size_t>(
    std::clamp(unit, static_cast<int>(Millimetre), static_cast<int>(Metre)))]);
}

//------------------------------------------------------------------------------
int vtkBodySurface::GetLengthUnit()
{
  const auto* found = std::find(Millimetres.begin(), Millimetres.end(), this->LengthScale);
  return found == Millimetres.end() ? -1 : static_cast<int>(found - Millimetres.begin());
}

//------------------------------------------------------------------------------
bool vtkBodySurface::IsSizeDoubtful(double longestSide)
{
  return longestSide > 0.0 && (longestSide < SmallestBody || longestSide > LargestBody);
}

//------------------------------------------------------------------------------
std::string vtkBodySurface::GetNote(int index)
{
  return index >= 0 && index < this->GetNumberOfNotes()
    ? this->Notes[static_cast<std::size_t>(index)]
    : "";
}

//------------------------------------------------------------------------------
int vtkBodySurface::FillInputPortInformation(int, vtkInformation* info)
{
  // The composite type is first, so that a composite data set is processed as a whole and not block
  // by block. The last type admits all other data. For these, RequestData reports an error with the
  // remedy.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBodySurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  const int ghosts = output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  if (output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1 &&
    !vtkPolyData::SafeDownCast(input->Get(vtkDataObject::DATA_OBJECT())))
  {
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), std::max(1, ghosts));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkBodySurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Notes.clear();
  this->LongestSide = 0.0;
  if (!(this->LengthScale > 0.0) || !std::isfinite(this->LengthScale))
  {
    vtkErrorMacro(<< "LengthScale must be positive and finite (mm), but is " << this->LengthScale
                  << ".");
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const palpate::Ranks ranks(this->Controller);
  std::string missing;
  std::string fault =
    ranks.firstFault(this->Gather(inputVector[0]->GetInformationObject(0), output, ranks, missing));
  if (fault.empty() && !ranks.any(output->GetNumberOfPolys() > 0))
  {
    fault = ranks.firstFault(missing);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << fault << ".");
    output->Initialize();
    return 0;
  }
  fault = palpate::missingPieces(ranks);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    output->Initialize();
    return 0;
  }
  this->TurnPieces(output, ranks);
  this->Scale(output);
  this->Measure(output, ranks);
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkBodySurface::Gather(
  vtkInformation* input, vtkPolyData* output, const palpate::Ranks& ranks, std::string& missing)
{
  const palpate::BodyBlocks found(input->Get(vtkDataObject::DATA_OBJECT()));
  if (ranks.any(!found.fault().empty()))
  {
    return found.fault();
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int* wholeExtent =
    input->Has(Pipeline::WHOLE_EXTENT()) ? input->Get(Pipeline::WHOLE_EXTENT()) : nullptr;

  std::vector<palpate::BodyBlock> blocks = found.blocks();
  if (ranks.any(palpate::countVolumes(blocks) > 1))
  {
    palpate::joinVolumes(blocks);
  }
  std::vector<palpate::SurfaceTriangles> parts;
  std::vector<std::string> places;
  std::string fault;
  for (const palpate::BodyBlock& block : blocks)
  {
    parts.push_back(
      palpate::extractSurface(block.pieces, blocks.size() == 1 ? wholeExtent : nullptr));
    places.push_back(blocks.size() > 1 ? palpate::joined("block ", block.name, ": ") : "");
    if (fault.empty() && !parts.back().fault.empty())
    {
      fault = places.back() + parts.back().fault;
    }
  }
  if (ranks.any(!fault.empty()))
  {
    return fault;
  }
  palpate::removeInnerWalls(parts, names(blocks), ranks);

  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  std::vector<vtkDataSet*> all;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    palpate::SurfaceTriangles& made = parts[i];
    const std::string& where = places[i];
    palpate::cutSurface(made, blocks[i].pieces, palpate::extentOn(ranks));
    for (const std::string& note : made.notes)
    {
      this->Notes.push_back(where + note);
    }
    if (!made.loss.empty())
    {
      vtkWarningMacro(<< where << made.loss << ".");
    }
    if (made.surface)
    {
      surfaces.push_back(made.surface);
      all.insert(all.end(), blocks[i].pieces.begin(), blocks[i].pieces.end());
      continue;
    }
    if (!made.isEmpty)
    {
      return where + made.fault;
    }
    missing = missing.empty() ? where + made.fault : missing;
    this->Notes.push_back(palpate::joined("left out: ", where, made.fault));
  }
  const std::string lost = palpate::arraysNotShared(all);
  if (!lost.empty() && ranks.own() == 0)
  {
    vtkWarningMacro(<< "Point arrays that are not on all parts of the body are left out: " << lost
                    << ".");
  }

  if (surfaces.size() == 1)
  {
    output->ShallowCopy(surfaces.front());
  }
  else if (surfaces.size() > 1)
  {
    vtkNew<vtkAppendPolyData> append;
    for (vtkPolyData* surface : surfaces)
    {
      append->AddInputData(surface);
    }
    append->Update();
    output->ShallowCopy(append->GetOutput());
    this->Notes.push_back(palpate::joined(surfaces.size(), " blocks appended"));
  }
  return "";
}

//------------------------------------------------------------------------------
void vtkBodySurface::TurnPieces(vtkPolyData* body, const palpate::Ranks& ranks)
{
  if (ranks.areAlone())
  {
    return;
  }
  vtkNew<vtkPolyData> own;
  own->ShallowCopy(body);
  own->RemoveGhostCells();
  const palpate::BodyMesh mesh = palpate::makeBodyMesh(own);
  const palpate::SeamClosure whole = palpate::closureOf(mesh, palpate::BodySeam(ranks, own));
  if (whole.isClosed && whole.enclosedVolume < 0.0)
  {
    body->ShallowCopy(turned(body));
    this->Notes.push_back("the pieces were inside out: triangles turned");
  }
}

//------------------------------------------------------------------------------
void vtkBodySurface::Measure(vtkPolyData* body, const palpate::Ranks& ranks)
{
  constexpr double None = std::numeric_limits<double>::infinity();
  double box[6] = { None, -None, None, -None, None, -None };
  if (body->GetNumberOfPolys() > 0)
  {
    body->GetCellsBounds(box);
  }
  for (int i = 0; i < 6; i += 2)
  {
    const double side = ranks.largest(box[i + 1]) - ranks.smallest(box[i]);
    // The side is negative if the box is empty.
    this->LongestSide = std::max(this->LongestSide, side);
  }
  if (this->AskAboutSize && ranks.own() == 0 && vtkBodySurface::IsSizeDoubtful(this->LongestSide))
  {
    vtkWarningMacro(<< "The longest side of the body is " << this->LongestSide
                    << " mm: is the Length Unit right?");
  }
}

//------------------------------------------------------------------------------
void vtkBodySurface::Scale(vtkPolyData* body)
{
  if (this->LengthScale == 1.0 || body->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkPoints* given = body->GetPoints();
  vtkNew<vtkPoints> scaled;
  scaled->SetDataType(given->GetDataType());
  scaled->SetNumberOfPoints(given->GetNumberOfPoints());
  for (vtkIdType i = 0; i < given->GetNumberOfPoints(); ++i)
  {
    double p[3];
    given->GetPoint(i, p);
    scaled->SetPoint(
      i, this->LengthScale * p[0], this->LengthScale * p[1], this->LengthScale * p[2]);
  }
  body->SetPoints(scaled);
  this->Notes.push_back(palpate::joined("scaled by ", this->LengthScale, " to millimetres"));
}

//------------------------------------------------------------------------------
void vtkBodySurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "LengthScale: " << this->LengthScale << " mm\n";
  os << indent << "AskAboutSize: " << this->AskAboutSize << "\n";
  os << indent << "LongestSide: " << this->LongestSide << " mm\n";
  for (const std::string& note : this->Notes)
  {
    os << indent << "Note: " << note << "\n";
  }
}
