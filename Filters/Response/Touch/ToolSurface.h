// SPDX-License-Identifier: BSD-3-Clause
#ifndef ToolSurface_h
#define ToolSurface_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include <string>

class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;

/// Size of the drawn part of a tool. All members are > 0.
struct ToolSurfaceSize
{
  double length;        ///< mm
  double maximumRadius; ///< largest drawn radius of a profile that widens without end, mm
  int resolution = 64;  ///< number of facets around the axis
};

/// Creates the surface of a tool, as triangles with normals. The tip is at the origin, and the axis
/// points along +z. Returns "" or an error message.
std::string makeToolSurface(
  const AxisymmetricTool& tool, const ToolSurfaceSize& size, vtkPolyData* output);

/// Moves a surface that makeToolSurface created. Moves its tip to `tip`, and turns its axis to the
/// unit vector `axis`.
void standTool(const Vector3& tip, const Vector3& axis, vtkPolyData* surface);
} // namespace palpate

#endif
