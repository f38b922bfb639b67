// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawnSurface_h
#define DrawnSurface_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkPolyDataMapper;

/// What a DeflectionShader moves of a body: its triangles with their normals, its global modes, and
/// a place for the colours.
namespace palpate::DrawnSurface
{
constexpr const char* Displacement = "ContactDisplacement";
constexpr const char* Normals = "SurfaceNormals";

/// Gives a mapper the surface of a body that has passed checkTriangles.
void give(vtkPolyData* body, const std::vector<vtkDataArray*>& modes, vtkPolyDataMapper* mapper);

/// Modification times of surface and modes; they are unique: equal times, the same data.
std::vector<vtkMTimeType> timesOf(vtkPolyData* body, const std::vector<vtkDataArray*>& modes);

/// Mean length of the edges of a triangle, mm.
double edgeOf(const std::array<Vector3, 3>& corners);

/// The longest vector of any mode.
double longestOf(const std::vector<vtkDataArray*>& modes);
} // namespace palpate::DrawnSurface

#endif
