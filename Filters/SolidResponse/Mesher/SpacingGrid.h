// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SpacingGrid_h
#define palpate_SpacingGrid_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A ball within which cells are to be of a spacing, or finer. Lengths in mm.
struct FineBall
{
  Eigen::Vector3d middle;
  double radius = 0.0;
  double spacing = 0.0;
};

/// A closed surface, and the sizes of the cells to fill it with. Lengths in mm.
struct MeshedSurface
{
  Eigen::Matrix3Xd points;
  std::vector<std::array<std::int32_t, 3>> triangles; ///< counter-clockwise seen from outside
  /// Edges of triangles that cells follow, however little the surface turns there.
  std::vector<std::array<std::int32_t, 2>> rims;
  std::vector<double> spacing;  ///< of the cells wanted at each point
  std::vector<FineBall> balls;  ///< that are to be finer, anywhere
  double interiorSpacing = 0.0; ///< the largest there is
  double growth = 0.0;          ///< of the spacing per length from the surface inwards
  double deviation = 0.0;       ///< how far a facet may lie off the surface
  double sharpAngle = 45.0;     ///< edges by which the surface turns more are kept, degrees
  /// The outside meets itself nowhere. Where the surface nearly does, that may take cells without
  /// end.
  bool isManifold = true;
};

/**
 * The spacing wanted at points in and on a surface, from a grid over its box: the least over all
 * points of the surface, and over the finer balls, of the spacing there plus growth times the
 * distance, so that there is no jump around a fine part. Linear between nodes. Distances are those
 * along a grid's sides and diagonals, up to a tenth too long, less a step of the grid.
 *
 * Cost: two sweeps, a second and 16 MiB for the two million nodes it has at most. A lookup takes
 * some ten nanoseconds; the closest point of a surface of 20 thousand triangles takes a thousand
 * times as long from the centre of a ball.
 */
class SpacingGrid
{
public:
  explicit SpacingGrid(const MeshedSurface& surface);

  double at(const Eigen::Vector3d& place) const;

private:
  std::size_t node(const Eigen::Array3i& at) const
  {
    return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(this->Size[1]) +
             static_cast<std::size_t>(at[1])) *
      static_cast<std::size_t>(this->Size[0]) +
      static_cast<std::size_t>(at[0]);
  }
  void mark(const MeshedSurface& surface, double growth);
  void sweep(double growth);
  void refine(const FineBall& ball, double growth);

  Eigen::Vector3d Origin;
  double Step = 0.0;
  Eigen::Array3i Size; ///< nodes along each axis
  std::vector<double> Values;
};
} // namespace palpate

#endif
