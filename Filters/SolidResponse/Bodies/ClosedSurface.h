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
/// A surface that can be filled: its points merged, and what it encloses.
struct ClosedSurface
{
  vtkSmartPointer<vtkPolyData> surface; ///< without arrays, points at the same place as one
  double volume = 0.0;                  ///< mm³
  double area = 0.0;                    ///< mm²
  bool isOpen = false; ///< or touches itself: `surface` is set, but cannot be filled
};

/// Returns what is wrong - no triangles, open, inside out - or "".
std::string takeClosedSurface(vtkPolyData* body, ClosedSurface& closed);

/// A side of a box that holds the body.
struct HeldFace
{
  double depth = 0.0;   ///< from the outermost place, mm; 0: not held
  bool isGiven = false; ///< the depth is not the usual one
};

/// -x, +x, -y, +y, -z, +z.
using HeldFaces = std::array<HeldFace, 6>;

/// Reads "z-, x+:2.5": a side, and its depth where that is not `usual` (mm). Returns what is wrong,
/// or "".
std::string readHeldFaces(const std::string& text, double usual, HeldFaces& faces);

/// The array `Fixed` for the points of a body: 7 for those that are held, 0 elsewhere. A face of a
/// given depth holds all points within it. One of the usual depth holds the surface alone: the
/// corners of outer faces within that depth whose normal is less than 45° from the side's.
vtkSmartPointer<vtkUnsignedCharArray> holdFaces(vtkUnstructuredGrid* body, const HeldFaces& faces);
} // namespace palpate

#endif
