// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredResponse/MeasuredMaterial.h"

#include "Response/BodyConversion.h"
#include "Laws/DataEnd.h"
#include "Contact/ResponseContract.h"
#include "Contact/ResponseSampling.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
constexpr auto OutOfReach = static_cast<unsigned char>(ResponseStatus::OutOfReach);
constexpr auto DataEndLimit = static_cast<unsigned char>(ResponseLimit::DataEnd);
constexpr double PlaceholderModulus = 1.0; // Young's modulus, MPa, for points without a response

vtkSmartPointer<vtkDoubleArray> addPointArray(vtkPolyData* body, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(body->GetNumberOfPoints());
  body->GetPointData()->AddArray(array);
  return array;
}
} // namespace

void spreadMaterial(vtkPolyData* body, double poissonRatio, double reach,
  SiteMeasurement& measurement, vtkPolyData* spread)
{
  std::vector<SiteAnchor> anchors;
  for (std::size_t i = 0; i < measurement.Sites.size(); ++i)
  {
    if (measurement.Sites[i].measured.refusal.empty())
    {
      anchors.push_back(measurement.Anchors[i]);
      measurement.Used.push_back(&measurement.Sites[i].measured.body);
    }
  }
  measurement.Spread = std::make_unique<SiteSpread>(*measurement.Mesh, anchors, reach);

  std::vector<double> moduli;
  std::vector<double> compliances;
  std::vector<double> slenderness; // 1/h, 1/mm; 0 on a half-space
  for (const IdentifiedBody* site : measurement.Used)
  {
    moduli.push_back(site->body.reducedModulus);
    compliances.push_back(site->body.compliance);
    slenderness.push_back(site->body.thickness > 0.0 ? 1.0 / site->body.thickness : 0.0);
  }
  spread->ShallowCopy(body);
  const auto modulus = addPointArray(spread, MeasuredMaterial::ModulusArray);
  const auto compliance = addPointArray(spread, MeasuredMaterial::ComplianceArray);
  const auto thickness = addPointArray(spread, MeasuredMaterial::ThicknessArray);
  const auto young = addPointArray(spread, MeasuredMaterial::YoungArray);
  const double plane = 1.0 - poissonRatio * poissonRatio;
  vtkSMPTools::For(0, body->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        const bool reached = measurement.Spread->reaches(point);
        const double e = reached ? measurement.Spread->at(point, moduli) : 0.0;
        const double inverse = reached ? measurement.Spread->at(point, slenderness) : 0.0;
        modulus->SetValue(i, e);
        young->SetValue(i, plane * (reached ? e : PlaceholderModulus));
        compliance->SetValue(i, reached ? measurement.Spread->at(point, compliances) : 0.0);
        thickness->SetValue(i, inverse > 0.0 ? 1.0 / inverse : 0.0);
      }
    });
}

void limitToData(
  const SiteMeasurement& measurement, const std::string& name, double range, vtkPolyData* output)
{
  const auto array = [&](ResponseArray which)
  { return output->GetPointData()->GetArray(arrayName(name, which).c_str()); };
  auto* force = vtkFloatArray::SafeDownCast(array(ResponseArray::Force));
  auto* stiffness = vtkFloatArray::SafeDownCast(array(ResponseArray::Stiffness));
  auto* validity = vtkFloatArray::SafeDownCast(array(ResponseArray::Validity));
  auto* status = vtkUnsignedCharArray::SafeDownCast(array(ResponseArray::Status));
  auto* limit = vtkUnsignedCharArray::SafeDownCast(array(ResponseArray::Limit));
  // Null if the error is not stored.
  auto* error = vtkFloatArray::SafeDownCast(array(ResponseArray::Error));
  const int n = force->GetNumberOfComponents();
  const double exponent = output->GetFieldData()
                            ->GetArray(arrayName(name, ResponseArray::Exponent).c_str())
                            ->GetTuple1(0);
  const ResponseSampling sampling(n, exponent);
  const std::vector<double> forces = measurement.collect(&IdentifiedBody::endForce);
  const std::vector<double> stiffnesses = measurement.collect(&IdentifiedBody::endStiffness);
  vtkSMPTools::For(0, output->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        float* f = force->GetPointer(n * i);
        float* k = stiffness->GetPointer(n * i);
        if (!measurement.Spread->reaches(point))
        {
          std::fill_n(f, n, 0.0F);
          std::fill_n(k, n, 0.0F);
          if (error)
          {
            std::fill_n(error->GetPointer(n * i), n, std::numeric_limits<float>::quiet_NaN());
          }
          status->SetValue(i, status->GetValue(i) == 0 ? OutOfReach : status->GetValue(i));
          validity->SetValue(i, 0.0F);
          limit->SetValue(i, 0);
        }
        else if (status->GetValue(i) == 0)
        {
          const double depth = depthOfDataEnd(sampling, range, f, k,
            { measurement.Spread->at(point, forces), measurement.Spread->at(point, stiffnesses) });
          if (depth < static_cast<double>(validity->GetValue(i)))
          {
            validity->SetValue(i, static_cast<float>(depth));
            limit->SetValue(i, DataEndLimit);
          }
        }
      }
    });
  describeModel(output, name, { measurement.describe(), measurement.modelParts() });
}
} // namespace palpate
