// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElasticContactResponse.h"

#include "Laws/ShapedResponse.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "Mechanics/TrueShape/RegularGreen.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/Bodies/FactorisedBody.h"
#include "Response/Bodies/VolumeConversion.h"
#include "Response/BodyConversion.h"
#include "Response/BodyLaws.h"
#include "Response/Curves/PointNormals.h"
#include "Response/Curves/ResponseStorage.h"
#include "Response/FilterStage.h"
#include "Response/FilterThreads.h"
#include "vtkContactTool.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{
constexpr double FactorisedShare = 0.15; // of the work, as progress tells it
constexpr double SolvedShare = 0.9;
constexpr double WiderThanHalfSpace = 1.42; // on a layer that gives way sideways √2
} // namespace

/// A body and its H, and what they were made of.
struct vtkElasticContactResponse::Solved
{
  palpate::ElasticBody Body;
  palpate::RegularGreen Green{ Body };
  double Spacing = 0.0; ///< of sources, mm
  double Radius = 0.0;  ///< mm; 0: nothing solved yet
  vtkSmartPointer<vtkUnstructuredGrid>
    Grid; ///< its arrays, so that none can be freed and made anew
  vtkMTimeType GridTime = 0;
  vtkDataArray* Young = nullptr;
  vtkDataArray* Poisson = nullptr;
  palpate::ElasticMaterial Material;
  int Solver = 0;
};

vtkStandardNewMacro(vtkElasticContactResponse);

vtkElasticContactResponse::vtkElasticContactResponse() = default;
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

int vtkElasticContactResponse::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkElasticContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(inputVector[0]);
  this->MemoryEstimate = 0.0;
  this->NumberOfSolutions = 0;
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const palpate::FilterThreads threads;
  bool isEnded = false;
  std::string fault = this->CheckProperties();
  fault = fault.empty() ? this->Solve(grid, isEnded) : fault;
  fault =
    fault.empty() && !isEnded ? this->Respond(grid, vtkPolyData::GetData(outputVector)) : fault;
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
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
  std::string fault = palpate::checkRequest(request);
  if (fault.empty())
  {
    fault = this->Tool->GetKernel()->checkDepth(this->MaximumDeflection);
    fault = fault.empty() ? fault : "MaximumDeflection: " + fault;
  }
  const double radius = this->LargestContactRadius;
  if (fault.empty() && !(radius >= 0.0 && std::isfinite(radius)))
  {
    fault = palpate::joined("LargestContactRadius must be 0 or positive (mm), but is ", radius);
  }
  if (fault.empty() && !(this->SourceSpacing >= 0.0 && std::isfinite(this->SourceSpacing)))
  {
    fault =
      palpate::joined("SourceSpacing must be 0 or positive (mm), but is ", this->SourceSpacing);
  }
  return fault;
}

/// Sees to it that what the tool needs is in Kept.
std::string vtkElasticContactResponse::Solve(vtkUnstructuredGrid* grid, bool& ended)
{
  palpate::FactorRequest request;
  request.material = { this->YoungsModulus, this->PoissonRatio };
  request.solver = this->Solver;
  request.memoryLimit = this->MemoryLimit;
  std::string fault = palpate::checkFactorRequest(request);
  const auto find = [this, grid](int index) { return this->GetInputArrayToProcess(index, grid); };
  fault = fault.empty() ? palpate::findCellArray(this, grid, 0, find, request.young) : fault;
  fault = fault.empty() ? palpate::findCellArray(this, grid, 1, find, request.poisson) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  const double own =
    WiderThanHalfSpace * this->Tool->GetKernel()->contactRadius(this->MaximumDeflection);
  const double radius = std::max(own, this->LargestContactRadius);
  const Solved* kept = this->Kept.get();
  const bool isSame = kept && kept->GridTime == grid->GetMTime() && kept->Young == request.young &&
    kept->Poisson == request.poisson && kept->Solver == this->Solver &&
    kept->Material.youngsModulus == this->YoungsModulus &&
    kept->Material.poissonRatio == this->PoissonRatio;
  if (isSame && kept->Radius >= radius && kept->Spacing == this->SourceSpacing)
  {
    return {};
  }
  if (!isSame)
  {
    this->Kept = std::make_unique<Solved>(); // the factor before is given back first
    fault =
      palpate::factoriseBody(grid, request, palpate::FilterStage{ this, 0.0, FactorisedShare },
        this->Kept->Body, this->MemoryEstimate, ended);
    if (!fault.empty() || ended)
    {
      this->Kept.reset();
      return fault;
    }
    this->Kept->Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    this->Kept->Grid->ShallowCopy(grid);
    this->Kept->GridTime = grid->GetMTime();
    this->Kept->Young = request.young;
    this->Kept->Poisson = request.poisson;
    this->Kept->Material = request.material;
    this->Kept->Solver = this->Solver;
  }
  Solved& solved = *this->Kept;
  std::vector<std::int32_t> points(static_cast<std::size_t>(solved.Body.surface().pointTotal()));
  std::iota(points.begin(), points.end(), 0);
  const double bytes = solved.Green.memoryForecast(points, radius, this->SourceSpacing);
  this->MemoryEstimate += bytes / palpate::Mebibyte;
  if (bytes > palpate::allowedMemory(this->MemoryLimit))
  {
    return palpate::joined("The solutions at ", points.size(), " points for contacts of ", radius,
      " mm need about ", bytes / palpate::Mebibyte, " MiB, more than ",
      palpate::allowedMemory(this->MemoryLimit) / palpate::Mebibyte,
      " MiB: give a smaller MaximumDeflection, a smaller tool or a coarser mesh");
  }
  solved.Radius = 0.0;
  fault = solved.Green.solve(points, radius,
    palpate::FilterStage{ this, FactorisedShare, SolvedShare }, this->SourceSpacing);
  ended = palpate::isAborted(this);
  if (ended)
  {
    return {};
  }
  if (fault.empty())
  {
    solved.Radius = radius;
    solved.Spacing = this->SourceSpacing;
    this->NumberOfSolutions = static_cast<vtkIdType>(solved.Green.sources());
  }
  return fault.empty() ? fault : "Wrong input: " + fault;
}

std::string vtkElasticContactResponse::Respond(vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  const Solved& solved = *this->Kept;
  vtkNew<vtkPolyData> surface;
  palpate::convertSurface(solved.Body.surface(), grid, surface);
  const vtkIdType count = surface->GetNumberOfPoints();
  const bool keepsError = this->StoreError && this->ErrorTolerance > 0.0;
  palpate::ResponseStorage storage(this->ResponseName, count, this->NumberOfSamples, keepsError);
  std::string fault = palpate::fillPointNormals(surface, storage.Normal, storage.Status);
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  const palpate::AxisymmetricTool& tool = *this->Tool->GetKernel();
  const palpate::MadeResponse made =
    palpate::shapedResponse(tool, solved.Green, { this->MaximumDeflection, this->ErrorTolerance },
      storage.spans(), palpate::FilterStage{ this, SolvedShare, 1.0 });
  if (!made.complete)
  {
    return {}; // aborted
  }
  if (made.without > 0)
  {
    vtkWarningMacro(<< made.without << " of " << count << " points have no response: see array '"
                    << this->ResponseName << "Status'.");
  }
  output->ShallowCopy(surface);
  storage.attach(output);
  palpate::describeResponse(output, this->ResponseName,
    { made.exponent, this->NumberOfSamples, tool.specification(),
      palpate::joined("finite elements of true shape, ", grid->GetNumberOfCells(), " cells"),
      palpate::TrueShapePart });
  this->UpdateProgress(1.0);
  return {};
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
  os << indent << "LargestContactRadius: " << this->LargestContactRadius << " mm\n";
  os << indent << "SourceSpacing: " << this->SourceSpacing << " mm\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << " MiB\n";
  os << indent << "NumberOfSolutions: " << this->NumberOfSolutions << "\n";
}
