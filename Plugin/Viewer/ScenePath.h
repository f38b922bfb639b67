// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ScenePath_h
#define palpate_ScenePath_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <array>
#include <string>

namespace palpate
{
/// The way of the simulated hand over the scene, with its times: see vtkPressPath. Returns an
/// error, or "".
std::string makePath(const ViewerScene& scene, vtkPolyData* path);

/// A point of a body's surface.
struct TouchSite
{
  std::array<double, 3> point{};  ///< mm
  std::array<double, 3> normal{}; ///< unit, outward

  /// So many mm above it.
  std::array<double, 3> above(double height) const;
};

/// Where the scene is touched first: the outermost vertex within two degrees of its first direction
/// from the centre.
TouchSite firstSite(const ViewerScene& scene, vtkPolyData* bodyWithResponse);

/// To the right and upward in the picture of a scene, unit.
struct PictureAxes
{
  explicit PictureAxes(const ViewerScene& scene);

  double right[3];
  double up[3];
};

/// Where one of several hands begins, from 0: at the first site, or so many steps to the right of
/// it.
TouchSite siteOfHand(const ViewerScene& scene, vtkPolyData* bodyWithResponse, int hand);
} // namespace palpate

#endif
