// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RegimeMap_h
#define palpate_RegimeMap_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * --map: regime index, tool sensitivity and verdict of the first tool over the scene's body, at its
 * depth: map.png in the output folder, or a window in which the three turn together, until it is
 * closed. Prints the fraction of the surface with each verdict. Returns an error, or "".
 */
std::string runRegimeMap(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
