// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/SimplerLaw.h"

#include "Contact/ResponseSampling.h"
#include "Laws/ResponseChange.h"
#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "Response/BodyLaws.h"
#include "Response/Curves/AutomaticTerms.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr const char* LawName = "SimplerLaw";
constexpr const char* YoungName = "SimplerLawYoungsModulus";
constexpr const char* PoissonName = "SimplerLawPoissonRatio";
constexpr double StoredExponent = 1.0; // exponent of storage of a response of the true shape

vtkSmartPointer<vtkDoubleArray> pointValues(const char* name, vtkIdType count)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName(name);
  values->SetNumberOfTuples(count);
  return values;
}

/// Computes the response of the law on the surface.
std::string respondByLaw(const ElasticBody& body, vtkPolyData* surface, const SimplerLaw& law,
  int samples, vtkPolyData* output)
{
  vtkNew<vtkPolyData> given;
  given->ShallowCopy(surface);
  const vtkIdType count = surface->GetNumberOfPoints();
  const auto young = pointValues(YoungName, count);
  const auto poisson = pointValues(PoissonName, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const ElasticMaterial at = body.materialAt(body.surface().node(static_cast<std::int32_t>(i)));
    young->SetValue(i, at.youngsModulus);
    poisson->SetValue(i, at.poissonRatio);
  }
  given->GetPointData()->AddArray(young);
  given->GetPointData()->AddArray(poisson);
  LawRequest request;
  request.tool = law.tool;
  request.responseName = LawName;
  request.deflection = law.deflection;
  request.material = { 1.0, 0.3, law.thickness, LayerBase::Bonded, false };
  request.arrays = materialArrays(given, { YoungName, law.thicknesses, "", PoissonName, "" });
  request.samples = samples;
  request.terms.errorTolerance = 0.0;
  std::string warning; // not used, because points without a law keep their curves
  return attachResponse(Ranks(), given, request, {}, output, warning);
}

/// The curves of the law, sampled at the depths of the curves of the true shape.
class ResampledLaw
{
public:
  ResampledLaw(const ResponseArrays& law, const ResponseSpans& shaped)
    : Law(law)
    , Shaped(shaped)
    , Force(static_cast<std::size_t>(law.samples) * law.points)
    , Stiffness(this->Force.size())
    , Status(law.status, law.status + law.points)
  {
  }

  ResponseSpans spans()
  {
    return { this->Law.samples, this->Force.data(), this->Stiffness.data(), this->Shaped.range,
      this->Shaped.validity, this->Status.data(), this->Shaped.limit };
  }

  void sample(std::size_t i)
  {
    const auto n = static_cast<std::size_t>(this->Law.samples);
    const ResponseSampling own(this->Law.samples, this->Law.exponent);
    const ResponseSampling stored(this->Law.samples, StoredExponent);
    const FloatCurve samples{ this->Law.force + n * i, this->Law.stiffness + n * i };
    for (std::size_t k = 0; k < n; ++k)
    {
      const double depth =
        stored.depth(static_cast<int>(k), static_cast<double>(this->Shaped.range[i]));
      const ResponseValue value =
        own.evaluate(samples, static_cast<double>(this->Law.range[i]), depth);
      this->Force[n * i + k] = static_cast<float>(value.force);
      this->Stiffness[n * i + k] = static_cast<float>(value.stiffness);
    }
  }

private:
  ResponseArrays Law;
  ResponseSpans Shaped;
  std::vector<float> Force;
  std::vector<float> Stiffness;
  std::vector<unsigned char> Status;
};

std::string describe(
  const SimplerLaw& law, std::vector<double> changes, std::size_t kept, std::size_t points)
{
  const bool isLayer = law.thickness > 0.0 || !law.thicknesses.empty();
  const char* model = isLayer ? "a layer's" : "a half-space's";
  if (changes.empty())
  {
    return joined("no point has both true shape and ", model, " law: true shape is kept");
  }
  std::sort(changes.begin(), changes.end());
  return joined("true shape changes the force by ", percentOf(changes[changes.size() / 2]),
    " at the middle one of ", changes.size(), " points, by up to ", percentOf(changes.back()),
    "; where it is no more than ", percentOf(law.tolerance), ", ", model, " law is kept: at ", kept,
    " of ", points, " points");
}
} // namespace

std::string keepSimplerLaw(const ElasticBody& body, vtkPolyData* surface, const SimplerLaw& law,
  ResponseStorage& storage, vtkFloatArray* change, std::string& reason)
{
  const ResponseSpans shaped = storage.spans();
  vtkNew<vtkPolyData> answer;
  std::string fault = respondByLaw(body, surface, law, shaped.samples, answer);
  ResponseArrays arrays;
  if (!fault.empty() || !viewResponse(answer, LawName, arrays, fault))
  {
    return fault;
  }
  ResampledLaw resampled(arrays, shaped);
  const ResponseSpans other = resampled.spans();
  const auto n = static_cast<std::size_t>(shaped.samples);
  change->SetNumberOfComponents(1);
  change->SetNumberOfTuples(static_cast<vtkIdType>(arrays.points));
  std::vector<double> changes;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < arrays.points; ++i)
  {
    resampled.sample(i);
    const double found = largestChange(shaped, other, i, law.deflection, false).force;
    change->SetValue(static_cast<vtkIdType>(i), static_cast<float>(found));
    if (std::isnan(found))
    {
      continue;
    }
    changes.push_back(std::abs(found));
    if (std::abs(found) <= law.tolerance)
    {
      ++kept;
      std::copy_n(other.force + n * i, n, shaped.force + n * i);
      std::copy_n(other.stiffness + n * i, n, shaped.stiffness + n * i);
    }
  }
  reason = describe(law, std::move(changes), kept, arrays.points);
  return {};
}
} // namespace palpate
