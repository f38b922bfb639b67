// SPDX-License-Identifier: BSD-3-Clause
#ifndef ToolSurface_h
#define ToolSurface_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include <string>

class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;

/// Size of the drawn part of a tool, all > 0.
struct ToolSurfaceSize
{
  double length;        ///< mm
  double maximumRadius; ///< mm, for a profile that widens without end
  int resolution = 64;  ///< facets around the axis
};

/// Makes the surface of a tool: triangles with normals, tip at the origin, axis along +z. Returns
/// "" or an error message.
std::string makeToolSurface(
  const AxisymmetricTool& tool, const ToolSurfaceSize& size, vtkPolyData* output);

/// Moves a surface made by makeToolSurface: its tip to `tip`, its axis along the unit vector
/// `axis`.
void standTool(const Vector3& tip, const Vector3& axis, vtkPolyData* surface);
} // namespace palpate

#endif
