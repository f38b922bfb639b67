// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElasticContactResponse.h"

#include "Solids/Curves/ShapedResponse.h"
#include "Mechanics/Checked.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "SolidResponse/Bodies/CoarserBody.h"
#include "SolidResponse/Bodies/SimplerLaw.h"
#include "SolidResponse/Bodies/SolvedBody.h"
#include "SolidResponse/Bodies/SourceSpacing.h"
#include "Response/BodyConversion.h"
#include "Response/BodyLaws.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/FilterThreads.h"
#include "Response/ReplacedCurves.h"
#include "Response/Terms/LawTerm.h"
#include "vtkContactTool.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
// Fractions of the progress at the end of the steps.
constexpr double SolvedShare = 0.9;
// Value that replaces SolvedShare if a coarser body is also solved.
constexpr double BodyShare = 0.75;
constexpr double RespondedShare = 0.95;
} // namespace

vtkStandardNewMacro(vtkElasticContactResponse);

vtkElasticContactResponse::vtkElasticContactResponse()
  : Kept(std::make_unique<palpate::SolvedBody>())
{
  this->SetNumberOfInputPorts(3);
}
vtkElasticContactResponse::~vtkElasticContactResponse() = default;

int vtkElasticContactResponse::FillInputPortInformation(int port, vtkInformation* info)
{
  const bool isSurface = port == 1;
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), isSurface ? "vtkPolyData" : "vtkUnstructuredGrid");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0 ? 1 : 0);
  return 1;
}

void vtkElasticContactResponse::SetSurfaceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkElasticContactResponse::SetSurfaceData(vtkPolyData* surface)
{
  this->SetInputData(1, surface);
}

void vtkElasticContactResponse::SetCoarserConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

void vtkElasticContactResponse::SetCoarserData(vtkUnstructuredGrid* coarser)
{
  this->SetInputData(2, coarser);
}

int vtkElasticContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(inputVector[0]);
  this->MemoryEstimate = 0.0;
  this->NumberOfSolutions = 0;
  this->TermReason.clear();
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const palpate::FilterThreads threads;
  bool isEnded = false;
  vtkPolyData* finer = vtkPolyData::GetData(inputVector[1]);
  vtkUnstructuredGrid* coarser = vtkUnstructuredGrid::GetData(inputVector[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const auto sound = finer ? std::make_unique<palpate::SoundBody>(finer) : nullptr;
  palpate::LawRequest request;
  const std::string fault = palpate::firstFault([&] { return this->CheckProperties(request); },
    [&] { return sound ? this->CheckSurface(*sound) : std::string(); },
    [&] { return coarser ? palpate::checkCoarser(grid, coarser) : std::string(); },
    [&] { return this->Solve(grid, coarser, isEnded); },
    [&]
    {
      vtkPolyData* surface = sound ? sound->body() : nullptr;
      return isEnded ? std::string() : this->Respond(request, grid, surface, output);
    });
  if (fault.empty() && sound)
  {
    sound->giveBack(output);
  }
  return this->Report(fault);
}

/// Fills the request of the response. Checks the request and the other properties. Returns "" or an
/// error message.
std::string vtkElasticContactResponse::CheckProperties(palpate::LawRequest& request)
{
  request.terms = palpate::LawTerms::plain();
  const std::string relaxing = this->FillRequest(request);
  request.terms.automatic = false; // off, because KeepSimplerLaw chooses the law at each point
  request.terms.changeTolerance = palpate::LawTerms().changeTolerance;
  return palpate::firstFault([&] { return palpate::checkShapedRequest(request); },
    [this] { return palpate::checkLength("Layer Thickness", this->LayerThickness); },
    [this]
    {
      return this->TermTolerance >= 0.0 && std::isfinite(this->TermTolerance)
        ? std::string()
        : palpate::joined("Largest Effect Left Out (TermTolerance) must be 0 or positive, but is ",
            this->TermTolerance);
    },
    [&] { return relaxing; },
    [&] {
      return palpate::checkTerms({ request, *this->Tool->GetKernel(), nullptr }, nullptr);
    },
    [this] { return palpate::checkLength("Largest Contact Radius", this->LargestContactRadius); },
    [this] {
      return palpate::checkLength("Spacing Of Solved Points (SourceSpacing)", this->SourceSpacing);
    });
}

std::string vtkElasticContactResponse::CheckSurface(const palpate::SoundBody& finer) const
{
  if (this->AutomaticTerms)
  {
    return "Leave Out Small Effects (AutomaticTerms) compares laws at the points of the solid and "
           "cannot be used with a Surface";
  }
  return finer.fault().empty() ? "" : "Wrong input: Surface: " + finer.fault();
}

/// Fills the settings of a solution, including the material arrays of this grid.
std::string vtkElasticContactResponse::FindMaterials(
  vtkUnstructuredGrid* grid, palpate::SolveRequest& request)
{
  request.factor.material = { this->YoungsModulus, this->PoissonRatio };
  request.factor.solver = this->Solver;
  request.factor.memoryLimit = this->MemoryLimit;
  request.radius = std::max(
    palpate::neededRadius(this->Tool, this->MaximumDeflection), this->LargestContactRadius);
  request.spacing = palpate::sourceSpacing(grid, this->SourceSpacing);
  const auto find = [this, grid](int index) { return this->GetInputArrayToProcess(index, grid); };
  return palpate::firstFault([&] { return palpate::checkFactorRequest(request.factor); },
    [&] { return palpate::findCellArray(this, grid, 0, find, request.factor.young); },
    [&] { return palpate::findCellArray(this, grid, 1, find, request.factor.poisson); });
}

/// Solves those parts of Kept and Coarser that the tool needs and that are missing.
std::string vtkElasticContactResponse::Solve(
  vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser, bool& ended)
{
  palpate::SolveRequest request;
  std::string fault = this->FindMaterials(grid, request);
  vtkDataArray* thickness = nullptr;
  if (fault.empty() && this->AutomaticTerms)
  {
    const auto find = [this, grid](int index) { return this->GetInputArrayToProcess(index, grid); };
    fault = palpate::findPointArray(this, grid, 2, find, thickness);
  }
  this->ThicknessName = thickness ? thickness->GetName() : "";
  palpate::SolveRequest ofCoarser;
  if (fault.empty() && coarser)
  {
    fault = palpate::prefixed("Coarser: ", this->FindMaterials(coarser, ofCoarser));
  }
  if (!fault.empty())
  {
    return fault;
  }
  if (!coarser)
  {
    this->Coarser.reset();
  }
  const double solved = coarser ? BodyShare : SolvedShare;
  palpate::SolveCost cost;
  fault = this->Kept->solve(grid, request, palpate::FilterStage{ this, 0.0, solved }, cost);
  if (fault.empty() && !cost.ended && coarser)
  {
    this->Coarser =
      this->Coarser ? std::move(this->Coarser) : std::make_unique<palpate::CoarserBody>();
    fault = this->Coarser->compare(
      coarser, ofCoarser, *this->Kept, palpate::FilterStage{ this, solved, SolvedShare }, cost);
  }
  this->MemoryEstimate = cost.memory;
  this->NumberOfSolutions = cost.solutions;
  ended = cost.ended;
  return fault;
}

std::string vtkElasticContactResponse::Respond(const palpate::LawRequest& request,
  vtkUnstructuredGrid* grid, vtkPolyData* finer, vtkPolyData* output)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  palpate::copyWithOwnFields(finer ? finer : this->Kept->surface(grid).Get(), surface);
  palpate::removeResponse(surface, this->ResponseName);
  const vtkIdType count = surface->GetNumberOfPoints();
  palpate::ResponseStorage storage(
    this->ResponseName, count, this->NumberOfSamples, request.terms.keepsError());
  palpate::MadeResponse made;
  const palpate::FilterStage stage{ this, SolvedShare, RespondedShare };
  std::unique_ptr<palpate::StrainCorrection> strain;
  std::string fault = this->Kept->findStrain(
    this->Tool, request.terms.strain, this->MaximumDeflection, stage, strain);
  if (!fault.empty() || palpate::isAborted(this))
  {
    return fault;
  }
  vtkNew<vtkFloatArray> surfaceError;
  palpate::ShapedTerms terms{ this->MaximumDeflection, this->ErrorTolerance, strain.get(),
    this->Coarser ? this->Coarser->difference() : nullptr };
  if (finer)
  {
    surfaceError->SetName(
      palpate::arrayName(this->ResponseName, palpate::ResponseArray::SurfaceError).c_str());
    surfaceError->SetNumberOfValues(count);
    terms.surfaceError = surfaceError->GetPointer(0);
  }
  fault = finer ? this->Kept->respondOn(surface, grid, this->Tool, terms, stage, storage, made)
                : this->Kept->respond(surface, this->Tool, terms, stage, storage, made);
  if (!fault.empty())
  {
    return fault;
  }
  if (!made.complete)
  {
    return {}; // aborted
  }
  if (made.without > 0)
  {
    vtkWarningMacro(<< made.without << " of " << count << " points have no response: see array '"
                    << this->ResponseName << "Status'.");
  }
  if (finer)
  {
    this->WarnOfSurface(surfaceError);
    surface->GetPointData()->AddArray(surfaceError);
  }
  const std::string choiceFault =
    this->AutomaticTerms ? this->KeepSimplerLaw(surface, storage) : std::string();
  if (!choiceFault.empty())
  {
    return choiceFault;
  }
  if (this->StoreMotion)
  {
    const palpate::FilterStage last{ this, RespondedShare, 1.0 };
    if (finer)
    {
      this->Kept->attachMotionTo(surface, storage.Normal, grid, last);
    }
    else
    {
      this->Kept->attachMotionTo(surface, last);
    }
    if (palpate::isAborted(this))
    {
      return {};
    }
  }
  const palpate::TermBody response{ request, *this->Tool->GetKernel(), nullptr };
  const palpate::ResponseModel beyond = palpate::termsInWords(response);
  palpate::copyWithOwnFields(surface, output);
  storage.attach(output);
  palpate::describeResponse(output, this->ResponseName,
    { made.exponent, this->NumberOfSamples, response.tool.specification(),
      palpate::joined(
        "finite elements of true shape, ", grid->GetNumberOfCells(), " cells", beyond.text),
      palpate::TrueShapePart | beyond.parts });
  if (this->AutomaticTerms)
  {
    palpate::addText(output, this->ResponseName, palpate::ResponseArray::Terms, this->TermReason);
  }
  fault = palpate::makeTerms(response, output);
  if (!fault.empty())
  {
    output->Initialize();
    return fault;
  }
  this->UpdateProgress(1.0);
  return {};
}

void vtkElasticContactResponse::WarnOfSurface(vtkFloatArray* error)
{
  const float* values = error->GetPointer(0);
  const vtkIdType count = error->GetNumberOfValues();
  const auto open = std::count_if(values, values + count,
    [this](float value) { return static_cast<double>(value) > this->ErrorTolerance; });
  if (this->ErrorTolerance > 0.0 && 10 * open > count)
  {
    vtkWarningMacro(
      << "The shape of the surface between its points may change the force by more than "
      << 100.0 * this->ErrorTolerance << " % at " << open << " of " << count
      << " points: see array '" << error->GetName() << "'.");
  }
}

std::string vtkElasticContactResponse::KeepSimplerLaw(
  vtkPolyData* surface, palpate::ResponseStorage& storage)
{
  const palpate::SimplerLaw law{ this->Tool, this->MaximumDeflection, this->LayerThickness,
    this->ThicknessName, this->TermTolerance };
  vtkNew<vtkFloatArray> change;
  change->SetName(
    palpate::arrayName(this->ResponseName, palpate::ResponseArray::ShapeChange).c_str());
  const std::string fault = palpate::keepSimplerLaw(
    this->Kept->green().body(), surface, law, storage, change, this->TermReason);
  surface->GetPointData()->AddArray(change);
  return fault;
}

void vtkElasticContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StoreMotion: " << this->StoreMotion << "\n";
  os << indent << "LargestContactRadius: " << this->LargestContactRadius << " mm\n";
  os << indent << "SourceSpacing: " << this->SourceSpacing << " mm\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << " MiB\n";
  os << indent << "NumberOfSolutions: " << this->NumberOfSolutions << "\n";
}
