// SPDX-License-Identifier: BSD-3-Clause
#include "Response/BodyRegime.h"

#include "Mechanics/Checked.h"
#include "Response/Bodies/BodyContent.h"
#include "Response/Bodies/BodyYield.h"
#include "Response/Bodies/SoundBody.h"
#include "Laws/RegimeLaw.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/BodyShape.h"
#include "Response/FilterThreads.h"
#include "Response/Pieces/LoadedPieces.h"
#include "Response/ResponseTool.h"
#include "vtkContactTool.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace palpate
{
namespace
{
struct RegimeStorage
{
  vtkNew<vtkFloatArray> index;
  vtkNew<vtkFloatArray> sensitivity;
  vtkNew<vtkUnsignedCharArray> verdict;

  explicit RegimeStorage(vtkIdType points)
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

/// Returns the arrays of a request. If no compliance is given, adds the compliance of the body's
/// response.
MaterialArrays arraysOf(vtkPolyData* body, const LawRequest& request)
{
  MaterialArrays arrays = request.arrays;
  MaterialArray& compliance = arrays[ComplianceArrayIndex];
  vtkDataArray* found = body->GetPointData()->GetArray(FoundCompliance);
  const int parts = responseModel(body, request.responseName).parts;
  if (compliance.name.empty() && found && (parts & GlobalCompliancePart) != 0)
  {
    compliance = { FoundCompliance, found };
  }
  return arrays;
}

/// Computes the depths from the deflection or from the Range of the body. Returns "" or an error
/// message.
std::string findDepths(vtkPolyData* body, const LawRequest& request, std::vector<double>& depths)
{
  if (!(std::isfinite(request.deflection) && request.deflection >= 0.0))
  {
    return joined("Deflection must be finite and not negative (mm, 0 for half of Range), but is ",
      request.deflection);
  }
  depths.assign(static_cast<std::size_t>(body->GetNumberOfPoints()), request.deflection);
  if (request.deflection > 0.0 || depths.empty())
  {
    return {};
  }
  vtkDataArray* range =
    body->GetPointData()->GetArray(arrayName(request.responseName, ResponseArray::Range).c_str());
  if (!range || range->GetNumberOfComponents() != 1 ||
    range->GetNumberOfTuples() != body->GetNumberOfPoints())
  {
    return joined("Deflection is 0, which means half of the point array '", request.responseName,
      "Range', but the input has none with a value per point: attach a response, or set "
      "Deflection");
  }
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    depths[i] = 0.5 * range->GetTuple1(static_cast<vtkIdType>(i));
    if (!(depths[i] > 0.0 && std::isfinite(depths[i])))
    {
      return joined("Array '", request.responseName, "Range': value of point ", i,
        " must be positive and finite (mm), but is ", 2.0 * depths[i]);
    }
  }
  return {};
}
} // namespace

std::string attachRegime(
  const Ranks& ranks, vtkPolyData* input, const LawRequest& request, vtkPolyData* output)
{
  const bool hasPiece = input->GetNumberOfPoints() > 0;
  if (!ranks.any(hasPiece))
  {
    return {};
  }
  std::string fault = missingPieces(ranks);
  if (!fault.empty())
  {
    return fault;
  }
  std::shared_ptr<const BodyContent> content;
  const SoundBody sound(input, extentOn(ranks), &content);
  fault = ranks.firstFault(sound.fault());
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  vtkPolyData* body = sound.body();
  // No rank can fail after this line. A rank without a piece only takes part in the collective
  // calls.
  const std::string& name = request.responseName;
  vtkSmartPointer<vtkContactTool> tool;
  std::vector<double> depths;
  BodyMaterial material(request.material);
  if (hasPiece)
  {
    tool = findTool(request.tool, body, name, fault);
    fault = firstFault([&] { return fault; },
      [&] { return std::string(tool->GetKernel() ? "" : "The Tool is invalid"); },
      [&] { return findDepths(body, request, depths); },
      [&] { return readMaterial(body, arraysOf(body, request), material); });
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
    return fault;
  }
  agreeOnRange(ranks, hasPiece, material);
  RegimeStorage storage(body->GetNumberOfPoints());
  const int parts = hasPiece ? responseModel(body, name).parts : 0;
  std::shared_ptr<const BodyShape> shape;
  if (ranks.any((parts & CurvaturePart) != 0))
  {
    // The curvatures are the same as those used for the response. They are averaged over the widest
    // contact of the response.
    double radius = 0.0;
    auto* normals = vtkFloatArray::SafeDownCast(
      body->GetPointData()->GetArray(arrayName(name, ResponseArray::Normal).c_str()));
    if (vtkDataArray* range =
          body->GetPointData()->GetArray(arrayName(name, ResponseArray::Range).c_str());
        range && normals && tool)
    {
      radius = tool->GetKernel()->contactRadius(range->GetRange(0)[1]);
    }
    radius = ranks.largest(radius);
    if (radius > 0.0)
    {
      shape = findShape(content, BodySeam(ranks, body), normals ? normals->GetPointer(0) : nullptr,
        radius, { true, {}, 0.0, false });
    }
  }
  if (hasPiece)
  {
    ComparedResponse stored{ {}, name };
    if (shape && shape->curvature)
    {
      stored.curvature = [&shape](std::size_t i) { return shape->curvatureAt(i); };
    }
    if (vtkDataArray* errors =
          body->GetPointData()->GetArray(arrayName(name, ResponseArray::Error).c_str()))
    {
      stored.error = [errors](std::size_t i)
      {
        const double* row = errors->GetTuple(static_cast<vtkIdType>(i));
        return *std::max_element(row, row + errors->GetNumberOfComponents());
      };
    }
    std::string noResponse;
    // The regime assumes small strain. Therefore it is not compared with a response at finite
    // strain.
    const bool isStored = (parts & FiniteStrainPart) == 0 &&
      responseText(body, name, ResponseArray::Tool) == tool->GetKernel()->specification() &&
      viewResponse(body, name, stored.arrays, noResponse);
    const FilterThreads threads;
    fault = regime(*tool->GetKernel(), material, depths, deepest, isStored ? &stored : nullptr,
      { storage.index->GetPointer(0), storage.sensitivity->GetPointer(0),
        storage.verdict->GetPointer(0) });
  }
  fault = ranks.firstFault(fault);
  if (!fault.empty() || !hasPiece)
  {
    return fault;
  }
  copyWithOwnFields(body, output);
  output->GetPointData()->AddArray(storage.index);
  output->GetPointData()->AddArray(storage.sensitivity);
  output->GetPointData()->AddArray(storage.verdict);
  vtkNew<vtkDoubleArray> at;
  at->SetName("RegimeDeflection");
  at->InsertNextValue(deepest);
  output->GetFieldData()->AddArray(at);
  sound.giveBack(output);
  return {};
}
} // namespace palpate
