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

/// The data of a body that a DeflectionShader moves: its triangles with their normals, its global
/// modes, and scalars for the colours.
namespace palpate::DrawnSurface
{
constexpr const char* Displacement = "ContactDisplacement";
constexpr const char* Normals = "SurfaceNormals";

/// Gives a mapper the surface of a body that has passed checkTriangles.
void give(vtkPolyData* body, const std::vector<vtkDataArray*>& modes, vtkPolyDataMapper* mapper);

/// Modification times of surface and modes; as they are unique, equal times mean the same data.
std::vector<vtkMTimeType> timesOf(vtkPolyData* body, const std::vector<vtkDataArray*>& modes);

/// Mean length of the edges of a triangle, mm.
double edgeOf(const std::array<Vector3, 3>& corners);

/// The longest vector of any mode.
double longestOf(const std::vector<vtkDataArray*>& modes);
} // namespace palpate::DrawnSurface

namespace palpate
{
class BodyMesh;

constexpr std::size_t MostModes = 6; ///< limited by vertex attributes

/**
 * The global modes of a body as vertex attributes: per mode φ and its turn of the normal,
 * d = -(∇φ)ᵀ n, six floats, packed four by four since shaders have few attributes. A surface that
 * moves by w φ turns its normal n to n + w d, for small w.
 *
 * Adds the packed arrays to `drawn`, which has the points of `mesh`, and maps them. Later modes
 * than MostModes are left out.
 */
void addModeAttributes(const BodyMesh& mesh, const std::vector<vtkDataArray*>& modes,
  vtkPolyData* drawn, vtkPolyDataMapper* mapper);

/// GLSL: declares the attributes of the modes.
std::string modeDeclarations(int modes);
/// GLSL: adds the modes, times the weights in the array of that name, to `displacement`, and their
/// turn, times `exaggeration`, to `normal`.
std::string modeSum(int modes, const std::string& weights, const std::string& displacement,
  const std::string& normal, const std::string& exaggeration);
} // namespace palpate

#endif
