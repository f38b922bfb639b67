// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchPlace_h
#define palpate_LiveTouchPlace_h

#include <Eigen/Core>

namespace palpate
{
struct ContactBody;

/// The handle in the view and the data that define the tip from it, as in vtkToolTouch. For the
/// same handle, the forces of a live touch and of vtkToolTouch are equal.
struct TouchHandle
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< mm
  /// Whether there is no position yet, so that the touch begins at the point that findTouchStart
  /// finds.
  bool isToBeFound = false;
  /// Whether the tip is first moved to the surface point nearest to the handle.
  bool snaps = true;
  /// Distance by which the tip is then moved inward along the normal, mm. If it is 0, half of the
  /// range of the response is used if `snaps` is true, and the tip is not moved otherwise.
  double depth = 0.0;
};

/// The target of the tip, and the nearest point of the body, mm.
struct LiveTouchPlace
{
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d surface = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< outward unit normal
};

/// Finds the target of the tip for a handle. The cost is 1 µs, even for a body with millions of
/// triangles.
LiveTouchPlace findPlace(const ContactBody& body, const TouchHandle& handle);
} // namespace palpate

#endif
