// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BaseNeighbours_h
#define palpate_BaseNeighbours_h

#include "vtkMath.h"
#include "vtkType.h"

#include <vector>

class vtkIdList;
class vtkPoints;
class vtkStaticPointLocator;

namespace palpate
{
/// Points of a surface with their unit normals.
struct NormalSurface
{
  vtkPoints* points;
  const float* normals;
  vtkStaticPointLocator* locator;

  double cosine(vtkIdType a, vtkIdType b) const
  {
    return static_cast<double>(vtkMath::Dot(this->normals + 3 * a, this->normals + 3 * b));
  }
};

/// The base under a point: 1/depth and its error, 1/mm.
struct InverseDepth
{
  double value; ///< 0: no base
  double error;
};

/**
 * Combines the depths of a base that were measured below the points of a surface.
 *
 * Neighbours of a point are the points within `radius` (mm) whose normals turn by less than 60°,
 * and the point itself. A depth (mm) is +inf where no base was found.
 *
 * The mean is that of 1/depth, because a base at the depth h raises the force of a contact by an
 * amount proportional to 1/h, to first order; without a base 1/h is 0. A neighbour at the distance
 * r has the weight 1 - (r/radius)², so that the mean changes gradually from point to point.
 */
class BaseNeighbours
{
public:
  BaseNeighbours(const NormalSurface& surface, double radius)
    : Surface(surface)
    , Radius(radius)
  {
  }

  /// Median depth of the neighbours of point `i`. `near` and `found` are memory.
  float median(vtkIdType i, const std::vector<float>& depths, vtkIdList* near,
    std::vector<float>& found) const;

  /**
   * Mean of the inverse medians of the neighbours of point `i`. The error is the sum of their
   * standard deviation, of the difference of this mean from the mean of the inverse depths, and of
   * the effect of `depthError` (mm, > 0), which is also the smallest depth. A base below `deepest`
   * (mm) counts as no base; then 1/depth is uncertain by at least 1/deepest.
   */
  InverseDepth mean(vtkIdType i, const std::vector<float>& depths,
    const std::vector<float>& medians, double deepest, double depthError, vtkIdList* near) const;

private:
  NormalSurface Surface;
  double Radius;
};
} // namespace palpate

#endif
