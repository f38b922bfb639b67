// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceForms_h
#define palpate_SurfaceForms_h

#include "Laws/LinkedSurface.h"
#include "Laws/PointCurvature.h"
#include "Laws/PointForm.h"
#include "Laws/PointRings.h"
#include "Laws/SpaceForm.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * The second fundamental form at each point of a surface, and its noise. The form at each point is
 * fitted to the neighbours once. Curvatures can then be computed for any number of contact radii,
 * as explained in SurfaceCurvature.
 *
 * Threaded. The result is bit for bit the same for any number of threads.
 */
class PALPATE_EXPORT SurfaceForms
{
public:
  static constexpr int MostSteps = 16;

  /// `normals` has 3 floats per point, unit length. The arrays of both arguments must outlive this
  /// object.
  SurfaceForms(const TriangleSpans& surface, const float* normals);

  /// Returns the curvatures of all points for a contact of the given radius, mm. Cost: up to 5 µs
  /// per point.
  std::vector<PointCurvature> curvatures(double contactRadius) const;

private:
  void fitPoints();
  void findRoughness();
  void findNoise();
  std::vector<std::size_t> takeDiscs(
    double contactRadius, std::vector<PointCurvature>& found) const;
  void takeAverages(
    double steps, const std::vector<std::size_t>& points, std::vector<PointCurvature>& found) const;
  void step(const std::vector<std::size_t>& points, std::vector<SpaceForm>& forms) const;
  std::vector<std::size_t> withNeighbours(const std::vector<std::size_t>& points) const;
  Eigen::Vector3d normalOf(std::size_t point) const;
  Eigen::Vector3d placeOf(std::size_t point) const;
  PointFormSums sumsOf(std::size_t point) const;
  SpaceForm neighboursOf(std::size_t point, const std::vector<SpaceForm>& forms) const;

  TriangleSpans Surface;
  const float* Normals;
  PointRings Rings;
  std::vector<PointForm> Fits;
  std::vector<SpaceForm> Forms;
  double Spacing;     ///< mean distance of points (pointSpacing()), mm
  double Noise = 0.0; ///< fraction of noise in the points, 0 to 1
};
} // namespace palpate

#endif
