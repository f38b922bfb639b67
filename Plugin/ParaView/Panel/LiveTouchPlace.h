// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchPlace_h
#define palpate_LiveTouchPlace_h

#include <Eigen/Core>

namespace palpate
{
struct ContactBody;

/// The handle in the view, and the tip that it defines, as in vtkToolTouch. The forces of a live
/// touch and of vtkToolTouch are equal for the same handle.
struct TouchHandle
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< mm
  /// Whether there is no position yet, so that the touch begins at the place of findTouchStart.
  bool isToBeFound = false;
  /// Whether the tip is first moved to the surface point nearest to the handle.
  bool snaps = true;
  /// Distance by which the tip is moved inward along the normal there, mm. 0: half of the range of
  /// the response if it snaps, otherwise no movement.
  double depth = 0.0;
};

/// The target of the tip, and the nearest point of the body. mm.
struct LiveTouchPlace
{
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d surface = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< outward, unit
};

/// Finds the place for a handle. Cost: 1 µs, even for a body of millions of triangles.
LiveTouchPlace findPlace(const ContactBody& body, const TouchHandle& handle);
} // namespace palpate

#endif
