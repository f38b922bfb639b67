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
  vtkSmartPointer<vtkPolyData> surface; ///< has no arrays; points at the same place are merged
  double volume = 0.0;                  ///< mm³
  double area = 0.0;                    ///< mm²
  /// Whether the surface is open or touches itself; `surface` is then set but cannot be filled.
  bool isOpen = false;
};

/// Makes a closed surface of a body. Returns "", or a message about the fault: the body has no
/// triangles, or its surface is open or inside out.
std::string takeClosedSurface(vtkPolyData* body, ClosedSurface& closed);

/// A side of the bounding box that holds the body.
struct HeldFace
{
  double depth = 0.0;   ///< depth of the held part below the outermost point, mm; 0: not held
  bool isGiven = false; ///< the depth was given by the user
};

/// The sides in the order -x, +x, -y, +y, -z, +z.
using HeldFaces = std::array<HeldFace, 6>;

/// Reads a text such as "z-, x+:2.5": sides, each with an optional depth (mm). The default of the
/// depth is `usual` (mm). Returns "", or a message about the fault.
std::string readHeldFaces(const std::string& text, double usual, HeldFaces& faces);

/// Makes the array `Fixed` of the points of a body: 7 for held points, 0 elsewhere. A face with a
/// given depth holds all points within that depth. A face with the usual depth holds only the
/// surface: the corners of outer faces within that depth whose normal is less than 45° from the
/// normal of the side.
vtkSmartPointer<vtkUnsignedCharArray> holdFaces(vtkUnstructuredGrid* body, const HeldFaces& faces);
} // namespace palpate

#endif
