// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HeldPlaces_h
#define palpate_HeldPlaces_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>

class vtkPolyData;
class vtkStaticCellLocator;

namespace palpate
{
/// Tells places that belong to what is held of a solid: beside, or beyond, triangles of it that do
/// not move.
class HeldPlaces
{
public:
  /// The surface, of triangles, and which of its points are held.
  HeldPlaces(vtkPolyData* surface, std::function<bool(vtkIdType)> isHeld);

  /// Whether the closest place of the surface is a held point, or between such; never for a place
  /// that is not finite. From any number of threads.
  bool contain(const double place[3]) const;

private:
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkStaticCellLocator> Locator;
  std::function<bool(vtkIdType)> IsHeld;
};
} // namespace palpate

#endif
