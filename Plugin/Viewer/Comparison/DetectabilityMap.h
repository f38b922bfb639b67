// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DetectabilityMap_h
#define palpate_DetectabilityMap_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * --map of a scene with nodules: the change of the force of each of the first three tools by the
 * nodules, as colour, with a line at the threshold: map.png in the output folder, or a window in
 * which all turn together, until it is closed. Prints the change over each nodule, and the most
 * sensitive tool. Returns an error, or "".
 */
std::string runDetectabilityMap(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
