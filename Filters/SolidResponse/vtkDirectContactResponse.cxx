// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDirectContactResponse.h"

#include "Mechanics/Checked.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/ArrayFetch.h"
#include "SolidResponse/Bodies/CoarserBody.h"
#include "SolidResponse/Bodies/DirectPresses.h"
#include "Response/BodyConversion.h"
#include "Response/BodyLaws.h"
#include "Response/Curves/StoredError.h"
#include "Response/FilterStage.h"
#include "Response/FilterThreads.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"
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
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// Fractions of the progress at the end of two steps.
constexpr double RestShare = 0.05;
constexpr double BothRestsShare = 0.06;
/// A curve that reaches this fraction of the depth counts as complete.
constexpr double CompleteFraction = 0.999;

/// Replaces a point array by a copy that only this body uses.
template <class Array>
Array* ownCopy(vtkPolyData* body, const std::string& name, palpate::ResponseArray which)
{
  vtkPointData* data = body->GetPointData();
  auto* from = Array::SafeDownCast(data->GetArray(palpate::arrayName(name, which).c_str()));
  vtkNew<Array> own;
  own->DeepCopy(from);
  data->AddArray(own);
  return own;
}
} // namespace

/// The two bodies, and the surface on which the tool is pressed.
struct vtkDirectContactResponse::Bodies
{
  palpate::PreparedSurface surface;
  palpate::RestOfBody rest;
  palpate::RestOfBody coarser;
  std::unique_ptr<palpate::StrainCorrection> strain;
};

vtkStandardNewMacro(vtkDirectContactResponse);

vtkDirectContactResponse::vtkDirectContactResponse()
{
  this->SetNumberOfInputPorts(4);
}
vtkDirectContactResponse::~vtkDirectContactResponse() = default;

int vtkDirectContactResponse::FillInputPortInformation(int port, vtkInformation* info)
{
  const bool isSolid = port == 1 || port == 2;
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), isSolid ? "vtkUnstructuredGrid" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 3 ? 1 : 0);
  return 1;
}

void vtkDirectContactResponse::SetBodyData(vtkUnstructuredGrid* body)
{
  this->SetInputData(1, body);
}

void vtkDirectContactResponse::SetCoarserData(vtkUnstructuredGrid* coarser)
{
  this->SetInputData(2, coarser);
}

void vtkDirectContactResponse::SetShapeData(vtkPolyData* shape)
{
  this->SetInputData(3, shape);
}

int vtkDirectContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfPresses = 0;
  this->NumberOfReplaced = 0;
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const palpate::SoundBody sound(input);
  vtkPolyData* surface = sound.body();
  const palpate::FilterThreads threads;
  vtkUnstructuredGrid* body = vtkUnstructuredGrid::GetData(inputVector[1]);
  vtkUnstructuredGrid* coarser = vtkUnstructuredGrid::GetData(inputVector[2]);
  vtkPolyData* shape = vtkPolyData::GetData(inputVector[3]);
  std::string fault = palpate::firstFault([this] { return this->CheckProperties(); },
    [&] { return palpate::prefixed("Wrong input: ", sound.fault()); },
    [&] { return this->CheckResponse(surface, body, coarser); },
    []
    {
      return palpate::hasSurfaceMesher()
        ? std::string()
        : std::string("No part can be filled: ") + palpate::missingMesher();
    });
  if (fault.empty())
  {
    palpate::copyWithOwnFields(surface, output);
    std::vector<vtkIdType> points = this->FindPoints(surface);
    points.erase(std::remove_if(points.begin(), points.end(),
                   [&sound](vtkIdType point) { return sound.firstAt(point) != point; }),
      points.end());
    Bodies bodies;
    bool isEnded = false;
    fault = palpate::firstFault(
      [&]
      {
        return points.empty()
          ? std::string()
          : this->Prepare(shape ? shape : surface, body, coarser, bodies, isEnded);
      },
      [&] { return isEnded ? std::string() : this->Press(points, bodies, output); });
    sound.giveBack(output);
  }
  if (!fault.empty() || palpate::isAborted(this))
  {
    output->Initialize();
  }
  return this->Report(fault);
}

std::string vtkDirectContactResponse::CheckProperties()
{
  palpate::LawRequest request;
  request.tool = this->Tool;
  request.responseName = this->ResponseName;
  request.deflection = this->MaximumDeflection;
  request.terms.errorTolerance = this->ErrorTolerance;
  palpate::FactorRequest factor;
  factor.material = { this->YoungsModulus, this->PoissonRatio };
  return palpate::firstFault([&] { return palpate::checkShapedRequest(request); },
    [this]
    {
      return this->ErrorTolerance > 0.0
        ? std::string()
        : palpate::joined("Error Tolerance must be positive, but is ", this->ErrorTolerance);
    },
    [&] { return palpate::checkFactorRequest(factor); });
}

std::string vtkDirectContactResponse::CheckResponse(
  vtkPolyData* surface, vtkUnstructuredGrid* body, vtkUnstructuredGrid* coarser) const
{
  const auto isEmpty = [](vtkUnstructuredGrid* grid)
  { return !grid || grid->GetNumberOfCells() == 0; };
  if (isEmpty(body) || isEmpty(coarser))
  {
    return palpate::joined("Wrong input: ", isEmpty(body) ? "Body" : "Coarser", " has no cells");
  }
  std::string fault = palpate::checkCoarser(body, coarser);
  palpate::ResponseArrays arrays;
  if (fault.empty() && !palpate::viewResponse(surface, this->ResponseName, arrays, fault))
  {
    return palpate::joined("Wrong input: no response '", this->ResponseName, "': ", fault);
  }
  const float* validity = nullptr;
  const unsigned char* limit = nullptr;
  if (fault.empty() && !palpate::viewValidity(surface, this->ResponseName, validity, limit, fault))
  {
    return "Wrong input: " + fault;
  }
  if (fault.empty() && arrays.force == nullptr)
  {
    return palpate::joined("Wrong input: response '", this->ResponseName,
      "' was reduced, so that a point has no curve of its own: press before the reduction");
  }
  if (fault.empty() &&
    !palpate::fetchArray<vtkFloatArray>(
      surface, this->ResponseName, palpate::ResponseArray::Error, arrays, fault))
  {
    return "Wrong input: " + fault + ": make the response with Store Error";
  }
  vtkDataArray* pressed = surface->GetPointData()->GetArray("Pressed");
  if (fault.empty() && pressed && pressed->GetNumberOfComponents() != 1)
  {
    return "Wrong input: array 'Pressed' must have 1 component";
  }
  return fault;
}

/// Finds the points at which the error of the response is too large or the curve ends too early.
std::vector<vtkIdType> vtkDirectContactResponse::FindPoints(vtkPolyData* surface) const
{
  palpate::ResponseArrays arrays;
  std::string fault;
  // This cannot fail after CheckResponse.
  palpate::viewResponse(surface, this->ResponseName, arrays, fault);
  const palpate::StoredError errors(surface, this->ResponseName);
  vtkDataArray* pressed = surface->GetPointData()->GetArray("Pressed");
  std::vector<vtkIdType> found;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const auto status = static_cast<palpate::ResponseStatus>(arrays.status[at]);
    const auto range = static_cast<double>(arrays.range[at]);
    const bool isKnown = status == palpate::ResponseStatus::Valid &&
      range >= CompleteFraction * this->MaximumDeflection &&
      errors.at(i, std::min(range, this->MaximumDeflection)) <= this->ErrorTolerance;
    const bool canBe = status == palpate::ResponseStatus::Valid ||
      status == palpate::ResponseStatus::Edge || status == palpate::ResponseStatus::Folded;
    if (!isKnown && canBe && (!pressed || pressed->GetTuple1(i) != 0.0))
    {
      found.push_back(i);
    }
  }
  return found;
}

std::string vtkDirectContactResponse::Prepare(vtkPolyData* shape, vtkUnstructuredGrid* body,
  vtkUnstructuredGrid* coarser, Bodies& bodies, bool& ended)
{
  palpate::FactorRequest request;
  request.material = { this->YoungsModulus, this->PoissonRatio };
  double memory = 0.0;
  std::string fault = bodies.rest.factorise(
    body, request, palpate::FilterStage{ this, 0.0, RestShare }, memory, ended);
  if (fault.empty() && !ended)
  {
    fault = palpate::prefixed("Coarser: ",
      bodies.coarser.factorise(
        coarser, request, palpate::FilterStage{ this, RestShare, BothRestsShare }, memory, ended));
  }
  if (!fault.empty() || ended)
  {
    return fault;
  }
  const double radius = this->Tool->GetKernel()->contactRadius(this->MaximumDeflection);
  palpate::HeldFaces faces{};
  fault = palpate::firstFault([&]
    { return palpate::readHeldFaces(this->FixedFaces, bodies.rest.spacing(), faces); },
    [&] { return palpate::takeSurface(shape, bodies.surface); },
    [&] { return palpate::mendAndCut(radius, faces, bodies.surface); });
  for (const std::string& warning : bodies.surface.warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!fault.empty() || this->StrainModel == SmallStrain)
  {
    return fault;
  }
  const palpate::FilterStage stage{ this, BothRestsShare, BothRestsShare };
  fault = palpate::makeStrainCorrection(*this->Tool->GetKernel(), this->strainLaw(),
    palpate::StrainBodies{ this->PoissonRatio, this->PoissonRatio }, this->MaximumDeflection, stage,
    bodies.strain);
  ended = fault.empty() && !bodies.strain;
  return fault;
}

std::string vtkDirectContactResponse::Press(
  const std::vector<vtkIdType>& points, const Bodies& bodies, vtkPolyData* output)
{
  using palpate::DirectOutcome;
  using palpate::ResponseArray;
  palpate::ResponseArrays arrays;
  std::string fault;
  // This cannot fail after CheckResponse.
  palpate::viewResponse(output, this->ResponseName, arrays, fault);
  const std::string& name = this->ResponseName;
  const palpate::ResponseSpans spans{ arrays.samples,
    ownCopy<vtkFloatArray>(output, name, ResponseArray::Force)->GetPointer(0),
    ownCopy<vtkFloatArray>(output, name, ResponseArray::Stiffness)->GetPointer(0),
    ownCopy<vtkFloatArray>(output, name, ResponseArray::Range)->GetPointer(0),
    ownCopy<vtkFloatArray>(output, name, ResponseArray::Validity)->GetPointer(0),
    ownCopy<vtkUnsignedCharArray>(output, name, ResponseArray::Status)->GetPointer(0),
    ownCopy<vtkUnsignedCharArray>(output, name, ResponseArray::Limit)->GetPointer(0),
    ownCopy<vtkFloatArray>(output, name, ResponseArray::Error)->GetPointer(0) };
  vtkNew<vtkUnsignedCharArray> became;
  became->SetName(palpate::arrayName(name, ResponseArray::Direct).c_str());
  became->SetNumberOfValues(output->GetNumberOfPoints());
  became->Fill(static_cast<double>(DirectOutcome::NotPressed));
  std::vector<std::string> faults(points.size());
  const palpate::AxisymmetricTool& tool = *this->Tool->GetKernel();
  const palpate::DirectTerms terms{ &tool, { this->YoungsModulus, this->PoissonRatio },
    this->MaximumDeflection, this->ErrorTolerance, bodies.strain.get(),
    this->StrainModel == NeoHooke && palpate::isForFiniteStrain(tool) };
  const palpate::ResponseSampling sampling(arrays.samples, arrays.exponent);
  const palpate::DirectPresses presses(bodies.surface, bodies.rest, bodies.coarser, terms);
  const auto press = [&](std::size_t i)
  {
    const vtkIdType point = points[i];
    const auto at = static_cast<std::size_t>(point);
    palpate::DirectPlace place;
    output->GetPoint(point, place.place.data());
    const Eigen::Vector3f normal = Eigen::Map<const Eigen::Vector3f>(arrays.normal + 3 * at);
    place.inward = -normal.cast<double>().normalized();
    palpate::DirectPresses::Contacts contacts;
    std::string& wrong = faults[i];
    wrong = presses.at(place, contacts);
    DirectOutcome outcome = DirectOutcome::Failed;
    if (wrong.empty())
    {
      outcome =
        palpate::takeDirectCurve(at, contacts.finer, contacts.coarser, terms, sampling, spans);
      wrong = "no contact converges"; // this is reported if the outcome is Failed
    }
    became->SetValue(point, static_cast<unsigned char>(outcome));
  };
  if (!palpate::shareWork(points.size(), press, palpate::FilterStage{ this, BothRestsShare, 1.0 }))
  {
    return {};
  }
  const auto isIt = [&](DirectOutcome what)
  {
    return [is = static_cast<unsigned char>(what), &became](vtkIdType point)
    { return became->GetValue(point) == is; };
  };
  this->NumberOfPresses = static_cast<vtkIdType>(points.size());
  this->NumberOfReplaced =
    std::count_if(points.begin(), points.end(), isIt(DirectOutcome::Replaced));
  const auto failed = std::count_if(points.begin(), points.end(), isIt(DirectOutcome::Failed));
  if (failed > 0)
  {
    const auto first = static_cast<std::size_t>(
      std::find_if(points.begin(), points.end(), isIt(DirectOutcome::Failed)) - points.begin());
    vtkWarningMacro(<< "Direct contact failed at " << failed << " of " << points.size()
                    << " points, which keep their response; at the first, " << points[first]
                    << ", since " << faults[first] << ".");
  }
  output->GetPointData()->AddArray(became);
  palpate::addText(output, name, ResponseArray::Model,
    palpate::joined(palpate::responseText(output, name, ResponseArray::Model),
      "; by direct contact at ", this->NumberOfReplaced, " points"));
  return {};
}

void vtkDirectContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FixedFaces: " << this->FixedFaces << "\n";
  os << indent << "NumberOfPresses: " << this->NumberOfPresses << "\n";
  os << indent << "NumberOfReplaced: " << this->NumberOfReplaced << "\n";
}
