// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawnSurface_h
#define DrawnSurface_h

#include "Contact/TriangleProjection.h" // For palpate::Vector3

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkPolyDataMapper;

/// Data of a body that a DeflectionShader moves: its triangles with normals, its global modes, and
/// scalars for the colours.
namespace palpate::DrawnSurface
{
constexpr const char* Displacement = "ContactDisplacement";
constexpr const char* Normals = "SurfaceNormals";

/// Sets the surface of a body as input of a mapper. The body must have passed checkTriangles.
void give(vtkPolyData* body, const std::vector<vtkDataArray*>& modes, vtkPolyDataMapper* mapper);

/// Modification times of the surface and the modes. They are unique, so equal times mean the same
/// data.
std::vector<vtkMTimeType> timesOf(vtkPolyData* body, const std::vector<vtkDataArray*>& modes);

/// Mean length of the edges of a triangle, mm.
double edgeOf(const std::array<Vector3, 3>& corners);

/// Length of the longest vector in any mode.
double longestOf(const std::vector<vtkDataArray*>& modes);
} // namespace palpate::DrawnSurface

namespace palpate
{
class BodyMesh;

constexpr std::size_t MostModes = 6; ///< limited by vertex attributes

/**
 * Passes the global modes of a body as vertex attributes. A mode has the displacement φ and its
 * turn of the normal, d = -(∇φ)ᵀ n: six floats. They are packed four per attribute, since shaders
 * have few attributes. A surface that moves by w φ turns its normal n to n + w d, for small w.
 *
 * Adds the packed arrays to `drawn`, which has the points of `mesh`, and maps them. Modes after the
 * first MostModes are left out.
 */
void addModeAttributes(const BodyMesh& mesh, const std::vector<vtkDataArray*>& modes,
  vtkPolyData* drawn, vtkPolyDataMapper* mapper);

/// GLSL that declares the attributes of the modes.
std::string modeDeclarations(int modes);
/// GLSL that adds the modes, multiplied by the weights in the array named `weights`, to
/// `displacement`, and their turns, multiplied by `exaggeration`, to `normal`.
std::string modeSum(int modes, const std::string& weights, const std::string& displacement,
  const std::string& normal, const std::string& exaggeration);
} // namespace palpate

#endif
