// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PhantomBody_h
#define palpate_PhantomBody_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>

namespace palpate
{
/// Must be increased when the body or its solution changes, so that no outdated cache file is used.
constexpr int PhantomRevision = 2;

/// A hard ball in the phantom. Lengths are in mm. The skin is the plane z = 0.
struct PhantomNodule
{
  double x = 0.0;
  double y = 0.0;
  double top = 0.0; ///< depth of the top of the ball below the skin
  double radius = 0.0;
};

/// Nine nodules with three radii (one per column) at three depths (one per row), at least 6 mm
/// apart.
constexpr std::array<PhantomNodule, 9> PhantomNodules = { { { -14.0, -16.0, 1.0, 1.5 },
  { -2.0, -16.0, 1.0, 3.0 }, { 13.0, -16.0, 1.0, 5.0 }, { -14.0, 0.0, 2.0, 1.5 },
  { -2.0, 0.0, 2.0, 3.0 }, { 13.0, 0.0, 2.0, 5.0 }, { -14.0, 16.0, 3.0, 1.5 },
  { -2.0, 16.0, 3.0, 3.0 }, { 13.0, 16.0, 3.0, 5.0 } } };

/// Ratio of a nodule's modulus to the modulus of the block.
constexpr double NoduleHardness = 10.0;

/// The searched part of the skin: smallest x, largest x, smallest y, largest y, mm. It extends
/// beyond all nodules.
constexpr std::array<double, 4> PhantomField = { -19.0, 21.5, -24.5, 24.5 };

/**
 * Makes a block of 95 x 104 x 40 mm with nodules (vtkNoduleMaterial). Its bottom and sides are
 * bonded to a rigid box (`Fixed`). The array `Pressed` marks the points of PhantomField. Cells are
 * 0.75 to 1 mm long at the nodules to a depth of 9 mm, and longer elsewhere.
 */
vtkSmartPointer<vtkUnstructuredGrid> makePhantomGrid(double youngsModulus, double poissonRatio);

/// Returns the outlines of the nodules on the skin, as closed lines.
vtkSmartPointer<vtkPolyData> outlineNodules();
} // namespace palpate

#endif
