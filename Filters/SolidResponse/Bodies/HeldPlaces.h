// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HeldPlaces_h
#define palpate_HeldPlaces_h

#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <Eigen/Core>

#include <functional>

class vtkPolyData;
class vtkStaticCellLocator;
class vtkStaticPointLocator;

namespace palpate
{
/// Determines whether a position belongs to the held part of a solid. It does if its closest
/// position on the surface is at or between held points.
class HeldPlaces
{
public:
  /// `surface` must consist of triangles. `isHeld` returns whether a point of `surface` is held.
  HeldPlaces(vtkPolyData* surface, std::function<bool(vtkIdType)> isHeld);

  /// Returns whether the closest position on the surface is a held point or between held points.
  /// Returns false if `place` is not finite. Thread-safe.
  bool contain(const double place[3]) const;

private:
  bool isFar(const Eigen::Vector3d& place) const;

  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkStaticCellLocator> Locator;
  vtkSmartPointer<vtkStaticPointLocator> Points;
  vtkBoundingBox Held; ///< bounding box of the held points
  std::function<bool(vtkIdType)> IsHeld;
};
} // namespace palpate

#endif
