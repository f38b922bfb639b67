// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Laws/BodyMaterial.h"
#include "Mechanics/Coupling/CouplingLaw.h"
#include "Mechanics/Layers/LayerKernel.h"
#include "Response/ArrayFetch.h"
#include "Response/BodyConversion.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace palpate
{
namespace
{
constexpr int Components = componentsOf(contractOf(ResponseArray::Coupling), 0, 0);
static_assert(sizeof(CouplingKnot) == Components * sizeof(double), "knots are read as tuples");

void addPointValues(vtkPolyData* body, const std::string& name, ResponseArray which, int components,
  const std::function<float(vtkIdType)>& value)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(arrayName(name, which).c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(body->GetNumberOfPoints());
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, value(i));
  }
  body->GetPointData()->AddArray(array);
}

void addLaw(vtkPolyData* body, const std::string& name, const CouplingTerms& terms)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(arrayName(name, ResponseArray::Coupling).c_str());
  array->SetNumberOfComponents(Components);
  array->InsertNextTuple3(terms.modulus, terms.thickness, 0.0);
  for (int k = 0; terms.knots && k < CouplingLaw::KnotCount; ++k)
  {
    array->InsertNextTuple3(terms.knots[k].share, terms.knots[k].slope, terms.knots[k].ratio);
  }
  body->GetFieldData()->AddArray(array);
}

/// Returns the law of the layers for the mean of the smallest and the largest Poisson's ratio. For
/// a half-space, returns the default law.
CouplingLaw lawOf(const MaterialRange& range)
{
  if (!range.hasLayers())
  {
    return CouplingLaw();
  }
  return range.hasStack()
    ? CouplingLaw(LayerKernel(range.stack))
    : CouplingLaw(LayerKernel(0.5 * (range.leastRatio + range.mostRatio), range.layers.base));
}

/// Attaches the modes. The modes are scaled down where their compliance would exceed a limit. The
/// limit is the global compliance of the response plus the fraction 1 - 2/π = 0.36 of the local
/// compliance 1/(2E*a) at the last sample. The law of the surface does not use this fraction. With
/// this limit, the compliance matrix of all contacts is positive definite at any depths.
void addModes(
  const ContactSpots& spots, const std::string& name, vtkDataArray* modes, vtkPolyData* body)
{
  constexpr double left = 0.36;
  vtkDataArray* stiffness =
    body->GetPointData()->GetArray(arrayName(name, ResponseArray::Stiffness).c_str());
  const int count = modes->GetNumberOfComponents();
  const int last = stiffness->GetNumberOfComponents() - 1;
  vtkIdType at = -1;
  double factor = 0.0;
  addPointValues(body, name, ResponseArray::CouplingModes, count,
    [&](vtkIdType i)
    {
      if (i / count != at)
      {
        at = i / count;
        double sum = 0.0;
        for (int m = 0; m < count; ++m)
        {
          sum += modes->GetComponent(at, m) * modes->GetComponent(at, m);
        }
        const double own = spots.at(static_cast<std::size_t>(at)).compliance;
        const double whole = stiffness->GetComponent(at, last);
        const double local = whole > 0.0 ? std::max(0.0, 1.0 / whole - own) : 0.0;
        const double most = std::max(0.0, own + left * local);
        factor = sum > most ? std::sqrt(most / sum) : 1.0;
      }
      return static_cast<float>(factor * modes->GetComponent(at, static_cast<int>(i % count)));
    });
}

/// Finds the modes of a body. Returns "" or an error message.
std::string findModes(vtkPolyData* body, vtkDataArray*& modes)
{
  vtkAbstractArray* found = body->GetPointData()->GetAbstractArray(CouplingModesName);
  modes = vtkDataArray::SafeDownCast(found);
  if (found &&
    (!modes || modes->GetNumberOfTuples() != body->GetNumberOfPoints() ||
      modes->GetNumberOfComponents() < 1 ||
      modes->GetNumberOfComponents() > CouplingTerms::MostModes))
  {
    return joined("point array '", CouplingModesName, "' must have 1 to ", CouplingTerms::MostModes,
      " components and a tuple per point, but is ", shapeOf(found));
  }
  return {};
}

/// The interaction of contacts on one body. The arrays of the term are Coupling, CouplingModulus,
/// CouplingThickness and CouplingModes. Without these arrays, contacts do not interact.
class CouplingTerm : public LawTerm
{
public:
  bool isAsked(const LawRequest& request) const override { return request.couples; }
  std::string check(const TermBody& response, vtkPolyData* piece) const override;
  std::string make(const TermBody& response, vtkPolyData* output) const override;
  bool view(vtkPolyData* body, const std::string& name, ResponseArrays& arrays,
    std::string& error) const override;
  void describe(
    vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const override;
};
} // namespace

std::string CouplingTerm::check(const TermBody& response, vtkPolyData* piece) const
{
  if (!this->isAsked(response.request))
  {
    return {};
  }
  const BodyMaterial& material = *response.material;
  const MaterialRange& range = material.range();
  if (range.hasLayers() && range.hasHalfSpace)
  {
    return "Coupling needs layers everywhere or nowhere, but some points have a thickness of 0";
  }
  if (material.spots().second)
  {
    return "Coupling needs a second layer of one thickness, but it varies from point to point";
  }
  vtkDataArray* modes = nullptr;
  std::string fault = findModes(piece, modes);
  if (fault.empty() && modes && (material.modelParts() & GlobalCompliancePart) == 0)
  {
    fault = joined("point array '", CouplingModesName,
      "' describes the motion of the whole body, but the response has no global compliance (array "
      "to process 2), which is part of this motion");
  }
  return fault;
}

std::string CouplingTerm::make(const TermBody& response, vtkPolyData* output) const
{
  const BodyMaterial& material = *response.material;
  const std::string& name = response.request.responseName;
  const ContactSpots spots = material.spots();
  const MaterialRange& range = material.range();
  const CouplingLaw law = lawOf(range);
  CouplingTerms terms;
  terms.modulus = spots.constant.reducedModulus;
  terms.thickness = !law.isLayered() ? 0.0
    : spots.thickness                ? range.layers.thinnest
                                     : spots.constant.thickness;
  terms.knots = law.isLayered() ? law.knots().data() : nullptr;
  addLaw(output, name, terms);
  const auto spotAt = [&spots](vtkIdType i) { return spots.at(static_cast<std::size_t>(i)); };
  if (spots.reducedModulus)
  {
    addPointValues(output, name, ResponseArray::CouplingModulus, 1,
      [&](vtkIdType i) { return static_cast<float>(spotAt(i).reducedModulus); });
  }
  if (spots.thickness && law.isLayered())
  {
    addPointValues(output, name, ResponseArray::CouplingThickness, 1,
      [&](vtkIdType i) { return static_cast<float>(spotAt(i).thickness); });
  }
  vtkDataArray* modes = nullptr;
  findModes(output, modes);
  if (modes)
  {
    addModes(spots, name, modes, output);
  }
  return {};
}

void CouplingTerm::describe(
  vtkPolyData* body, const std::string& name, const ResponseArrays& arrays) const
{
  const CouplingTerms& terms = arrays.coupling;
  if (!terms.areFelt())
  {
    return;
  }
  addLaw(body, name, terms);
  const auto add = [&](ResponseArray which, const float* values, int components)
  {
    if (values)
    {
      addPointValues(body, name, which, components, [values](vtkIdType i) { return values[i]; });
    }
  };
  add(ResponseArray::CouplingModulus, terms.localModulus, 1);
  add(ResponseArray::CouplingThickness, terms.localThickness, 1);
  add(ResponseArray::CouplingModes, terms.modes, terms.modeCount);
}

bool CouplingTerm::view(
  vtkPolyData* body, const std::string& name, ResponseArrays& arrays, std::string& error) const
{
  const std::string full = arrayName(name, ResponseArray::Coupling);
  vtkAbstractArray* found = body->GetFieldData()->GetAbstractArray(full.c_str());
  const auto has = [&](ResponseArray which)
  { return body->GetPointData()->HasArray(arrayName(name, which).c_str()) != 0; };
  if (!found)
  {
    for (const ResponseArray which : { ResponseArray::CouplingModulus,
           ResponseArray::CouplingThickness, ResponseArray::CouplingModes })
    {
      if (has(which))
      {
        error =
          "field array '" + full + "' is missing, but '" + arrayName(name, which) + "' is there";
        return false;
      }
    }
    return true;
  }
  auto* law = vtkDoubleArray::FastDownCast(found);
  if (!law || law->GetNumberOfComponents() != Components ||
    (law->GetNumberOfTuples() != 1 && law->GetNumberOfTuples() != 1 + CouplingLaw::KnotCount))
  {
    error = joined("field array '", full, "' must be double with ", Components,
      " components and 1 or ", 1 + CouplingLaw::KnotCount, " tuples, but is ", shapeOf(found));
    return false;
  }
  CouplingTerms& terms = arrays.coupling;
  terms.modulus = law->GetComponent(0, 0);
  terms.thickness = law->GetComponent(0, 1);
  terms.knots = law->GetNumberOfTuples() > 1
    ? reinterpret_cast<const CouplingKnot*>(law->GetPointer(Components))
    : nullptr;
  if (has(ResponseArray::CouplingModes))
  {
    terms.modeCount = body->GetPointData()
                        ->GetAbstractArray(arrayName(name, ResponseArray::CouplingModes).c_str())
                        ->GetNumberOfComponents();
  }
  const auto fetch = [&](ResponseArray which, const float*& values)
  {
    values = has(which) ? fetchArray<vtkFloatArray>(body, name, which, arrays, error) : nullptr;
    return !has(which) || values;
  };
  if (!fetch(ResponseArray::CouplingModulus, terms.localModulus) ||
    !fetch(ResponseArray::CouplingThickness, terms.localThickness) ||
    !fetch(ResponseArray::CouplingModes, terms.modes))
  {
    return false;
  }
  error = faultOfCoupling(terms, arrays.points);
  if (!error.empty())
  {
    error = "coupling of response '" + name + "': " + error;
  }
  return error.empty();
}

const LawTerm& couplingTerm()
{
  static const CouplingTerm term;
  return term;
}
} // namespace palpate
