// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/StoredError.h"

#include "Contact/ResponseContract.h"
#include "Contact/TriangleProjection.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate
{
double errorBetween(const float* errors, int samples, double range, double depth)
{
  if (!(depth <= range))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double root = std::sqrt(std::max(depth, 0.0) / range);
  const double place = std::max(0.0, root * samples - 1.0);
  const int below = std::min(static_cast<int>(place), samples - 1);
  const int above = std::min(below + 1, samples - 1);
  const auto error = static_cast<double>(errors[below]);
  return error + (place - below) * (static_cast<double>(errors[above]) - error);
}

StoredError::StoredError(vtkPolyData* body, const std::string& responseName)
  : Body(body)
{
  const auto array = [&](ResponseArray which)
  {
    return vtkFloatArray::SafeDownCast(
      body->GetPointData()->GetArray(arrayName(responseName, which).c_str()));
  };
  this->Errors = array(ResponseArray::Error);
  this->Range = array(ResponseArray::Range);
  this->Errors = this->Range ? this->Errors : nullptr;
}

double StoredError::at(vtkIdType point, double depth) const
{
  if (!this->isKept())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int samples = this->Errors->GetNumberOfComponents();
  return errorBetween(this->Errors->GetPointer(point * samples), samples,
    static_cast<double>(this->Range->GetValue(point)), depth);
}

double StoredError::at(vtkIdType cell, const double* point, double depth) const
{
  std::array<vtkIdType, 3> ids{};
  std::array<Vector3, 3> x;
  const vtkIdType first = this->Body->GetNumberOfVerts() + this->Body->GetNumberOfLines();
  vtkNew<vtkIdList> corners; // a local list, because several threads may read the body
  this->Body->GetPolys()->GetCellAtId(cell - first, corners);
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    ids[k] = corners->GetId(static_cast<vtkIdType>(k));
    this->Body->GetPoint(ids[k], x[k].data());
  }
  const Vector3 weights = projectOnTriangle(Vector3(point), x[0], x[1], x[2]).weights;
  double error = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    const double weight = weights[static_cast<Eigen::Index>(k)];
    error += weight > 0.0 ? weight * this->at(ids[k], depth) : 0.0;
  }
  return error;
}

void addContactErrors(vtkPolyData* body, const std::string& responseName, vtkPolyData* tips,
  const std::vector<double>& others)
{
  const StoredError stored(body, responseName);
  vtkPointData* data = tips->GetPointData();
  auto* cells = vtkIdTypeArray::SafeDownCast(data->GetArray("ContactCell"));
  auto* places = vtkDoubleArray::SafeDownCast(data->GetArray("ContactPoint"));
  auto* depths = vtkDoubleArray::SafeDownCast(data->GetArray("Deflection"));
  if (!stored.isKept() || !cells || !places || !depths)
  {
    return;
  }
  vtkNew<vtkDoubleArray> errors;
  errors->SetName("RelativeError");
  errors->SetNumberOfValues(tips->GetNumberOfPoints());
  vtkSMPTools::For(0, tips->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType tip = begin; tip < end; ++tip)
      {
        const vtkIdType cell = cells->GetValue(tip);
        const double other = others.empty() ? 0.0 : others[static_cast<std::size_t>(tip)];
        errors->SetValue(tip,
          cell < 0 ? 0.0
                   : other + stored.at(cell, places->GetPointer(3 * tip), depths->GetValue(tip)));
      }
    });
  data->AddArray(errors);
}

std::string errorInWords(double relativeError)
{
  const double percent = 100.0 * relativeError;
  if (std::isnan(percent))
  {
    return "";
  }
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), percent < 1.0 ? "%.1f %%" : "%.0f %%", percent);
  return percent < 99.5 ? std::string(" \u00b1 ") + text.data() : " (its error has no bound)";
}
} // namespace palpate
