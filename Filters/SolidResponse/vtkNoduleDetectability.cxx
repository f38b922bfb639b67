// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoduleDetectability.h"

#include "Laws/ResponseChange.h"
#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Tools/ToolSpecification.h"
#include "Solids/Curves/ShapedResponse.h"
#include "SolidResponse/Bodies/SolvedBody.h"
#include "Response/BodyConversion.h"
#include "Response/BodyLaws.h"
#include "Response/FilterThreads.h"
#include "vtkContactTool.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double WithShare = 0.45; // progress when the body with nodules has been solved
constexpr double BothShare = 0.9;

/// The arrays of the changes of all tools.
struct ChangeArrays
{
  vtkNew<vtkFloatArray> Force;
  vtkNew<vtkFloatArray> Stiffness;
  vtkNew<vtkFloatArray> Depth;
  vtkNew<vtkUnsignedCharArray> Felt;
  vtkNew<vtkIntArray> Strongest;

  ChangeArrays(vtkIdType points, const std::vector<vtkSmartPointer<vtkContactTool>>& tools)
  {
    this->Force->SetName("ForceChange");
    this->Stiffness->SetName("StiffnessChange");
    this->Depth->SetName("ChangeDepth");
    this->Felt->SetName("Felt");
    this->Strongest->SetName("StrongestTool");
    const int count = static_cast<int>(tools.size());
    for (vtkDataArray* array : this->ofTools())
    {
      array->SetNumberOfComponents(count);
      for (int k = 0; k < count && count > 1; ++k)
      {
        const std::string name = tools[static_cast<std::size_t>(k)]->GetKernel()->specification();
        array->SetComponentName(k, name.c_str());
      }
      array->SetNumberOfTuples(points);
    }
    this->Strongest->SetNumberOfTuples(points);
    this->Strongest->Fill(-1);
  }

  std::array<vtkDataArray*, 4> ofTools()
  {
    return { this->Force, this->Stiffness, this->Depth, this->Felt };
  }

  void set(vtkIdType point, int tool, const palpate::ResponseChange& change, double threshold)
  {
    this->Force->SetComponent(point, tool, change.force);
    this->Stiffness->SetComponent(point, tool, change.stiffness);
    this->Depth->SetComponent(point, tool, change.depth);
    this->Felt->SetComponent(point, tool, std::abs(change.force) >= threshold ? 1.0 : 0.0);
    const int before = this->Strongest->GetValue(point);
    const bool isFirst = before < 0 && std::isfinite(change.force);
    if (isFirst ||
      (before >= 0 && std::abs(change.force) > std::abs(this->Force->GetComponent(point, before))))
    {
      this->Strongest->SetValue(point, tool);
    }
  }

  void attach(vtkPolyData* output)
  {
    for (vtkDataArray* array : this->ofTools())
    {
      output->GetPointData()->AddArray(array);
    }
    output->GetPointData()->AddArray(this->Strongest);
  }
};
} // namespace

vtkStandardNewMacro(vtkNoduleDetectability);

vtkNoduleDetectability::vtkNoduleDetectability()
  : With(std::make_unique<palpate::SolvedBody>())
  , Without(std::make_unique<palpate::SolvedBody>())
{
  const std::array<const char*, 4> names = { "YoungsModulus", "PoissonRatio",
    "YoungsModulusWithout", "PoissonRatioWithout" };
  for (int i = 0; i < 4; ++i)
  {
    this->SetInputArrayToProcess(
      i, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, names[static_cast<std::size_t>(i)]);
  }
}

vtkNoduleDetectability::~vtkNoduleDetectability() = default;

void vtkNoduleDetectability::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkNoduleDetectability::GetTool()
{
  return this->Tool;
}

void vtkNoduleDetectability::AddMoreTool(const std::string& specification)
{
  this->MoreTools.push_back(specification);
  this->Modified();
}

void vtkNoduleDetectability::RemoveAllMoreTools()
{
  if (!this->MoreTools.empty())
  {
    this->MoreTools.clear();
    this->Modified();
  }
}

vtkMTimeType vtkNoduleDetectability::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkNoduleDetectability::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkNoduleDetectability::RequestData(
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
  const std::string fault = palpate::firstFault([this] { return this->FindTools(); },
    [this] { return this->CheckTools(); }, [&] { return this->Solve(grid, isEnded); },
    [&]
    { return isEnded ? std::string() : this->Compare(grid, vtkPolyData::GetData(outputVector)); });
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

std::string vtkNoduleDetectability::FindTools()
{
  this->Tools = { this->Tool };
  for (const std::string& specification : this->MoreTools)
  {
    palpate::ToolSpecification ignored;
    std::string error;
    if (!palpate::parseTool(specification, ignored, error))
    {
      return "More Tools: " + error;
    }
    this->Tools.push_back(vtkSmartPointer<vtkContactTool>::New());
    this->Tools.back()->SetSpecification(specification);
  }
  return {};
}

std::string vtkNoduleDetectability::CheckTools()
{
  for (vtkContactTool* tool : this->Tools)
  {
    palpate::LawRequest request;
    request.tool = tool;
    request.responseName = this->ResponseName;
    request.deflection = this->MaximumDeflection;
    request.samples = this->NumberOfSamples;
    request.terms.errorTolerance = this->ErrorTolerance;
    const std::string fault = palpate::checkShapedRequest(request);
    if (!fault.empty())
    {
      return fault;
    }
  }
  if (!(this->Threshold > 0.0 && std::isfinite(this->Threshold)))
  {
    return palpate::joined(
      "Smallest Felt Change (Threshold) must be positive and finite, but is ", this->Threshold);
  }
  return palpate::firstFault([this]
    { return palpate::checkLength("Press Depth", this->PressDepth); },
    [this] { return palpate::checkLength("Largest Contact Radius", this->LargestContactRadius); },
    [this] {
      return palpate::checkLength("Spacing Of Solved Points (SourceSpacing)", this->SourceSpacing);
    },
    [this]
    {
      return palpate::checkLength("Spacing Of Solved Points Without Nodules (SourceSpacingWithout)",
        this->SourceSpacingWithout);
    });
}

std::string vtkNoduleDetectability::Solve(vtkUnstructuredGrid* grid, bool& ended)
{
  palpate::SolveRequest request;
  request.factor.solver = this->Solver;
  request.factor.memoryLimit = this->MemoryLimit;
  request.radius = this->LargestContactRadius;
  for (vtkContactTool* tool : this->Tools)
  {
    request.radius = std::max(request.radius, palpate::neededRadius(tool, this->MaximumDeflection));
  }
  return palpate::firstFault([&] { return this->SolveOne(grid, true, request, ended); },
    [&] { return ended ? std::string() : this->SolveOne(grid, false, request, ended); });
}

std::string vtkNoduleDetectability::SolveOne(
  vtkUnstructuredGrid* grid, bool with, palpate::SolveRequest& request, bool& ended)
{
  const auto find = [this, grid](int index) { return this->GetInputArrayToProcess(index, grid); };
  const int first = with ? 0 : 2;
  palpate::FactorRequest& factor = request.factor;
  std::string fault = palpate::firstFault([&] { return palpate::checkFactorRequest(factor); },
    [&] { return palpate::findCellArray(this, grid, first, find, factor.young); },
    [&] { return palpate::findCellArray(this, grid, first + 1, find, factor.poisson); });
  if (!fault.empty())
  {
    return fault;
  }
  if (!factor.young || !factor.poisson)
  {
    return palpate::joined("Array to process ", factor.young ? first + 1 : first,
      factor.young ? " (Poisson's Ratio" : " (Young's Modulus", " of the body ",
      with ? "with" : "without", " nodules) is required, but is not set");
  }
  request.spacing =
    !with && this->SourceSpacingWithout > 0.0 ? this->SourceSpacingWithout : this->SourceSpacing;
  palpate::SolveCost cost;
  const palpate::FilterStage stage{ this, with ? 0.0 : WithShare, with ? WithShare : BothShare };
  fault = (with ? this->With : this->Without)->solve(grid, request, stage, cost);
  this->MemoryEstimate += cost.memory;
  this->NumberOfSolutions += cost.solutions;
  ended = cost.ended;
  return fault;
}

std::string vtkNoduleDetectability::Compare(vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPolyData> surface = this->With->surface(grid);
  const vtkIdType points = surface->GetNumberOfPoints();
  vtkNew<vtkPolyData> made;
  made->ShallowCopy(surface);
  ChangeArrays changes(points, this->Tools);
  const double deepest = this->PressDepth > 0.0
    ? std::min(this->PressDepth, this->MaximumDeflection)
    : this->MaximumDeflection;
  vtkIdType lost = 0;
  const double step = (1.0 - BothShare) / (2.0 * static_cast<double>(this->Tools.size()));
  double from = BothShare;
  for (std::size_t i = 0; i < this->Tools.size(); ++i)
  {
    vtkContactTool* tool = this->Tools[i];
    const std::string name = this->ResponseName + (i > 0 ? std::to_string(i + 1) : "");
    palpate::ResponseStorage with(name, points, this->NumberOfSamples, this->ErrorTolerance > 0.0);
    palpate::ResponseStorage without(
      name + "Without", points, this->NumberOfSamples, this->ErrorTolerance > 0.0);
    for (const bool isWith : { true, false })
    {
      palpate::MadeResponse response;
      palpate::ResponseStorage& storage = isWith ? with : without;
      const std::string fault =
        (isWith ? this->With : this->Without)
          ->respond(surface, tool, { this->MaximumDeflection, this->ErrorTolerance },
            palpate::FilterStage{ this, from, from + step }, storage, response);
      from += step;
      if (!fault.empty() || !response.complete)
      {
        return fault; // an error message, or "" after an abort
      }
      lost = std::max(lost, static_cast<vtkIdType>(response.without));
      if (isWith || this->StoreWithout)
      {
        storage.attach(made);
        palpate::describeResponse(made, isWith ? name : name + "Without",
          { response.exponent, this->NumberOfSamples, tool->GetKernel()->specification(),
            palpate::joined("finite elements of true shape, ", grid->GetNumberOfCells(), " cells",
              isWith ? "" : ", without nodules"),
            palpate::TrueShapePart });
      }
    }
    const palpate::ResponseSpans changed = with.spans();
    const palpate::ResponseSpans usual = without.spans();
    for (vtkIdType p = 0; p < points; ++p)
    {
      changes.set(p, static_cast<int>(i),
        palpate::largestChange(
          changed, usual, static_cast<std::size_t>(p), deepest, this->WithinValidity),
        this->Threshold);
    }
  }
  if (lost > 0)
  {
    vtkWarningMacro(<< lost << " of " << points << " points have no response: see array '"
                    << this->ResponseName << "Status'.");
  }
  output->ShallowCopy(made);
  changes.attach(output);
  this->UpdateProgress(1.0);
  return {};
}

void vtkNoduleDetectability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  for (const std::string& tool : this->MoreTools)
  {
    os << indent << "MoreTool: " << tool << "\n";
  }
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "PressDepth: " << this->PressDepth << " mm\n";
  os << indent << "WithinValidity: " << this->WithinValidity << "\n";
  os << indent << "StoreWithout: " << this->StoreWithout << "\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "LargestContactRadius: " << this->LargestContactRadius << " mm\n";
  os << indent << "SourceSpacing: " << this->SourceSpacing << " mm\n";
  os << indent << "SourceSpacingWithout: " << this->SourceSpacingWithout << " mm\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << " MiB\n";
  os << indent << "NumberOfSolutions: " << this->NumberOfSolutions << "\n";
}
