// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OffscreenSession_h
#define palpate_OffscreenSession_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * Runs the session without a window. The function makes the responses of all tools, and moves the
 * simulated device along the path of the scene in virtual time. Then it writes overview.png,
 * deflection.png, curves.png and trajectory.csv, and prints a summary on the output stream. It also
 * writes tools.png for a scene with several tools side by side, and thickness.png for layers from a
 * scan. The files are the same in every run. Only the lines about time and memory in the summary
 * differ.
 *
 * Returns "" or an error.
 */
std::string runOffscreen(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
