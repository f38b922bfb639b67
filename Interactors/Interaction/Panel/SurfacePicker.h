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

/// World point under a display position, at a depth of the view volume from 0 (near) to 1 (far).
void worldUnder(vtkRenderer* renderer, const int position[2], double depth, double world[3]);
} // namespace palpate

#endif
