// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DetectabilityMap_h
#define palpate_DetectabilityMap_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * Runs --map for a scene with nodules: shows by how much the nodules change the force of each of
 * the first three tools. Colours show the change, and a line shows the threshold. Writes map.png in
 * the output folder, or shows a window, in which all maps turn together, until the window is
 * closed. Prints the change above each nodule, and the most sensitive tool. Returns "" or an error.
 */
std::string runDetectabilityMap(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
