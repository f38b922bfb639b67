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
 * The second fundamental form at each point of a surface, and its noise. SurfaceCurvature explains
 * how the curvatures for a contact follow. They are found for any number of contact radii, while
 * the fits to the neighbours are made once.
 *
 * Threaded; the bits do not depend on the number of threads.
 */
class PALPATE_EXPORT SurfaceForms
{
public:
  static constexpr int MostSteps = 16;

  /// `normals`: 3 floats per point, unit length. All arrays must outlive this.
  SurfaceForms(const TriangleSpans& surface, const float* normals);

  /// The curvatures of all points for a contact of this radius, mm. Cost: up to 5 µs per point.
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
  double Spacing;     ///< pointSpacing(), mm
  double Noise = 0.0; ///< fraction of noise in the points
};
} // namespace palpate

#endif
