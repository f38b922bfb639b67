// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DetectabilityMap_h
#define palpate_DetectabilityMap_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * --map of a scene with nodules: by how much they change the force of each of the first three
 * tools, as colour, lined where that begins to be felt: map.png in the output folder, or a window
 * in which all turn together, until it is closed. Prints what is felt over each nodule, and with
 * which tool most. Returns an error, or "".
 */
std::string runDetectabilityMap(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
