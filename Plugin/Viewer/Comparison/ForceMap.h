// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceMap_h
#define palpate_ForceMap_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/**
 * Runs --map for a segmentation: shows the force of the first tool over the body of the scene,
 * pressed to the depth of the scene. Writes map.png in the output folder, or shows a window, in
 * which the body can be turned, until the window is closed. Prints the largest force, its position
 * and its error. Points within two contact radii of the held part are not counted, because near
 * this part the support determines the force. Returns "" or an error.
 */
std::string runForceMap(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
