// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RegimeMap_h
#define palpate_RegimeMap_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * Runs --map: shows regime index, tool sensitivity and verdict of the first tool over the body of
 * the scene, at the depth of the scene. Writes map.png in the output folder, or shows a window, in
 * which the three maps turn together, until the window is closed. Prints the fraction of the
 * surface for each verdict. Returns "" or an error.
 */
std::string runRegimeMap(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
