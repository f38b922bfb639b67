// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneCamera_h
#define SceneCamera_h

#include <Eigen/Core>

class vtkRenderer;

namespace palpate
{
/// From where, and what points up in the picture; of any length but zero.
struct ViewDirection
{
  Eigen::Vector3d from;
  Eigen::Vector3d up;
};

/// All of the bounds, in the middle of what the column at the right leaves free: `column` is its
/// share of the picture's width.
void lookAtBounds(
  vtkRenderer* renderer, const double bounds[6], const ViewDirection& view, double column);

/// A point from `distance` mm, a little below the middle, so that an arrow above it fits in.
void lookAtPoint(vtkRenderer* renderer, const Eigen::Vector3d& point, double distance,
  const ViewDirection& view, double column);
} // namespace palpate

#endif
