// SPDX-License-Identifier: BSD-3-Clause
#include "Response/BodyLaws.h"

#include "Contact/Reduction/ChoiceReason.h"
#include "Laws/RegimeLaw.h"
#include "Laws/ResponseFiller.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/AutomaticTerms.h"
#include "Response/Curves/BodyShape.h"
#include "Response/Curves/CurvatureBound.h"
#include "Response/Curves/PointNormals.h"
#include "Response/Curves/ResponseStorage.h"
#include "Response/FilterThreads.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/ReplacedCurves.h"
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
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace palpate
{
namespace
{
/// The correction by finite strain, null for none; or what is wrong.
std::string findStrain(const LawRequest& request, const StrainLaw& law,
  const BodyMaterial& material, const std::function<bool(double)>& goOn,
  std::unique_ptr<StrainCorrection>& strain)
{
  if (law.model == StrainModel::Linear)
  {
    return {};
  }
  return makeStrainCorrection(*request.tool->GetKernel(), law, material.range().strainBodies(),
    request.deflection, goOn, strain);
}

/// What is beyond small strain on a flat surface, in words and as a sum of ModelPart.
ResponseModel termsOf(const LawTerms& terms)
{
  ResponseModel model{ "", 0 };
  if (terms.curvature)
  {
    model.text += ", curved as the body is";
    model.parts |= CurvaturePart;
  }
  if (terms.strain.model != StrainModel::Linear)
  {
    model.text += ", " + describe(terms.strain);
    model.parts |= FiniteStrainPart;
  }
  return model;
}

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

/// What is wrong with the deflection, or with the Range of the body, or "".
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

/// The laws in place of the curves there were.
void replaceCurves(vtkPolyData* body, const std::string& name, const ResponseChoice& choice)
{
  removeCurves(body, name);
  const int columns = static_cast<int>(choice.basis.size()) / choice.laws;
  addFloats(body, name, ResponseArray::Basis, columns, choice.basis);
  addFloats(body, name, ResponseArray::Coefficient, choice.laws, choice.coefficient);
  if (choice.need == ResponseNeed::PointForce)
  {
    vtkNew<vtkDoubleArray> exponent;
    exponent->SetName(arrayName(name, ResponseArray::Exponent).c_str());
    exponent->InsertNextValue(choice.exponent);
    body->GetFieldData()->AddArray(exponent);
    const ResponseModel model = responseModel(body, name);
    describeModel(body, name, { model.text + "; as a spring per point", model.parts | SpringPart });
  }
}

/// Verdicts of the regime, and validities, where they are on the body; "" or what is wrong with
/// them.
std::string readEvidence(vtkPolyData* body, const std::string& name, ChoiceEvidence& evidence)
{
  vtkPointData* points = body->GetPointData();
  if (vtkAbstractArray* found = points->GetAbstractArray("RegimeVerdict"))
  {
    auto* verdict = vtkUnsignedCharArray::SafeDownCast(found);
    if (!verdict || verdict->GetNumberOfComponents() != 1)
    {
      return joined("Array 'RegimeVerdict' must be unsigned char with 1 component, but is ",
        found->GetDataTypeAsString(), " with ", found->GetNumberOfComponents());
    }
    evidence.verdict = verdict->GetPointer(0);
  }
  std::string error;
  if (points->HasArray(arrayName(name, ResponseArray::Validity).c_str()))
  {
    viewValidity(body, name, evidence.validity, evidence.limit, error);
  }
  return error;
}

/// The depth (mm) that regime and validity are looked at; 0 for half of Range. "" or what is wrong.
std::string chooseDepth(vtkPolyData* body, const ResponseArrays& arrays, double& depth)
{
  vtkDataArray* at = body->GetFieldData()->GetArray("RegimeDeflection");
  if (!at || at->GetNumberOfValues() != 1 || !body->GetPointData()->HasArray("RegimeVerdict"))
  {
    return {};
  }
  const double found = at->GetTuple1(0);
  if (depth == 0.0)
  {
    // The largest, where the regime followed Range; as it is done here without it.
    const double longest = *std::max_element(arrays.range, arrays.range + arrays.points);
    depth = std::abs(found - 0.5 * longest) <= 1e-6 * longest ? 0.0 : found;
    return {};
  }
  return std::abs(found - depth) <= 1e-6 * depth
    ? std::string()
    : joined("RegimeVerdict is that of ", found, " mm (RegimeDeflection), but Deflection is ",
        depth, " mm");
}

std::string checkSettings(const ChoiceSettings& settings)
{
  if (!(settings.tolerance > 0.0))
  {
    return joined("Tolerance must be above 0, but is ", settings.tolerance);
  }
  if (!(settings.share > 0.0 && settings.share <= 1.0))
  {
    return joined("Share must be above 0 and at most 1, but is ", settings.share);
  }
  if (!(settings.depth >= 0.0 && std::isfinite(settings.depth)))
  {
    return joined("Deflection must be finite and not negative (mm), but is ", settings.depth);
  }
  if (settings.mostLaws < 1 || settings.mostLaws > 16)
  {
    return joined("MaximumNumberOfLaws must lie between 1 and 16, but is ", settings.mostLaws);
  }
  return {};
}
} // namespace

std::string checkRequest(const LawRequest& request)
{
  constexpr int mostSamples = ResponseSampling::LargestCount;
  if (!request.tool)
  {
    return "A Tool is required: call SetTool";
  }
  if (!request.tool->GetKernel())
  {
    return "The Tool is invalid";
  }
  if (!(std::isfinite(request.deflection) &&
        request.deflection > static_cast<double>(std::numeric_limits<float>::min())))
  {
    return joined(
      "MaximumDeflection must be positive and finite (mm), but is ", request.deflection);
  }
  if (request.samples < 2 || request.samples > mostSamples)
  {
    return joined(
      "NumberOfSamples must lie between 2 and ", mostSamples, ", but is ", request.samples);
  }
  const double tolerance = request.terms.errorTolerance;
  if (!(tolerance >= 0.0 && std::isfinite(tolerance)))
  {
    return joined(
      "ErrorTolerance must be finite and not negative (a fraction of the force, 0 for the "
      "depths of small strain), but is ",
      tolerance);
  }
  const double change = request.terms.changeTolerance;
  if (!(change >= 0.0 && std::isfinite(change)))
  {
    return joined(
      "TermTolerance must be finite and not negative (a fraction of the force), but is ", change);
  }
  return request.responseName.empty() ? "ResponseName must not be empty" : "";
}

std::string attachResponse(const Ranks& ranks, vtkPolyData* body, const LawRequest& request,
  const std::function<bool(double)>& goOn, vtkPolyData* output, std::string& warning)
{
  const bool hasPiece = body->GetNumberOfPoints() > 0;
  if (!ranks.any(hasPiece))
  {
    return {};
  }
  std::string fault = ranks.firstFault(hasPiece ? checkTriangles(body) : std::string());
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  fault = checkRequest(request);
  BodyMaterial material(request.material);
  if (fault.empty())
  {
    fault =
      ranks.firstFault(hasPiece ? readMaterial(body, request.arrays, material) : std::string());
  }
  if (!fault.empty())
  {
    return fault;
  }
  agreeOnRange(ranks, hasPiece, material);
  const AxisymmetricTool& tool = *request.tool->GetKernel();
  fault = tool.checkDepth(request.deflection);
  if (!fault.empty())
  {
    return "MaximumDeflection: " + fault;
  }
  const std::string& name = request.responseName;
  const vtkIdType count = body->GetNumberOfPoints();
  ResponseStorage storage(name, count, request.samples, request.terms.keepsError());
  const BodySeam seam(ranks, body);
  fault = fillPointNormals(body, seam, storage.Normal, storage.Status);
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  const float* normals = storage.Normal->GetPointer(0);
  const CurvatureBound bound(body, seam, normals);
  LawTerms terms = request.terms;
  const std::shared_ptr<const BodyShape> found =
    findShape(body, seam, normals, tool.contactRadius(request.deflection), terms);
  const SurfaceShape shape{ widthOf(body, ranks),
    [&bound](std::size_t i) { return static_cast<double>(bound.at(static_cast<vtkIdType>(i))); },
    [&found](std::size_t i) { return found->curvatureAt(i); },
    [&found](std::size_t i) { return found->edgeAt(i); } };
  std::unique_ptr<StrainCorrection> strain;
  const auto makeStrain =
    [&](const BodyMaterial& of, const StrainLaw& law, std::unique_ptr<StrainCorrection>& made)
  { return findStrain(request, law, of, goOn, made); };
  const FilterThreads threads;
  std::string reason;
  if (terms.automatic)
  {
    AutomaticTerms chosen{ terms, material };
    fault = chooseTerms(ranks, body, request, shape, makeStrain, chosen);
    if (!fault.empty())
    {
      return fault;
    }
    terms = chosen.terms;
    material = std::move(chosen.material);
    strain = std::move(chosen.strain);
    reason = chosen.reason;
  }
  if (!hasPiece)
  {
    return {};
  }
  fault = strain ? std::string() : makeStrain(material, terms.strain, strain);
  if (!fault.empty())
  {
    return fault;
  }
  const MadeResponse made =
    response(tool, material, request.deflection, static_cast<std::size_t>(count), shape,
      { terms.curvature, strain.get(), terms.errorTolerance, request.measured }, storage.spans(),
      goOn);
  if (!made.complete)
  {
    output->Initialize();
    return {};
  }
  if (made.without > 0)
  {
    warning =
      joined(made.without, " of ", count, " points have no response: see array '", name, "Status'");
  }
  copyWithOwnFields(body, output);
  storage.attach(output);
  const ResponseModel beyond = termsOf(terms);
  describeResponse(output, name,
    { made.exponent, request.samples, tool.specification(), material.describe() + beyond.text,
      material.modelParts() | beyond.parts });
  attachLayers(material, name, output);
  if (!reason.empty())
  {
    addText(output, termsName(name), reason);
  }
  return {};
}

std::string attachRegime(
  const Ranks& ranks, vtkPolyData* body, const LawRequest& request, vtkPolyData* output)
{
  const bool hasPiece = body->GetNumberOfPoints() > 0;
  if (!ranks.any(hasPiece))
  {
    return {};
  }
  // Once all agree that nothing is wrong, a rank without a piece has nothing to do but to agree.
  const std::string& name = request.responseName;
  std::string fault;
  vtkSmartPointer<vtkContactTool> tool;
  std::vector<double> depths;
  BodyMaterial material(request.material);
  if (hasPiece)
  {
    tool = findTool(request.tool, body, name, fault);
    fault = fault.empty() && !tool->GetKernel() ? "The Tool is invalid" : fault;
    fault = fault.empty() ? findDepths(body, request, depths) : fault;
    fault = fault.empty() ? readMaterial(body, request.arrays, material) : fault;
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
    // As the response was made: on the scale of its deepest contact.
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
      shape = findShape(body, BodySeam(ranks, body), normals ? normals->GetPointer(0) : nullptr,
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
    std::string noResponse;
    // The regime is that of small strain.
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
  return {};
}

std::string attachChoice(vtkPolyData* body, const std::string& responseName,
  const ChoiceSettings& settings, vtkPolyData* output, AttachedChoice& attached)
{
  std::string fault = checkSettings(settings);
  ResponseArrays arrays;
  std::string missing;
  if (fault.empty() && !viewResponse(body, responseName, arrays, missing))
  {
    fault = "No response '" + responseName + "' on the body: " + missing;
  }
  ChoiceEvidence evidence;
  fault = fault.empty() ? readEvidence(body, responseName, evidence) : fault;
  ChoiceSettings used = settings;
  fault = fault.empty() ? chooseDepth(body, arrays, used.depth) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  const FilterThreads threads;
  attached.choice = chooseResponse(arrays, evidence, used);
  attached.numbersPerPointBefore = arrays.basis ? arrays.laws : 2 * arrays.samples;
  attached.reason = choiceReason(attached.choice, used, attached.numbersPerPointBefore);
  const std::string terms = termsReason(body, responseName);
  attached.reason += terms.empty() ? terms : ". Of its law: " + terms;
  copyWithOwnFields(body, output);
  if (attached.choice.need != ResponseNeed::PerVertex)
  {
    replaceCurves(output, responseName, attached.choice);
  }
  addText(output, responseName + "Choice", attached.reason);
  return {};
}
} // namespace palpate
