// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/StoredError.h"

#include "Contact/ResponseContract.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate
{
double storedError(
  vtkPolyData* body, const std::string& responseName, vtkIdType point, double depth)
{
  const auto array = [&](ResponseArray which)
  {
    return vtkFloatArray::SafeDownCast(
      body->GetPointData()->GetArray(arrayName(responseName, which).c_str()));
  };
  vtkFloatArray* errors = array(ResponseArray::Error);
  vtkFloatArray* range = array(ResponseArray::Range);
  if (!errors || !range || !(depth <= static_cast<double>(range->GetValue(point))))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int samples = errors->GetNumberOfComponents();
  const double root = std::sqrt(std::max(depth, 0.0) / static_cast<double>(range->GetValue(point)));
  const double place = std::max(0.0, root * samples - 1.0);
  const int below = std::min(static_cast<int>(place), samples - 1);
  const int above = std::min(below + 1, samples - 1);
  const double error = errors->GetComponent(point, below);
  return error + (place - below) * (errors->GetComponent(point, above) - error);
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
  return percent < 99.5 ? std::string(" \u00b1 ") + text.data() : " (nothing bounds its error)";
}
} // namespace palpate
