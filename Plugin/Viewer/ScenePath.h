// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ScenePath_h
#define palpate_ScenePath_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <array>
#include <string>

namespace palpate
{
/// Makes the path, with times, of the simulated hand over the scene; see vtkPressPath. Returns ""
/// or an error.
std::string makePath(const ViewerScene& scene, vtkPolyData* path);

/// A point on the surface of a body.
struct TouchSite
{
  std::array<double, 3> point{};  ///< mm
  std::array<double, 3> normal{}; ///< outward unit normal

  /// Returns the point at the given height above the site, mm.
  std::array<double, 3> above(double height) const;
};

/// Returns the first site of the scene, which is the outermost vertex within two degrees of the
/// scene's first direction from the centre.
TouchSite firstSite(const ViewerScene& scene, vtkPolyData* bodyWithResponse);

/// The unit directions to the right and upward in the picture of a scene.
struct PictureAxes
{
  explicit PictureAxes(const ViewerScene& scene);

  double right[3];
  double up[3];
};

/// Returns the starting site of a hand, numbered from 0. Hand 0 starts at the first site. Each
/// further hand starts one step to the right of the previous hand.
TouchSite siteOfHand(const ViewerScene& scene, vtkPolyData* bodyWithResponse, int hand);
} // namespace palpate

#endif
