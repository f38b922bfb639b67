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

/// The inverse depth of the base below a point, 1/mm.
struct InverseDepth
{
  double value; ///< 1/depth; 0 if there is no base
  double error;
};

/**
 * Combines the depths of a base that were measured below the points of a surface.
 *
 * Neighbours of a point are the points within `radius` (mm) whose normals differ from the normal of
 * the point by less than 60°, and the point itself. A depth (mm) is +inf if no base was found below
 * the point.
 *
 * The values 1/depth are averaged, because a base at the depth h raises the force of a contact by
 * an amount proportional to 1/h, to first order. Without a base, 1/h is 0. A neighbour at the
 * distance r has the weight 1 - (r/radius)², so that the mean changes gradually from point to
 * point.
 */
class BaseNeighbours
{
public:
  BaseNeighbours(const NormalSurface& surface, double radius)
    : Surface(surface)
    , Radius(radius)
  {
  }

  /// Returns the median depth of the neighbours of point `i`. The contents of `near` and `found`
  /// are overwritten; the caller keeps them to avoid allocations.
  float median(vtkIdType i, const std::vector<float>& depths, vtkIdList* near,
    std::vector<float>& found) const;

  /**
   * Returns the mean of the inverse medians of the neighbours of point `i`, and its error. The
   * error is the sum of three parts: the standard deviation of the inverse medians; the difference
   * of the mean from the mean of the inverse depths; and the effect of `depthError`. `depthError`
   * (mm, > 0) is also the smallest depth. A base below `deepest` (mm) counts as no base, and
   * 1/depth is then uncertain by at least 1/deepest. The contents of `near` are overwritten.
   */
  InverseDepth mean(vtkIdType i, const std::vector<float>& depths,
    const std::vector<float>& medians, double deepest, double depthError, vtkIdList* near) const;

private:
  NormalSurface Surface;
  double Radius;
};
} // namespace palpate

#endif
