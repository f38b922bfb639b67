// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceCurvature_h
#define palpate_SurfaceCurvature_h

#include "Laws/ContactSpot.h"
#include "Laws/LinkedSurface.h"
#include "Laws/SurfaceForms.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace palpate
{
/**
 * Principal curvatures of a body at its points, averaged over a contact, with their error.
 *
 * Along each edge ij at a point the normal changes at the rate (n_j - n_i)·(x_j - x_i)/|x_j - x_i|²
 * (1/mm, positive where the surface is convex). This rate is called the turn. The second
 * fundamental form in the tangent plane is fitted to these turns (least squares, weighted by the
 * squared lengths of the edges). Its eigenvalues are the principal curvatures; they are exact on a
 * sphere. With fewer than three directions, both are set to the mean over the edges.
 *
 * The width of the average depends on the contact. To first order the force of the contact depends
 * on the surface's height weighted by 1/√(a²-r²). For heights of second and fourth order this
 * corresponds to the mean curvature, averaged so that the mean of r² is a²/5. The turns average
 * over the same area if a is 2.4 times the distance of the points. There are three methods,
 * depending on the ratio of a to the distance of the points:
 *
 * - below 1.1: a second form is fitted to the sags, the depths of the neighbours below the tangent
 *   plane. The sags average over a third of the area of the turns. Both forms are combined;
 * - 1.1 to 8: a polynomial is fitted to the heights of the points under the contact (DiscForms);
 * - above 8: the forms fitted to the turns are averaged over neighbouring points, at most MostSteps
 *   times. The last step may be partial. Each form is rotated from one normal to the other.
 *
 * If the differences at neighbouring points have opposite signs, the surface is noisy. Then only
 * the turns are used.
 *
 * The error is the error of this mean curvature. The *roughness* of a point is the root mean
 * square, over the point and its neighbours, of the difference between the mean curvature at a
 * point and the average around it. The error depends on the method:
 *
 * - one form: 0.7 times the root of the sum of three squares: the roughness, the root-mean-square
 *   residual of the turns (with fewer than three directions, twice the residual of the edges), and
 *   the difference of the two forms. If the surface is noisy, it is the larger of the residual
 *   and 2.5 times the roughness;
 * - a disc: the sum of twice the residual of its heights divided by a², and 0.3 % of the curvature;
 * - an average: the sum of 1.3/(1 + steps) times the roughness (noise moves neighbours in opposite
 *   directions), the change by the second half of the steps, a tenth of the spread, and a fiftieth
 *   of the curvature.
 *
 * The true error is within this bound at 95 of 100 points of analytic surfaces, including noisy and
 * coarse surfaces: Testing/Cxx/Laws/SurfaceCurvatureTest.cxx.
 *
 * The points are processed one by one, in several threads. The result is bit for bit the same for
 * any number of threads. Memory: 12 bytes per point; during construction another 24 bytes per
 * triangle and 180 per point, and 150 per point for averages. Cost: 1 µs per point once, 0.2 µs per
 * point and step, 2 to 5 µs per disc.
 */
class PALPATE_EXPORT SurfaceCurvature
{
public:
  static constexpr int MostSteps = SurfaceForms::MostSteps;

  /// `normals` has 3 floats per point, unit length. `contactRadius` is in mm.
  SurfaceCurvature(const TriangleSpans& surface, const float* normals, double contactRadius);
  /// As above, from forms that can be used for several radii.
  SurfaceCurvature(const SurfaceForms& forms, double contactRadius);
  /// From known curvatures, one per point.
  explicit SurfaceCurvature(std::vector<PointCurvature>&& found)
    : Found(std::move(found))
  {
  }

  SpotCurvature at(std::size_t point) const noexcept
  {
    const PointCurvature& found = this->Found[point];
    return { static_cast<double>(found[0]), static_cast<double>(found[1]),
      static_cast<double>(found[2]) };
  }

private:
  std::vector<PointCurvature> Found;
};
} // namespace palpate

#endif
