// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_MadeScan_h
#define palpate_testing_MadeScan_h

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkNew.h"
#include "vtkShortArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <functional>

/// Scans with known grey values.
namespace palpate::testing
{
constexpr double Air = 2.0;
constexpr double Bone = 18.0;
constexpr double Muscle = 60.0;
constexpr double Fat = 120.0;
constexpr double Blur = 2.0; // mm, width of an edge in the scan: two voxels

/// A scan of grey(x, y, z), stored as shorts as in MRI.
using Grey = std::function<double(const double[3])>;
inline vtkSmartPointer<vtkImageData> scanOf(const Grey& grey, double half, double spacing = 1.0)
{
  auto scan = vtkSmartPointer<vtkImageData>::New();
  const int size = 2 * static_cast<int>(std::ceil(half / spacing)) + 1;
  scan->SetDimensions(size, size, size);
  scan->SetSpacing(spacing, spacing, spacing);
  const double origin = -0.5 * spacing * (size - 1) + 0.3; // no voxel is in the middle
  scan->SetOrigin(origin, origin, origin);
  vtkNew<vtkShortArray> values;
  values->SetName("Grey");
  values->SetNumberOfTuples(scan->GetNumberOfPoints());
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    double x[3];
    scan->GetPoint(i, x);
    values->SetValue(i, static_cast<short>(std::lround(grey(x))));
  }
  scan->GetPointData()->SetScalars(values);
  return scan;
}

/// From `low` to `high` across a blurred edge at 0.
inline double edge(double x, double low, double high)
{
  return low + (high - low) * std::clamp(x / Blur + 0.5, 0.0, 1.0);
}
} // namespace palpate::testing

#endif
