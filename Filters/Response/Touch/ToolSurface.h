// SPDX-License-Identifier: BSD-3-Clause
#ifndef ToolSurface_h
#define ToolSurface_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include <string>

class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;

/// How much of a tool is drawn, > 0.
struct ToolSurfaceSize
{
  double length;        ///< mm
  double maximumRadius; ///< mm, where the profile widens without end
  int resolution = 64;  ///< facets around
};

/// The surface of a tool: triangles with normals, tip at the origin, axis along +z. What is wrong,
/// or "".
std::string makeToolSurface(
  const AxisymmetricTool& tool, const ToolSurfaceSize& size, vtkPolyData* output);

/// Moves such a surface so that its tip is at `tip` and its axis along the unit vector `axis`.
void standTool(const Vector3& tip, const Vector3& axis, vtkPolyData* surface);
} // namespace palpate

#endif
