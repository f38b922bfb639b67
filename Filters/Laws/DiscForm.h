// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DiscForm_h
#define palpate_DiscForm_h

#include "Laws/PointRings.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace palpate
{
/// The second fundamental form of the surface under a contact, in the TangentFrame of the normal
/// (coefficients of t², tu, u²), 1/mm, positive where the surface is convex.
struct DiscForm
{
  Eigen::Vector3d form;
  /// Root-mean-square residual of the heights, divided by the squared contact radius.
  double residual;
};

/// A point of a surface with its normal. Both are in one place of the memory, because discs visit
/// points in no order.
struct NormalPoint
{
  std::array<double, 3> place;
  std::array<float, 3> normal; ///< unit length
  std::uint64_t drawn;         ///< a number that looks random

  Eigen::Vector3d placeVector() const { return Eigen::Map<const Eigen::Vector3d>(place.data()); }
  Eigen::Vector3d normalVector() const
  {
    return Eigen::Map<const Eigen::Vector3f>(normal.data()).cast<double>();
  }
};

/// The points of a surface with their normals, 3 floats per point.
std::vector<NormalPoint> normalPoints(const TriangleSpans& surface, const float* normals);

/**
 * Fits a polynomial of fourth order to the surface under a contact: an offset and a tilt of the
 * tangent plane, all terms of second and third order, and r⁴. The mean curvature of the form is
 * that of the paraboloid on which a contact has the same force to first order (SurfaceCurvature):
 * half the trace, plus 8/5 a² times the coefficient of r⁴, plus 3/a² times the offset. The fit uses
 * the points within 1.25 contact radii a, but at least two rings of neighbours and at most about a
 * hundred points. The weights of the points decrease with the distance. Small ridge terms limit the
 * coefficients that few points determine.
 *
 * Not thread-safe: each thread needs its own object. Cost: about 10 µs per fit.
 */
class DiscForms
{
public:
  /// `spacing`: pointSpacing(), mm. `points` and `rings` must outlive this.
  DiscForms(const std::vector<NormalPoint>& points, const PointRings& rings, double spacing,
    double contactRadius);

  /// Fits the form at a point. Returns no value if the point has no normal, or if the disc has
  /// fewer than 12 or more than 2000 points.
  std::optional<DiscForm> fit(std::size_t point);

private:
  void gather(std::size_t point, double reach);

  const std::vector<NormalPoint>& Points;
  const PointRings& Rings;
  double Radius;
  double Spacing;
  std::vector<std::size_t> Near;     ///< the points of the disc
  std::vector<double> Fitted;        ///< x, y, height and weight of the points that are fitted
  std::vector<double> Terms;         ///< of these points
  std::vector<double> Weighted;      ///< the same times the weights of the points
  std::vector<std::uint32_t> Passed; ///< the search in which a point was last seen
  std::uint32_t Search = 0;
};
} // namespace palpate

#endif
