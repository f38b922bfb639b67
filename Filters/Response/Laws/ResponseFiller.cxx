// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseFiller.h"

#include "AxisymmetricTool.h"
#include "ResponseField.h"
#include "ResponseLimit.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace palpate
{
namespace
{
constexpr double StrainRatio = 0.4; // a/R: about 8 % strain (Tabor's 0.2 a/R)
constexpr double NormalTurn = 0.2;  // rad the body's normal may turn under the contact radius
// Of a layer's thickness: finite elements with finite strain (Data/Studies/calculix, nu = 0.45) lie
// 4 % above the linear layer there, 10 % at 0.4.
constexpr double Compression = 0.2;
constexpr auto Valid = static_cast<unsigned char>(ResponseStatus::Valid);
constexpr auto NoLimit = static_cast<unsigned char>(ResponseLimit::None);

void allocate(vtkDataArray* array, const std::string& name, int components, vtkIdType tuples)
{
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
}
} // namespace

ResponseStorage::ResponseStorage(const std::string& name, vtkIdType points, int samples)
{
  allocate(this->Force.Get(), name + "Force", samples, points);
  allocate(this->Stiffness.Get(), name + "Stiffness", samples, points);
  allocate(this->Normal.Get(), name + "Normal", 3, points);
  allocate(this->Range.Get(), name + "Range", 1, points);
  allocate(this->Validity.Get(), name + "Validity", 1, points);
  allocate(this->Status.Get(), name + "Status", 1, points);
  allocate(this->LimitReached.Get(), name + "Limit", 1, points);
}

void ResponseStorage::attach(vtkPolyData* output)
{
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ this->Force, this->Stiffness,
         this->Normal, this->Range, this->Validity, this->Status, this->LimitReached })
  {
    output->GetPointData()->AddArray(array);
  }
}

ResponseFiller::ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law,
  const CurvatureBound& curvature, const ResponseMaterial& material, double range, double bodyWidth,
  ResponseStorage& storage)
  : Tool(tool)
  , Law(law)
  , Curvature(curvature)
  , Material(material)
  , StrainDepth(tool.depthAtStrain(StrainRatio))
  , StrainRadius(std::isfinite(this->StrainDepth) ? tool.contactRadius(this->StrainDepth) : 0.0)
  , HalfWidth(0.5 * bodyWidth)
  , WidthDepth(tool.depthAtContactRadius(this->HalfWidth))
  , Range(static_cast<float>(range))
  , Samples(storage.Force->GetNumberOfComponents())
  , Force(storage.Force->GetPointer(0))
  , Stiffness(storage.Stiffness->GetPointer(0))
  , RangeOf(storage.Range->GetPointer(0))
  , Validity(storage.Validity->GetPointer(0))
  , Status(storage.Status->GetPointer(0))
  , LimitReached(storage.LimitReached->GetPointer(0))
{
}

void ResponseFiller::fill(vtkIdType first, vtkIdType last) const
{
  for (vtkIdType i = first; i < last; ++i)
  {
    const double curvature = static_cast<double>(this->Curvature.at(i));
    const ContactSpot spot = this->Material.at(i);
    this->RangeOf[i] = this->Range;
    this->Status[i] = this->fillCurve(i, curvature, spot);
    this->fillValidity(i, curvature, spot);
  }
}

/// Returns the status of the point.
unsigned char ResponseFiller::fillCurve(
  vtkIdType i, double curvature, const ContactSpot& spot) const
{
  float* force = this->Force + this->Samples * i;
  float* stiffness = this->Stiffness + this->Samples * i;
  if (this->Status[i] != Valid || curvature < 0.0)
  {
    std::fill_n(force, this->Samples, 0.0F);
    std::fill_n(stiffness, this->Samples, 0.0F);
    return this->Status[i] != Valid ? this->Status[i]
                                    : static_cast<unsigned char>(ResponseStatus::Degenerate);
  }
  return static_cast<unsigned char>(this->Law.sample(spot, force, stiffness));
}

void ResponseFiller::fillValidity(vtkIdType i, double curvature, const ContactSpot& spot) const
{
  if (this->Status[i] != Valid)
  {
    this->Validity[i] = 0.0F;
    this->LimitReached[i] = NoLimit;
    return;
  }
  double depth = std::numeric_limits<double>::infinity();
  ResponseLimit limit = ResponseLimit::None;
  const auto consider = [&](double other, ResponseLimit because)
  {
    if (other < depth)
    {
      depth = other;
      limit = because;
    }
  };
  const bool layer = spot.thickness > 0.0;
  // A flat end has its full contact radius from the start: only its depth says how far it strains.
  const bool widens = this->StrainRadius > this->Tool.smallestContactRadius();
  consider(layer && widens ? this->Law.deflectionAtContactRadius(spot, this->StrainRadius)
                           : this->Law.totalDeflection(spot, this->StrainDepth),
    ResponseLimit::Strain);
  if (curvature > 0.0)
  {
    consider(
      this->Law.deflectionAtContactRadius(spot, NormalTurn / curvature), ResponseLimit::Curvature);
  }
  if (!(widens && this->StrainRadius < this->HalfWidth))
  {
    consider(layer ? this->Law.deflectionAtContactRadius(spot, this->HalfWidth)
                   : this->Law.totalDeflection(spot, this->WidthDepth),
      ResponseLimit::Edge);
  }
  if (layer)
  {
    consider(
      this->Law.totalDeflection(spot, Compression * spot.thickness), ResponseLimit::Thickness);
  }
  const bool within = depth < static_cast<double>(this->Range);
  this->Validity[i] = within ? static_cast<float>(depth) : this->Range;
  this->LimitReached[i] = within ? static_cast<unsigned char>(limit) : NoLimit;
}
} // namespace palpate
