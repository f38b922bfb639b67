// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OffscreenSession_h
#define palpate_OffscreenSession_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * The session without a window: responses of all tools, the simulated device along the scene's path
 * in virtual time, then overview.png, deflection.png, curves.png (and tools.png for a scene with
 * several tools side by side, thickness.png for one with layers from a scan), trajectory.csv and a
 * summary on the output stream. The files are the same on every run; of the summary only the lines
 * of time and memory differ.
 *
 * Returns an error, or "".
 */
std::string runOffscreen(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
