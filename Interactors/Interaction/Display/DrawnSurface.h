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

/// Makes the input of the mapper whose vertices a DeflectionShader moves: the body's triangles with
/// normals, its global modes, and scalars for the colours.
namespace palpate::DrawnSurface
{
constexpr const char* Displacement = "ContactDisplacement";
constexpr const char* Normals = "SurfaceNormals";

/// Sets the surface of a body as the input of a mapper. The body must have passed checkTriangles.
void give(vtkPolyData* body, const std::vector<vtkDataArray*>& modes, vtkPolyDataMapper* mapper);

/// Returns the modification times of the surface and of the modes. Modification times are unique.
/// Therefore equal times mean equal data.
std::vector<vtkMTimeType> timesOf(vtkPolyData* body, const std::vector<vtkDataArray*>& modes);

/// Mean length of the edges of a triangle, mm.
double edgeOf(const std::array<Vector3, 3>& corners);

/// Length of the longest vector of all modes.
double longestOf(const std::vector<vtkDataArray*>& modes);
} // namespace palpate::DrawnSurface

namespace palpate
{
class BodyMesh;

constexpr std::size_t MostModes = 6; ///< limited by the number of vertex attributes

/**
 * Passes the global modes of a body as vertex attributes. The data of a mode are its displacement φ
 * and the change of the normal, d = -(∇φ)ᵀ n: six floats. Each attribute contains four of these
 * floats, because shaders have few attributes. If the surface moves by w φ with a small weight w,
 * its normal changes from n to n + w d.
 *
 * Adds the packed arrays to `drawn`, which must have the points of `mesh`, and maps them. Modes
 * after the first MostModes are left out.
 */
void addModeAttributes(const BodyMesh& mesh, const std::vector<vtkDataArray*>& modes,
  vtkPolyData* drawn, vtkPolyDataMapper* mapper);

/// Returns GLSL that declares the attributes of the modes.
std::string modeDeclarations(int modes);
/// Returns GLSL that adds the modes times their weights to `displacement`. It also adds the changes
/// of the normal, times the weights and `exaggeration`, to `normal`. All parameters but `modes` are
/// GLSL expressions; `weights` is the name of the array of weights.
std::string modeSum(int modes, const std::string& weights, const std::string& displacement,
  const std::string& normal, const std::string& exaggeration);
} // namespace palpate

#endif
