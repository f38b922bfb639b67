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
/// Finds out whether a place belongs to the held part of a solid: its closest place on the surface
/// must be on held points.
class HeldPlaces
{
public:
  /// `surface` must consist of triangles. `isHeld`: whether a point of `surface` is held.
  HeldPlaces(vtkPolyData* surface, std::function<bool(vtkIdType)> isHeld);

  /// Whether the closest place of the surface is a held point or between held points. False for a
  /// place that is not finite. Safe from any number of threads.
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
