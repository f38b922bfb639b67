// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ClosedSurface_h
#define palpate_ClosedSurface_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkPolyData;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace palpate
{
/// A surface that can be filled: its merged points, its volume and its area.
struct ClosedSurface
{
  /// Surface without arrays; points at the same position are merged.
  vtkSmartPointer<vtkPolyData> surface;
  double volume = 0.0; ///< mm³
  double area = 0.0;   ///< mm²
  /// Whether the surface is open or touches itself. In this case `surface` is set but cannot be
  /// filled.
  bool isOpen = false;
};

/// Creates a closed surface from a body. Returns "" or an error message. It is an error if the body
/// has no triangles, or if its surface is open or inside out.
std::string takeClosedSurface(vtkPolyData* body, ClosedSurface& closed);

/// A side of the bounding box at which the body is held.
struct HeldFace
{
  /// Depth of the held part below the outermost point, mm. 0 means that the body is not held at
  /// this side.
  double depth = 0.0;
  bool isGiven = false; ///< whether the user specified the depth
};

/// The sides in the order -x, +x, -y, +y, -z, +z.
using HeldFaces = std::array<HeldFace, 6>;

/// Reads a text such as "z-, x+:2.5" with sides, each with an optional depth (mm). `usual` (mm) is
/// the default of the depth. Returns "" or an error message.
std::string readHeldFaces(const std::string& text, double usual, HeldFaces& faces);

/// Creates the array `Fixed` of the points of a body: 7 for held points, 0 for all others. If the
/// user specified the depth of a side, all points within this depth are held. Otherwise only the
/// surface is held: the corners of outer faces within the default depth whose normal differs by
/// less than 45° from the normal of the side.
vtkSmartPointer<vtkUnsignedCharArray> holdFaces(vtkUnstructuredGrid* body, const HeldFaces& faces);
} // namespace palpate

#endif
