// SPDX-License-Identifier: BSD-3-Clause
#include "Response/BodyLaws.h"

#include "Contact/Edges/EdgeLaw.h"
#include "Laws/ResponseFiller.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/AutomaticTerms.h"
#include "Response/Curves/BodyGeometry.h"
#include "Response/Curves/BodyShape.h"
#include "Response/Curves/PressedPoints.h"
#include "Response/Curves/ResponseStorage.h"
#include "Response/Curves/TiltRequest.h"
#include "Response/FilterThreads.h"
#include "Response/Pieces/LoadedPieces.h"
#include "Response/ReplacedCurves.h"
#include "Response/ResponseTool.h"
#include "Response/WholeBody.h"
#include "vtkContactTool.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

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
constexpr double WholeBodyShare = 0.9; // fraction of the work, if the body's compliance is included

/// Makes the correction by finite strain; null for the linear model. Returns "" or an error
/// message.
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

/// The terms in addition to small strain on a flat surface, as text and as a sum of ModelPart.
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

/// The terms of a contact at sharp edges, on a body of the given depth (mm) or on a layer.
EdgeTerms edgesOf(
  const AxisymmetricTool& tool, double deflection, const BodyMaterial& material, double depth)
{
  const MaterialRange& range = material.range();
  EdgeTerms edges = edgeTermsOf(tool, deflection, 0.5 * (range.leastRatio + range.mostRatio));
  const bool isLayered = range.hasLayers() && !range.hasHalfSpace;
  edges.extent = isLayered ? std::min(depth, range.layers.thickest) : depth;
  edges.isInCurves = (material.modelParts() & GlobalCompliancePart) != 0;
  return edges;
}

std::string checkToolDepth(const LawRequest& request)
{
  const std::string fault = request.tool->GetKernel()->checkDepth(request.deflection);
  return fault.empty() ? fault : "Maximum Deflection: " + fault;
}
} // namespace

std::string checkRequest(const LawRequest& request)
{
  constexpr int mostSamples = ResponseSampling::LargestCount;
  if (!request.tool)
  {
    return "A Tool is required (SetTool)";
  }
  if (!request.tool->GetKernel())
  {
    return "The Tool is invalid";
  }
  if (!(std::isfinite(request.deflection) &&
        request.deflection > static_cast<double>(std::numeric_limits<float>::min())))
  {
    return joined(
      "Maximum Deflection must be positive and finite (mm), but is ", request.deflection);
  }
  if (request.samples < 2 || request.samples > mostSamples)
  {
    return joined(
      "Number Of Samples must lie between 2 and ", mostSamples, ", but is ", request.samples);
  }
  const double tolerance = request.terms.errorTolerance;
  if (!(tolerance >= 0.0 && std::isfinite(tolerance)))
  {
    return joined(
      "Error Tolerance must be finite and not negative (a fraction of the force, 0 for the "
      "depths of small strain), but is ",
      tolerance);
  }
  const double change = request.terms.changeTolerance;
  if (!(change >= 0.0 && std::isfinite(change)))
  {
    return joined("Largest Effect Left Out (TermTolerance) must be finite and not negative (a "
                  "fraction of the force), but is ",
      change);
  }
  return request.responseName.empty() ? "Response Name must not be empty" : "";
}

std::string attachResponse(const Ranks& ranks, vtkPolyData* input, const LawRequest& asked,
  const std::function<bool(double)>& observer, vtkPolyData* output, std::string& warning)
{
  LawRequest request = asked;
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
  const SoundBody sound(input, extentOn(ranks));
  fault = ranks.firstFault(sound.fault());
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  vtkSmartPointer<vtkPolyData> body = sound.body();
  fault = checkRequest(request);
  fault = fault.empty() ? checkToolDepth(request) : fault;
  BodyMaterial material(request.material);
  if (fault.empty())
  {
    fault =
      ranks.firstFault(hasPiece ? readMaterial(body, request.arrays, material) : std::string());
  }
  if (fault.empty())
  {
    fault = ranks.firstFault(hasPiece
        ? checkPointArray(request.pressed, PressedArrayIndex, body->GetNumberOfPoints())
        : std::string());
  }
  const double from = request.wholeBody ? WholeBodyShare : 0.0;
  const auto goOn = [&](double done) { return !observer || observer(from + (1.0 - from) * done); };
  WholeBody whole;
  if (fault.empty())
  {
    whole = includeWholeBody(
      ranks, body, [&](double done) { return !observer || observer(from * done); }, request);
    if (!whole.isComplete)
    {
      return {};
    }
    warning = whole.warning;
    body = whole.body;
    if (!whole.heldAt.empty())
    {
      material = BodyMaterial(request.material);
      fault = readMaterial(body, request.arrays, material);
    }
  }
  const MaterialArray& compliance = request.arrays[ComplianceArrayIndex];
  if (fault.empty())
  {
    fault = ranks.firstFault(
      hasPiece ? checkRelaxation(body, request.relaxation, compliance) : std::string());
  }
  if (!fault.empty())
  {
    return fault;
  }
  agreeOnRange(ranks, hasPiece, material);
  fault =
    ranks.firstFault(hasPiece && request.couples ? checkCouples(material, body) : std::string());
  if (!fault.empty())
  {
    return fault;
  }
  const AxisymmetricTool& tool = *request.tool->GetKernel();
  const TiltRequest tilts{ tool, request.terms.tilt, request.deflection };
  fault = checkTilts(tilts);
  if (!fault.empty())
  {
    return fault;
  }
  const std::string& name = request.responseName;
  const vtkIdType count = body->GetNumberOfPoints();
  ResponseStorage storage(name, count, request.samples, request.terms.keepsError());
  const BodySeam seam(ranks, body);
  const std::shared_ptr<const BodyGeometry> geometry = findGeometry(body, seam);
  if (!geometry->fault.empty())
  {
    return "Wrong input: " + geometry->fault;
  }
  storage.setNormals(geometry->normals, geometry->status);
  const vtkIdType notPressed = leaveOutOthers(request.pressed, sound, storage.Status);
  const float* normals = storage.Normal->GetPointer(0);
  const CurvatureBound& bound = *geometry->bound;
  LawTerms terms = request.terms;
  const std::shared_ptr<const BodyShape> found =
    findShape(body, seam, normals, tool.contactRadius(request.deflection), terms);
  const BodyLengths& lengths = geometry->lengths;
  const SurfaceShape shape{ lengths.middle,
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
      { terms.curvature, strain.get(), terms.errorTolerance, request.measured, terms.edges },
      storage.spans(), goOn);
  if (!made.complete)
  {
    output->Initialize();
    return {};
  }
  // A joined point has no triangle of its own. It gets the response of the first point at its
  // place.
  const vtkIdType without =
    static_cast<vtkIdType>(made.without) - sound.joinedPoints() - notPressed;
  if (without > 0)
  {
    warning += joined(warning.empty() ? "" : ". ", without, " of ", count,
      " points have no response: see array '", name, "Status'");
  }
  copyWithOwnFields(body, output);
  storage.attach(output);
  const ResponseModel beyond = termsOf(terms);
  describeResponse(output, name,
    { made.exponent, request.samples, tool.specification(),
      material.describe() + (whole.heldAt.empty() ? "" : ", held at " + whole.heldAt) +
        beyond.text + relaxationInWords(request.relaxation, compliance),
      material.modelParts() | beyond.parts });
  attachLayers(material, name, output);
  attachRelaxation(request.relaxation, compliance, name, output);
  removeArrays(output, name, ContractArray::Use::Coupling);
  if (request.couples)
  {
    attachCoupling(material, name, output);
  }
  if (terms.edges)
  {
    describeEdges(output, name, edgesOf(tool, request.deflection, material, lengths.least));
  }
  if (!reason.empty())
  {
    addText(output, termsName(name), reason);
  }
  fault = attachTilts(tilts, &material, terms.errorTolerance, name, output);
  if (!fault.empty())
  {
    output->Initialize();
  }
  sound.giveBack(output);
  return fault;
}
} // namespace palpate
