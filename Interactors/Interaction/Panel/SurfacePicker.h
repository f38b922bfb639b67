// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfacePicker_h
#define SurfacePicker_h

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkRenderer;
class vtkCellLocator;

namespace palpate
{
/// Finds the point of a body under the mouse pointer.
class SurfacePicker
{
public:
  SurfacePicker();
  ~SurfacePicker();
  SurfacePicker(const SurfacePicker&) = delete;
  SurfacePicker& operator=(const SurfacePicker&) = delete;

  /// Sets the body, and the prefix of the response whose normals are used. The locator is rebuilt
  /// only if the points or cells differ.
  void setBody(vtkPolyData* body, const std::string& responseName);

  /// Finds the first intersection of the body with the line of sight through a display position,
  /// and the outward unit normal there. Returns false if there is no intersection or no normal.
  bool pick(vtkRenderer* renderer, const int position[2], double point[3], double normal[3]);

private:
  vtkWeakPointer<vtkPolyData> GivenBody;
  vtkSmartPointer<vtkPolyData> Body; ///< a copy, because the locator builds links in it
  vtkSmartPointer<vtkCellLocator> Locator;
  std::string ResponseName;
};

/// Returns a point on the line of sight through a display position. The distance of the point from
/// the viewer is that of `tip` plus `away` (mm). `towards` is set to the direction opposite to the
/// camera's line of sight.
void pointInView(vtkRenderer* renderer, const int position[2], const double tip[3], double away,
  double point[3], double towards[3]);
} // namespace palpate

#endif
