// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/ModulusChange.h"

#include "Contact/ResponseContract.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/SharedWork.h"
#include "Response/BodyConversion.h"
#include "Response/BodyField.h"
#include "Response/FilterThreads.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

namespace palpate
{
namespace
{
// Largest ratio of two moduli at which floats keep their accuracy.
constexpr double LargestChange = 1e6;
/// Largest relative rounding error of the product of modulus and compliance.
constexpr double Rounding = 1e-12;
constexpr std::size_t Share = 65536; // number of values that a thread scales at a time

auto lawOf(const LawTerms& terms)
{
  return std::tie(terms.curvature, terms.strain.model, terms.strain.parameter, terms.errorTolerance,
    terms.storeError, terms.automatic, terms.changeTolerance, terms.edges, terms.tilt);
}

/// The parts of a request that must be equal. Poisson's ratio, the terms of the law and the
/// relaxation are compared separately.
auto partsOf(const ResponseRequest& request)
{
  return std::tie(request.body, request.names, request.toolKeys, request.stored,
    request.maximumDeflection, request.layerThickness, request.thicknessArray, request.base,
    request.complianceArray, request.tolerance, request.choiceDeflection);
}

/// Returns the factor by which all forces differ between two requests.
double factorBetween(const ResponseRequest& known, const ResponseRequest& wanted)
{
  return reducedModulus(wanted.youngsModulus, wanted.poissonRatio) /
    reducedModulus(known.youngsModulus, known.poissonRatio);
}

/// Whether the requests differ at most in the elastic constants, and all other elastic constants of
/// the body change in proportion.
bool differInMaterialOnly(const ResponseRequest& known, const ResponseRequest& wanted);

/// Whether the body is an elastic half-space with one material, at small strain.
bool isHalfSpace(const MadeResponses& known)
{
  const ResponseRequest& of = known.of;
  const auto hasFiniteStrain = [&](const std::string& name)
  { return (responseModel(known.body, name).parts & FiniteStrainPart) != 0; };
  return of.layerThickness == 0.0 && of.thicknessArray.empty() && of.complianceArray.empty() &&
    of.terms.strain.model == StrainModel::Linear && of.terms.tilt == 0.0 &&
    std::none_of(of.names.begin(), of.names.end(), hasFiniteStrain);
}

bool haveSameRelaxation(const RelaxationRequest& a, const RelaxationRequest& b)
{
  return a.complianceRelaxes == b.complianceRelaxes && a.strength.array == b.strength.array &&
    a.series.count == b.series.count && a.series.strength == b.series.strength &&
    a.series.time == b.series.time;
}

/// Returns the exponent p if a quantity with this unit is proportional to the modulus to the power
/// p. The deflections of the body are assumed not to change.
double powerOf(std::string_view unit)
{
  return unit == "N" || unit == "N/mm" || unit == "MPa" ? 1.0
    : unit == "mm/N"                                    ? -1.0
    : unit == "\u221a(mm/N)"                            ? -0.5
                                                        : 0.0;
}

/// Returns the exponent of powerOf(unit) for an array of a response or of the body's compliance.
double powerOf(const std::string& name, const ResponseRequest& request)
{
  for (const std::string& response : request.names)
  {
    for (const ContractArray& array : ResponseContract)
    {
      if (name == array.named(response))
      {
        return powerOf(array.unit);
      }
    }
  }
  if (request.complianceArray.empty() || name == GlobalModeSignArray)
  {
    return 0.0;
  }
  return name == request.complianceArray || name == request.complianceArray + "Error"
    ? powerOf("mm/N")
    : name.rfind("GlobalMode", 0) == 0 ? powerOf("\u221a(mm/N)")
                                       : 0.0;
}

vtkSmartPointer<vtkDataArray> scaled(vtkDataArray* array, double factor)
{
  const auto made = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  const int width = array->GetNumberOfComponents();
  made->SetName(array->GetName());
  made->SetNumberOfComponents(width);
  made->SetNumberOfTuples(array->GetNumberOfTuples());
  if (auto* floats = vtkFloatArray::SafeDownCast(made))
  {
    const float* from = vtkFloatArray::SafeDownCast(array)->GetPointer(0);
    float* to = floats->GetPointer(0);
    shareWork((count + Share - 1) / Share,
      [&](std::size_t part)
      {
        std::transform(from + part * Share, from + std::min(count, (part + 1) * Share),
          to + part * Share,
          [factor](float value)
          { return static_cast<float>(factor * static_cast<double>(value)); });
      });
    return made;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i) / width;
    const int component = static_cast<int>(static_cast<vtkIdType>(i) % width);
    made->SetComponent(tuple, component, factor * array->GetComponent(tuple, component));
  }
  return made;
}

vtkSmartPointer<vtkPolyData> scaled(
  vtkPolyData* body, const ResponseRequest& request, double factor)
{
  const auto made = vtkSmartPointer<vtkPolyData>::New();
  made->ShallowCopy(body);
  for (vtkFieldData* data :
    { static_cast<vtkFieldData*>(made->GetPointData()), made->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      const std::string name = array && array->GetName() ? array->GetName() : "";
      const double power = powerOf(name, request);
      if (power != 0.0)
      {
        // This replaces the array with the same name.
        data->AddArray(scaled(array, std::pow(factor, power)));
      }
    }
  }
  for (const std::string& response : request.names)
  {
    const std::string name = contractOf(ResponseArray::Edges).named(response);
    if (vtkDataArray* edges = made->GetFieldData()->GetArray(name.c_str()))
    {
      constexpr int ratio = 2; // index of the component with Poisson's ratio
      vtkSmartPointer<vtkDataArray> copy = scaled(edges, 1.0);
      copy->SetComponent(0, ratio, request.poissonRatio);
      made->GetFieldData()->AddArray(copy);
    }
  }
  return made;
}
} // namespace

bool areEqual(const ResponseRequest& one, const ResponseRequest& other)
{
  return partsOf(one) == partsOf(other) && one.poissonRatio == other.poissonRatio &&
    lawOf(one.terms) == lawOf(other.terms) &&
    haveSameRelaxation(one.relaxation, other.relaxation) && one.deeper == other.deeper &&
    one.secondArray == other.secondArray && one.halfSpace == other.halfSpace &&
    one.coupling == other.coupling && one.youngsModulus == other.youngsModulus &&
    one.complianceFactor == other.complianceFactor;
}

namespace
{
bool differInMaterialOnly(const ResponseRequest& known, const ResponseRequest& wanted)
{
  const auto modulusTimesCompliance = [](const ResponseRequest& request)
  { return request.youngsModulus * request.complianceFactor; };
  const double factor = wanted.youngsModulus / known.youngsModulus;
  const bool isProportional = !wanted.stored && !wanted.coupling && wanted.deeper.empty() &&
    wanted.secondArray.empty() && !wanted.halfSpace && factor > 1.0 / LargestChange &&
    factor < LargestChange &&
    (wanted.complianceArray.empty() ||
      std::abs(modulusTimesCompliance(wanted) / modulusTimesCompliance(known) - 1.0) < Rounding);
  return isProportional && !known.coupling && known.deeper.empty() && !known.halfSpace &&
    partsOf(known) == partsOf(wanted) && lawOf(known.terms) == lawOf(wanted.terms) &&
    haveSameRelaxation(known.relaxation, wanted.relaxation);
}
} // namespace

bool isModulusChange(const ResponseRequest& known, const ResponseRequest& wanted)
{
  return known.poissonRatio == wanted.poissonRatio && differInMaterialOnly(known, wanted);
}

bool isPoissonChange(const MadeResponses& known, const ResponseRequest& wanted)
{
  return isPoissonsRatio(wanted.poissonRatio) && differInMaterialOnly(known.of, wanted) &&
    isHalfSpace(known);
}

MadeResponses scaleForces(const MadeResponses& known, const ResponseRequest& wanted,
  const std::function<bool(double)>& goOn)
{
  const FilterThreads threads;
  const double factor = factorBetween(known.of, wanted);
  MadeResponses made = known;
  made.of = wanted;
  made.poissonRatio = wanted.poissonRatio;
  made.isPreliminary = known.of.poissonRatio != wanted.poissonRatio;
  made.of.surface = nullptr;
  made.of.known = nullptr;
  made.tools = wanted.tools;
  made.body = scaled(known.body, wanted, factor);
  made.kernels = {};
  const auto total = static_cast<double>(wanted.names.size());
  for (std::size_t i = 0; i < wanted.names.size() && goOn(static_cast<double>(i) / total); ++i)
  {
    const std::string& name = wanted.names[i];
    made.forms[i] =
      known.forms[i] == known.body ? made.body : scaled(known.forms[i], wanted, factor);
    made.kernels.read[name] =
      makeContactBody(made.forms[i], name, made.error, *known.kernels.read.at(name), true);
  }
  for (const auto& [response, peaks] : known.kernels.peaks)
  {
    auto& to = made.kernels.peaks[response];
    to = peaks ? BodyKernels::Peaks{ factor * peaks->first, factor * peaks->second }
               : std::optional<BodyKernels::Peaks>();
  }
  made.body = made.error.empty() ? made.body : nullptr;
  return made;
}
} // namespace palpate
