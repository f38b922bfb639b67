// SPDX-License-Identifier: BSD-3-Clause
/**
 * Default spacings of the cells that fill a body. They follow from the size of the body, so that a
 * body of any size gets about the same number of cells.
 */
#ifndef palpate_ChosenSpacing_h
#define palpate_ChosenSpacing_h

#include <algorithm>
#include <cmath>

namespace palpate
{
/// The number of graded tetrahedra is this factor times the area, divided by the square of the
/// spacing. The factor was measured on balls.
inline constexpr double CellsPerSquare = 8.7;
/// Number of tetrahedra that the default spacing gives. Their solution takes about two minutes on
/// two cores.
inline constexpr double ChosenTetrahedra = 20000.0;
/// Largest spacing relative to the cube root of the volume. A larger spacing does not represent the
/// shape of the body.
inline constexpr double LargestOfBody = 1.0 / 6.0;
inline constexpr double ChosenVoxels = 10000.0;

/// Returns the spacing at the surface (mm) that gives about `cells` graded tetrahedra. `area` is in
/// mm² and `volume` in mm³.
inline double chosenSpacing(double area, double volume, double cells = ChosenTetrahedra)
{
  return std::min(std::sqrt(CellsPerSquare * area / cells), LargestOfBody * std::cbrt(volume));
}

/// Returns the side length of the voxels, mm, for a volume (mm³).
inline double chosenVoxel(double volume)
{
  return std::cbrt(volume / ChosenVoxels);
}
} // namespace palpate

#endif
