// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElasticContactResponse.h"

#include "Contact/Edges/EdgeLaw.h"
#include "Solids/Curves/ShapedResponse.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "SolidResponse/Bodies/CoarserBody.h"
#include "SolidResponse/Bodies/SimplerLaw.h"
#include "SolidResponse/Bodies/SolvedBody.h"
#include "SolidResponse/Bodies/SourceSpacing.h"
#include "Response/BodyConversion.h"
#include "Response/BodyLaws.h"
#include "Response/Curves/TiltRequest.h"
#include "Response/Curves/AutomaticTerms.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/FilterThreads.h"
#include "Response/ReplacedCurves.h"
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
// Fractions of the work for the progress.
constexpr double SolvedShare = 0.9;
constexpr double BodyShare = 0.75; // used if a coarser body is solved, too
constexpr double RespondedShare = 0.95;
} // namespace

vtkStandardNewMacro(vtkElasticContactResponse);

vtkElasticContactResponse::vtkElasticContactResponse()
  : Kept(std::make_unique<palpate::SolvedBody>())
{
  this->SetNumberOfInputPorts(3);
}
vtkElasticContactResponse::~vtkElasticContactResponse() = default;

void vtkElasticContactResponse::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkElasticContactResponse::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkElasticContactResponse::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

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
  std::string fault = this->CheckProperties();
  std::unique_ptr<palpate::SoundBody> sound;
  if (fault.empty() && finer)
  {
    sound = std::make_unique<palpate::SoundBody>(finer);
    fault = this->CheckSurface(*sound);
  }
  fault = fault.empty() && coarser ? palpate::checkCoarser(grid, coarser) : fault;
  fault = fault.empty() ? this->Solve(grid, coarser, isEnded) : fault;
  fault = fault.empty() && !isEnded ? this->Respond(grid, sound ? sound->body() : nullptr, output)
                                    : fault;
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  if (sound)
  {
    sound->giveBack(output);
  }
  return 1;
}

std::string vtkElasticContactResponse::CheckProperties()
{
  palpate::LawRequest request;
  request.tool = this->Tool;
  request.responseName = this->ResponseName;
  request.deflection = this->MaximumDeflection;
  request.samples = this->NumberOfSamples;
  request.terms.errorTolerance = this->ErrorTolerance;
  std::string fault = palpate::checkShapedRequest(request);
  fault = fault.empty() ? palpate::checkLength("Layer Thickness", this->LayerThickness) : fault;
  if (fault.empty() && !(this->TermTolerance >= 0.0 && std::isfinite(this->TermTolerance)))
  {
    fault =
      palpate::joined("Largest Effect Left Out (TermTolerance) must be 0 or positive, but is ",
        this->TermTolerance);
  }
  palpate::PronySeries series;
  fault = fault.empty() ? this->Relaxations.fillSeries(series) : fault;
  fault = fault.empty()
    ? palpate::checkTilts({ *this->Tool->GetKernel(), this->MaximumTilt, this->MaximumDeflection })
    : fault;
  fault = fault.empty() ? palpate::checkLength("Largest Contact Radius", this->LargestContactRadius)
                        : fault;
  return fault.empty()
    ? palpate::checkLength("Spacing Of Solved Points (SourceSpacing)", this->SourceSpacing)
    : fault;
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

/// Fills the settings of a solution, with the arrays of this grid.
std::string vtkElasticContactResponse::FindMaterials(
  vtkUnstructuredGrid* grid, palpate::SolveRequest& request)
{
  request.factor.material = { this->YoungsModulus, this->PoissonRatio };
  request.factor.solver = this->Solver;
  request.factor.memoryLimit = this->MemoryLimit;
  request.radius = std::max(
    palpate::neededRadius(this->Tool, this->MaximumDeflection), this->LargestContactRadius);
  request.spacing = palpate::sourceSpacing(grid, this->SourceSpacing);
  std::string fault = palpate::checkFactorRequest(request.factor);
  const auto find = [this, grid](int index) { return this->GetInputArrayToProcess(index, grid); };
  fault = fault.empty() ? palpate::findCellArray(this, grid, 0, find, request.factor.young) : fault;
  return fault.empty() ? palpate::findCellArray(this, grid, 1, find, request.factor.poisson)
                       : fault;
}

/// Solves the parts of Kept and Coarser that the tool needs and that are missing.
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
    fault = this->FindMaterials(coarser, ofCoarser);
    fault = fault.empty() ? fault : "Coarser: " + fault;
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

std::string vtkElasticContactResponse::Respond(
  vtkUnstructuredGrid* grid, vtkPolyData* finer, vtkPolyData* output)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->ShallowCopy(finer ? finer : this->Kept->surface(grid).Get());
  const vtkIdType count = surface->GetNumberOfPoints();
  const bool keepsError = this->StoreError && this->ErrorTolerance > 0.0;
  palpate::ResponseStorage storage(this->ResponseName, count, this->NumberOfSamples, keepsError);
  palpate::MadeResponse made;
  const palpate::FilterStage stage{ this, SolvedShare, RespondedShare };
  std::unique_ptr<palpate::StrainCorrection> strain;
  const palpate::StrainLaw law{ static_cast<palpate::StrainModel>(this->StrainModel),
    this->StrainModel == Ogden ? this->OgdenExponent : this->DemirayExponent };
  std::string fault = this->StrainModel == SmallStrain
    ? std::string()
    : this->Kept->findStrain(this->Tool, law, this->MaximumDeflection, stage, strain);
  if (!fault.empty() || palpate::isAborted(this))
  {
    return fault;
  }
  vtkNew<vtkFloatArray> surfaceError;
  palpate::ShapedTerms terms{ this->MaximumDeflection, this->ErrorTolerance, strain.get(),
    this->Coarser ? this->Coarser->difference() : nullptr };
  if (finer)
  {
    surfaceError->SetName((this->ResponseName + "SurfaceError").c_str());
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
  palpate::RelaxationRequest relaxation;
  this->Relaxations.fillSeries(relaxation.series); // CheckProperties found no fault
  palpate::copyWithOwnFields(surface, output);
  storage.attach(output);
  palpate::attachRelaxation(relaxation, {}, this->ResponseName, output);
  palpate::describeResponse(output, this->ResponseName,
    { made.exponent, this->NumberOfSamples, this->Tool->GetKernel()->specification(),
      palpate::joined("finite elements of true shape, ", grid->GetNumberOfCells(), " cells",
        strain ? ", " + palpate::describe(law) : std::string()) +
        palpate::relaxationInWords(relaxation, {}),
      palpate::TrueShapePart | (strain ? palpate::FiniteStrainPart : 0) });
  if (this->EdgeCorrection)
  {
    palpate::EdgeTerms edges =
      palpate::edgeTermsOf(*this->Tool->GetKernel(), this->MaximumDeflection, 0.5);
    edges.isInCurves = true;
    palpate::describeEdges(output, this->ResponseName, edges);
  }
  const std::string untilted =
    palpate::attachTilts({ *this->Tool->GetKernel(), this->MaximumTilt, this->MaximumDeflection },
      nullptr, 0.0, this->ResponseName, output);
  if (!untilted.empty())
  {
    output->Initialize();
    return untilted;
  }
  if (this->AutomaticTerms)
  {
    palpate::addText(output, palpate::termsName(this->ResponseName), this->TermReason);
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
  change->SetName((this->ResponseName + "ShapeChange").c_str());
  const std::string fault = palpate::keepSimplerLaw(
    this->Kept->green().body(), surface, law, storage, change, this->TermReason);
  surface->GetPointData()->AddArray(change);
  return fault;
}

void vtkElasticContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "StoreError: " << this->StoreError << "\n";
  os << indent << "StoreMotion: " << this->StoreMotion << "\n";
  os << indent << "LargestContactRadius: " << this->LargestContactRadius << " mm\n";
  os << indent << "SourceSpacing: " << this->SourceSpacing << " mm\n";
  os << indent << "MaximumTilt: " << this->MaximumTilt << " degrees\n";
  os << indent << "StrainModel: " << this->StrainModel << "\n";
  os << indent << "OgdenExponent: " << this->OgdenExponent << "\n";
  os << indent << "DemirayExponent: " << this->DemirayExponent << "\n";
  os << indent << "EdgeCorrection: " << this->EdgeCorrection << "\n";
  os << indent << "Relaxations: " << this->Relaxations.count() << "\n";
  os << indent << "AutomaticTerms: " << this->AutomaticTerms << "\n";
  os << indent << "TermTolerance: " << this->TermTolerance << "\n";
  os << indent << "LayerThickness: " << this->LayerThickness << " mm\n";
  os << indent << "TermReason: " << this->TermReason << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << " MiB\n";
  os << indent << "NumberOfSolutions: " << this->NumberOfSolutions << "\n";
}
