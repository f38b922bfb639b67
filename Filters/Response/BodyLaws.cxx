// SPDX-License-Identifier: BSD-3-Clause
#include "Response/BodyLaws.h"

#include "Laws/ResponseFiller.h"
#include "Mechanics/Checked.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/Bodies/BodyContent.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/AutomaticTerms.h"
#include "Response/Curves/BodyGeometry.h"
#include "Response/Curves/BodyShape.h"
#include "Response/Curves/PressedPoints.h"
#include "Response/Curves/ResponseStorage.h"
#include "Response/FilterThreads.h"
#include "Response/Pieces/LoadedPieces.h"
#include "Response/ReplacedCurves.h"
#include "Response/Terms/LawTerm.h"
#include "Response/WholeBody.h"
#include "vtkContactTool.h"

#include "vtkFloatArray.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace palpate
{
namespace
{
/// Fraction of the progress that the compliance of the whole body takes, if it is included.
constexpr double WholeBodyShare = 0.9;

/// Creates a response step by step. After each step, all ranks exchange their faults and aborts, so
/// that no rank waits for another rank in a later step.
class ResponseInMaking
{
public:
  ResponseInMaking(const Ranks& ranks, vtkPolyData* input, const LawRequest& request,
    const std::function<bool(double)>& observer, vtkPolyData* output)
    : All(ranks)
    , Input(input)
    , Output(output)
    , Request(request)
    , Observer(observer)
    , Material(request.material)
    , HasPiece(input->GetNumberOfPoints() > 0)
  {
  }

  /// Creates the response. Returns "" or an error message. The output is empty after a fault or an
  /// abort.
  std::string make();
  const std::string& warning() const { return this->Warning; }

private:
  /// A step of the work. `take` returns an error message or "". `isAlike` states that the message
  /// is the same on all ranks.
  struct Step
  {
    std::string (ResponseInMaking::*take)();
    bool isForAll; ///< whether ranks without a piece of the body also take the step
    bool isAlike;
  };
  static const std::array<Step, 14> Steps;

  std::string loadPieces() { return missingPieces(this->All); }
  std::string repairBody();
  std::string checkSettings();
  std::string readMaterial();
  std::string checkPressed();
  std::string includeBody();
  std::string agreeOnMaterial();
  std::string checkTerms() { return palpate::checkTerms(this->terms(), this->Body); }
  std::string findNormals();
  std::string findShape();
  std::string chooseTerms();
  std::string correctStrain();
  std::string fillCurves();
  std::string attach();

  const AxisymmetricTool& tool() const { return *this->Request.tool->GetKernel(); }
  TermBody terms() const
  {
    const double least = this->Geometry ? this->Geometry->lengths.least : 0.0;
    return { this->Request, this->tool(), &this->Material, least };
  }
  bool goOn(double done) const
  {
    const double from = this->Request.wholeBody ? WholeBodyShare : 0.0;
    return !this->Observer || this->Observer(from + (1.0 - from) * done);
  }
  SurfaceShape shape() const;
  /// Creates the finite-strain correction. Collective. All ranks return the same fault. If one rank
  /// was aborted, no rank returns a correction.
  Checked<std::unique_ptr<StrainCorrection>> makeStrain(
    const BodyMaterial& material, const StrainLaw& law) const;

  const Ranks& All;
  vtkPolyData* Input;
  vtkPolyData* Output;
  LawRequest Request; ///< the request, with the chosen terms
  const std::function<bool(double)>& Observer;
  BodyMaterial Material;
  bool HasPiece;
  std::optional<SoundBody> Sound;
  std::shared_ptr<const BodyContent> Content; ///< of the repaired body
  vtkSmartPointer<vtkPolyData> Body; ///< the repaired body, with the arrays of its compliance
  std::string HeldAt;
  std::optional<ResponseStorage> Storage;
  std::optional<BodySeam> Seam;
  std::shared_ptr<const BodyGeometry> Geometry;
  std::shared_ptr<const BodyShape> Shape;
  vtkIdType NotPressed = 0;
  std::unique_ptr<StrainCorrection> Strain;
  MadeResponse Made;
  std::string Reason; ///< reason for the choice of terms
  std::string Warning;
  bool IsEnded = false;
};

const std::array<ResponseInMaking::Step, 14> ResponseInMaking::Steps = { {
  { &ResponseInMaking::loadPieces, true, true },
  { &ResponseInMaking::repairBody, true, false },
  { &ResponseInMaking::checkSettings, true, true },
  { &ResponseInMaking::readMaterial, false, false },
  { &ResponseInMaking::checkPressed, false, false },
  { &ResponseInMaking::includeBody, true, true },
  { &ResponseInMaking::agreeOnMaterial, true, true },
  { &ResponseInMaking::checkTerms, false, false },
  { &ResponseInMaking::findNormals, true, true },
  { &ResponseInMaking::findShape, true, true },
  { &ResponseInMaking::chooseTerms, true, true },
  { &ResponseInMaking::correctStrain, true, true },
  { &ResponseInMaking::fillCurves, false, false },
  { &ResponseInMaking::attach, false, false },
} };

std::string ResponseInMaking::make()
{
  const FilterThreads threads;
  for (const Step& step : Steps)
  {
    std::string fault = step.isForAll || this->HasPiece ? (this->*step.take)() : std::string();
    fault = step.isAlike ? fault : this->All.firstFault(fault);
    if (!fault.empty() || this->All.any(this->IsEnded))
    {
      this->Output->Initialize();
      return fault;
    }
  }
  return {};
}

std::string ResponseInMaking::repairBody()
{
  this->Sound.emplace(this->Input, extentOn(this->All), &this->Content);
  this->Body = this->Sound->body();
  return prefixed("Wrong input: ", this->Sound->fault());
}

std::string ResponseInMaking::checkSettings()
{
  return firstFault([this] { return checkRequest(this->Request); },
    [this] { return checkToolDepth(this->tool(), this->Request.deflection); });
}

std::string ResponseInMaking::readMaterial()
{
  return palpate::readMaterial(this->Body, this->Request.arrays, this->Material);
}

std::string ResponseInMaking::checkPressed()
{
  return checkPointArray(this->Request.pressed, PressedArrayIndex, this->Body->GetNumberOfPoints());
}

std::string ResponseInMaking::includeBody()
{
  const WholeBody whole = includeWholeBody(
    this->All, this->Body,
    [this](double done) { return !this->Observer || this->Observer(WholeBodyShare * done); },
    this->Request);
  this->IsEnded = !whole.isComplete;
  this->Warning = whole.warning;
  this->Body = whole.body;
  this->HeldAt = whole.heldAt;
  if (this->HeldAt.empty())
  {
    return {};
  }
  this->Material = BodyMaterial(this->Request.material);
  return this->readMaterial();
}

std::string ResponseInMaking::agreeOnMaterial()
{
  agreeOnRange(this->All, this->HasPiece, this->Material);
  return {};
}

std::string ResponseInMaking::findNormals()
{
  this->Storage.emplace(this->Request.responseName, this->Body->GetNumberOfPoints(),
    this->Request.samples, this->Request.terms.keepsError());
  this->Seam.emplace(this->All, this->Body);
  this->Geometry = findGeometry(this->Body, *this->Content, *this->Seam);
  if (this->Geometry->fault.empty())
  {
    this->Storage->setNormals(this->Geometry->normals, this->Geometry->status);
  }
  return prefixed("Wrong input: ", this->Geometry->fault);
}

std::string ResponseInMaking::findShape()
{
  this->NotPressed = leaveOutOthers(this->Request.pressed, *this->Sound, this->Storage->Status);
  this->Shape = palpate::findShape(this->Content, *this->Seam, this->Storage->Normal->GetPointer(0),
    this->tool().contactRadius(this->Request.deflection), this->Request.terms);
  return {};
}

SurfaceShape ResponseInMaking::shape() const
{
  return { this->Geometry->lengths.middle,
    [this](std::size_t i)
    { return static_cast<double>(this->Geometry->bound->at(static_cast<vtkIdType>(i))); },
    [this](std::size_t i) { return this->Shape->curvatureAt(i); },
    [this](std::size_t i) { return this->Shape->edgeAt(i); } };
}

Checked<std::unique_ptr<StrainCorrection>> ResponseInMaking::makeStrain(
  const BodyMaterial& material, const StrainLaw& law) const
{
  std::unique_ptr<StrainCorrection> made;
  const std::string fault = this->All.firstFault(makeStrainCorrection(
    this->tool(), law, material.range().strainBodies(), this->Request.deflection,
    [this](double done) { return this->goOn(done); }, made));
  if (!fault.empty())
  {
    return Fault{ fault };
  }
  const bool isMade = !this->All.any(made == nullptr);
  return isMade ? std::move(made) : nullptr;
}

std::string ResponseInMaking::chooseTerms()
{
  if (!this->Request.terms.automatic)
  {
    return {};
  }
  const SurfaceShape surface = this->shape();
  AutomaticTerms choice(this->All, this->Body, this->Request, surface, std::move(this->Material),
    [this](const BodyMaterial& of, const StrainLaw& law) { return this->makeStrain(of, law); });
  const std::string fault = choice.choose();
  this->Material = std::move(choice.material);
  this->Strain = std::move(choice.strain);
  this->Reason = choice.reason();
  this->Request.terms = choice.terms;
  return fault;
}

std::string ResponseInMaking::correctStrain()
{
  const StrainLaw& law = this->Request.terms.strain;
  if (law.model == StrainModel::Linear || this->All.any(this->Strain != nullptr))
  {
    return {};
  }
  auto made = this->makeStrain(this->Material, law);
  this->Strain = made ? std::move(*made) : nullptr;
  this->IsEnded = made && !this->Strain;
  return made.fault();
}

std::string ResponseInMaking::fillCurves()
{
  const LawTerms& terms = this->Request.terms;
  this->Made = response(this->tool(), this->Material, this->Request.deflection,
    static_cast<std::size_t>(this->Body->GetNumberOfPoints()), this->shape(),
    { terms.curvature, this->Strain.get(), terms.errorTolerance, this->Request.measured,
      terms.edges },
    this->Storage->spans(), [this](double done) { return this->goOn(done); });
  this->IsEnded = !this->Made.complete;
  return {};
}

std::string ResponseInMaking::attach()
{
  const std::string& name = this->Request.responseName;
  // A joined point has no triangle of its own, but gets the response of the first point at its
  // position. Therefore joined points are not counted here.
  const vtkIdType without =
    static_cast<vtkIdType>(this->Made.without) - this->Sound->joinedPoints() - this->NotPressed;
  if (without > 0)
  {
    this->Warning += joined(this->Warning.empty() ? "" : ". ", without, " of ",
      this->Body->GetNumberOfPoints(), " points have no response: see array '", name, "Status'");
  }
  copyWithOwnFields(this->Body, this->Output);
  removeResponse(this->Output, name);
  this->Storage->attach(this->Output);
  const ResponseModel beyond = termsInWords(this->terms());
  describeResponse(this->Output, name,
    { this->Made.exponent, this->Request.samples, this->tool().specification(),
      this->Material.describe() + prefixed(", held at ", this->HeldAt) + beyond.text,
      this->Material.modelParts() | beyond.parts });
  if (!this->Reason.empty())
  {
    addText(this->Output, name, ResponseArray::Terms, this->Reason);
  }
  const std::string fault = makeTerms(this->terms(), this->Output);
  if (fault.empty())
  {
    this->Sound->giveBack(this->Output);
  }
  return fault;
}
} // namespace

std::string checkToolDepth(const AxisymmetricTool& tool, double deflection)
{
  return prefixed("Maximum Deflection: ", tool.checkDepth(deflection));
}

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

std::string attachResponse(const Ranks& ranks, vtkPolyData* input, const LawRequest& request,
  const std::function<bool(double)>& observer, vtkPolyData* output, std::string& warning)
{
  if (!ranks.any(input->GetNumberOfPoints() > 0))
  {
    return {};
  }
  ResponseInMaking making(ranks, input, request, observer, output);
  const std::string fault = making.make();
  warning = making.warning();
  return fault;
}
} // namespace palpate
