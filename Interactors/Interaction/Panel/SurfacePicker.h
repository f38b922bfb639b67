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
/// The place on a body under a pointer.
class SurfacePicker
{
public:
  SurfacePicker();
  ~SurfacePicker();
  SurfacePicker(const SurfacePicker&) = delete;
  SurfacePicker& operator=(const SurfacePicker&) = delete;

  /// The body and the prefix of the response whose normals count. Another body with the same points
  /// and cells costs nothing.
  void setBody(vtkPolyData* body, const std::string& responseName);

  /// Where the line of sight through a display position first meets the body, and the outward unit
  /// normal there. False if it passes by, or there is no normal.
  bool pick(vtkRenderer* renderer, const int position[2], double point[3], double normal[3]);

private:
  vtkWeakPointer<vtkPolyData> Given;
  vtkSmartPointer<vtkPolyData> Body; ///< a copy: the locator builds links in it
  vtkSmartPointer<vtkCellLocator> Locator;
  std::string ResponseName;
};

/// Where the line of sight through a display position is as far from the viewer as `tip`, and
/// `away` farther; and the direction against the line of sight of the camera.
void pointInView(vtkRenderer* renderer, const int position[2], const double tip[3], double away,
  double point[3], double towards[3]);
} // namespace palpate

#endif
