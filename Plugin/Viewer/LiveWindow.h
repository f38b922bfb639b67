// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveWindow_h
#define palpate_LiveWindow_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * The session in a window: the servo thread at the chosen rate, the mouse or a device moves the
 * tool; a panel changes tool, material and model, also during contact; charts show the forces; ?
 * lists the keys, q ends. Then prints the timing of the servo thread. Returns when the window is
 * closed; an error, or "".
 */
std::string runLive(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
