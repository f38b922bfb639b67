// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceCurvature_h
#define palpate_SurfaceCurvature_h

#include "Laws/ContactSpot.h"
#include "Laws/LinkedSurface.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * Principal curvatures of a body at its points, averaged over a contact, with their error.
 *
 * Along each edge ij at a point the surface turns by (n_j - n_i)·(x_j - x_i)/|x_j - x_i|² (1/mm,
 * positive if convex). The second fundamental form of the tangent plane is fitted to these turns
 * (least squares, weighted by the edges' length²). Its eigenvalues are the principal curvatures;
 * they are exact on a sphere. With fewer than three directions, both are the mean over the edges.
 *
 * The width of the average is chosen for the contact: to first order the force depends on the
 * surface's height weighted by 1/√(a²-r²). For heights of second and fourth order this is the mean
 * curvature, averaged so that the mean of r² is a²/5. The turns have the same width of average if a
 * is 2.4 times the distance of the points. For a smaller contact a second form is fitted to the
 * sags of the neighbours below the tangent plane, whose width of average is a third of that, and
 * the two forms are combined. For a larger contact the forms are averaged from point to point, at
 * most MostSteps times, where the last step is partial. Each form is turned from normal to normal.
 *
 * The error is the error of this mean curvature. The *roughness* of a point is the root mean
 * square, over the point and its neighbours, of the difference between the mean curvature at a
 * point and the average around that point. The error of one form is 0.7 times the root of the sum
 * of three squares: the roughness, the root-mean-square residual of the turns (with fewer than
 * three directions, twice that of the edges), and the difference of the two forms. On a noisy
 * surface (the differences of neighbours have opposite signs) only turns are used, and the error is
 * the larger of the residual and 2.5 times the roughness. The error of an average is the sum of
 * four terms: 1.3/(1 + steps) times the roughness, because noise moves neighbours in opposite
 * directions; the change by the second half of the steps; a tenth of the spread; and a fiftieth of
 * the curvature. The true error is smaller for 95 of 100 points of analytic surfaces, including
 * noisy and coarse ones: Testing/Cxx/Laws/SurfaceCurvatureTest.cxx.
 *
 * Points are gathered one by one, threaded; the result is bit for bit the same for any number of
 * threads. Memory: 12 bytes per point; during construction another 28 per triangle and 160 per
 * point. Cost: 1 µs per point, and 0.3 µs per point and step.
 */
class PALPATE_EXPORT SurfaceCurvature
{
public:
  static constexpr int MostSteps = 16;

  /// `normals`: 3 floats per point, unit length. `contactRadius` in mm.
  SurfaceCurvature(const TriangleSpans& surface, const float* normals, double contactRadius);

  /// The curvature of the faces between sharp edges (CreaseCut), for contacts that leave the body
  /// over these edges (BodyEdges). The turn of an edge is not part of the curvature. The curvature
  /// of a point on an edge is the mean of its faces.
  static SurfaceCurvature ofFaces(
    const TriangleSpans& surface, const float* normals, double contactRadius);

  SpotCurvature at(std::size_t point) const noexcept
  {
    const std::array<float, 3>& found = this->Found[point];
    return { static_cast<double>(found[0]), static_cast<double>(found[1]),
      static_cast<double>(found[2]) };
  }

private:
  std::vector<std::array<float, 3>> Found;
};
} // namespace palpate

#endif
