// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceCurvature_h
#define SurfaceCurvature_h

#include "Laws/ContactSpot.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace palpate
{
class BodySeam;

/**
 * Principal curvatures of a body at its points, with their error.
 *
 * Along each edge ij that meets at a point the surface turns by (n_j - n_i)·(x_j - x_i)/|x_j -
 * x_i|² (1/mm, positive where convex). The second fundamental form of the tangent plane that fits
 * these best (least squares) has the principal curvatures as eigenvalues; exact on a sphere. The
 * error is the root mean square of what the form does not explain: noise of the mesh, and curvature
 * that changes from one edge to the next. With fewer than three directions, the mean of the edges
 * and, as the error, the largest of them. 0 where no edge has a length.
 *
 * Points are gathered one by one, threaded; the same bits for any number of threads. At a seam the
 * edges of all pieces count. Memory: 12 bytes per point kept, 28 per triangle while it is made.
 */
class SurfaceCurvature
{
public:
  /// `body`, or the own piece of it, has triangles only; `normals` are 3 floats per point, unit
  /// length, the same on all pieces at a seam. Collective.
  SurfaceCurvature(vtkPolyData* body, const BodySeam& seam, const float* normals);

  SpotCurvature at(vtkIdType point) const noexcept
  {
    const std::array<float, 3>& found = this->Found[static_cast<std::size_t>(point)];
    return { static_cast<double>(found[0]), static_cast<double>(found[1]),
      static_cast<double>(found[2]) };
  }

private:
  std::vector<std::array<float, 3>> Found;
};
} // namespace palpate

#endif
