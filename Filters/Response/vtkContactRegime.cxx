// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactRegime.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/BodyConversion.h"
#include "Laws/BodyMaterial.h"
#include "Response/Curves/MaterialArrays.h"
#include "Response/Pieces/OwnPiece.h"
#include "Response/Pieces/Ranks.h"
#include "Laws/RegimeLaw.h"
#include "Contact/ResponseField.h"
#include "Response/ResponseTool.h"
#include "vtkContactTool.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
constexpr double ResponseAgreement = 0.02;

struct PointArrays
{
  vtkNew<vtkFloatArray> index;
  vtkNew<vtkFloatArray> sensitivity;
  vtkNew<vtkUnsignedCharArray> verdict;

  explicit PointArrays(vtkIdType points)
  {
    const auto allocate = [points](vtkDataArray* array, const char* name)
    {
      array->SetName(name);
      array->SetNumberOfTuples(points);
    };
    allocate(this->index, "RegimeIndex");
    allocate(this->sensitivity, "ToolSensitivity");
    allocate(this->verdict, "RegimeVerdict");
  }
};

/// Where the stored response is not of the material that gives `forces` at `depths`, or "".
std::string compare(const palpate::ResponseArrays& arrays, const std::vector<double>& depths,
  const std::vector<double>& forces)
{
  const palpate::ResponseField stored(arrays);
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    const double range = arrays.range[i];
    if (!stored.isValid(point) || depths[i] < 0.01 * range || depths[i] > range)
    {
      continue;
    }
    const double force = stored.evaluate(point, depths[i]).force;
    if (std::abs(force - forces[i]) > ResponseAgreement * forces[i])
    {
      return "point " + std::to_string(i) + " at " + std::to_string(depths[i]) + " mm gives " +
        std::to_string(force) + " N, the material given here " + std::to_string(forces[i]) + " N";
    }
  }
  return {};
}
} // namespace

vtkStandardNewMacro(vtkContactRegime);

vtkContactRegime::vtkContactRegime()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkContactRegime::~vtkContactRegime() = default;

void vtkContactRegime::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkContactRegime::GetController()
{
  return this->Controller;
}

void vtkContactRegime::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkContactRegime::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkContactRegime::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

std::string vtkContactRegime::FindDepths(vtkPolyData* body, std::vector<double>& depths)
{
  std::ostringstream text;
  if (!(std::isfinite(this->Deflection) && this->Deflection >= 0.0))
  {
    text << "Deflection must be finite and not negative (mm, 0 for half of Range), but is "
         << this->Deflection;
    return text.str();
  }
  depths.assign(static_cast<std::size_t>(body->GetNumberOfPoints()), this->Deflection);
  if (this->Deflection > 0.0 || depths.empty())
  {
    return {};
  }
  vtkDataArray* range = body->GetPointData()->GetArray(
    palpate::arrayName(this->ResponseName, palpate::ResponseArray::Range).c_str());
  if (!range || range->GetNumberOfComponents() != 1 ||
    range->GetNumberOfTuples() != body->GetNumberOfPoints())
  {
    text << "Deflection is 0, which means half of the point array '" << this->ResponseName
         << "Range', but the input has none with a value per point: attach a response, or set "
            "Deflection";
    return text.str();
  }
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    depths[i] = 0.5 * range->GetTuple1(static_cast<vtkIdType>(i));
    if (!(depths[i] > 0.0 && std::isfinite(depths[i])))
    {
      text << "Array '" << this->ResponseName << "Range': value of point " << i
           << " must be positive and finite (mm), but is " << 2.0 * depths[i];
      return text.str();
    }
  }
  return {};
}

std::string vtkContactRegime::Compare(vtkPolyData* body, const palpate::AxisymmetricTool& tool,
  const std::vector<double>& depths, const std::vector<double>& forces)
{
  palpate::ResponseArrays stored;
  std::string noResponse;
  if (palpate::responseText(body, this->ResponseName, palpate::ResponseArray::Tool) !=
      tool.specification() ||
    !palpate::viewResponse(body, this->ResponseName, stored, noResponse))
  {
    return {};
  }
  const std::string disagreement = compare(stored, depths, forces);
  return disagreement.empty()
    ? disagreement
    : "Response '" + this->ResponseName + "' is of another material: " + disagreement;
}

int vtkContactRegime::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const palpate::Ranks ranks(this->Controller);
  const auto body = palpate::ownPiece(vtkPolyData::GetData(inputVector[0]), ranks);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const bool hasPiece = body->GetNumberOfPoints() > 0;
  if (!ranks.any(hasPiece))
  {
    return 1;
  }
  // Once all agree that nothing is wrong, a rank without a piece has nothing to do but to agree.
  std::string fault;
  vtkSmartPointer<vtkContactTool> tool;
  std::vector<double> depths;
  palpate::BodyMaterial material({ this->YoungsModulus, this->PoissonRatio, this->LayerThickness,
    static_cast<palpate::LayerBase>(this->LayerBase), this->ComplianceExcludesLayer });
  if (hasPiece)
  {
    tool = palpate::findTool(this->Tool, body, this->ResponseName, fault);
    fault = fault.empty() && !tool->GetKernel() ? "The Tool is invalid" : fault;
    fault = fault.empty() ? this->FindDepths(body, depths) : fault;
    const auto find = [this, &body](int index)
    { return this->GetInputArrayToProcess(index, body); };
    fault = fault.empty() ? palpate::readMaterial(this, body, find, material) : fault;
  }
  double deepest = depths.empty() ? 0.0 : *std::max_element(depths.begin(), depths.end());
  deepest = ranks.largest(deepest);
  if (hasPiece && fault.empty())
  {
    fault = tool->GetKernel()->checkDepth(deepest);
  }
  fault = ranks.firstFault(fault);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  palpate::agreeOnRange(ranks, hasPiece, material);
  if (!hasPiece)
  {
    ranks.firstFault({}); // of the comparison below
    return 1;
  }
  const palpate::AxisymmetricTool* kernel = tool->GetKernel();
  const palpate::RegimeLaw law(*kernel, material.range(), deepest);
  const palpate::ContactSpots spots = material.spots();
  const vtkIdType points = body->GetNumberOfPoints();
  std::vector<double> forces(depths.size());
  if (law.complete())
  {
    vtkSMPTools::For(0, points,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const auto k = static_cast<std::size_t>(i);
          forces[k] = law.force(spots.at(k), depths[k]);
        }
      });
    fault = this->Compare(body, *kernel, depths, forces);
  }
  else
  {
    fault = "Tool '" + kernel->specification() + "' cannot be scaled";
  }
  fault = ranks.firstFault(fault);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }

  PointArrays arrays(points);
  vtkSMPTools::For(0, points,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto k = static_cast<std::size_t>(i);
        const palpate::SpotRegime found = law.regime(spots.at(k), depths[k], forces[k]);
        arrays.index->SetValue(i, static_cast<float>(found.index));
        arrays.sensitivity->SetValue(i, static_cast<float>(found.sensitivity));
        arrays.verdict->SetValue(i, static_cast<unsigned char>(found.verdict));
      }
    });

  output->ShallowCopy(body);
  output->GetPointData()->AddArray(arrays.index);
  output->GetPointData()->AddArray(arrays.sensitivity);
  output->GetPointData()->AddArray(arrays.verdict);
  vtkNew<vtkDoubleArray> at;
  at->SetName("RegimeDeflection");
  at->InsertNextValue(deepest);
  output->GetFieldData()->AddArray(at);
  return 1;
}

void vtkContactRegime::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "Deflection: " << this->Deflection << " mm\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "LayerThickness: " << this->LayerThickness << " mm\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "ComplianceExcludesLayer: " << this->ComplianceExcludesLayer << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}
