// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchPlace_h
#define palpate_LiveTouchPlace_h

#include <Eigen/Core>

namespace palpate
{
struct ContactBody;

/// The handle in the view, and what it means for the tip: as of vtkToolTouch, so that both feel the
/// same.
struct TouchHandle
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< mm
  /// There is none yet: the touch is to begin where findTouchStart finds, whatever the position.
  bool isToBeFound = false;
  /// Whether the tip first goes to the surface point nearest to the handle.
  bool snaps = true;
  /// How far the tip is moved in along the normal there, mm. 0: half of the range of the response
  /// if it snaps, else not at all.
  double depth = 0.0;
};

/// Where the tip is to go, and what of the body is nearest to it. mm.
struct LiveTouchPlace
{
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d surface = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< outward, unit
};

/// A microsecond, also on a body of millions of triangles.
LiveTouchPlace findPlace(const ContactBody& body, const TouchHandle& handle);
} // namespace palpate

#endif
