// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveWindow_h
#define palpate_LiveWindow_h

#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * Runs the session in a window. The servo thread runs at the chosen rate. The mouse or a device
 * moves the tool. A panel changes tool, material and model, even during contact. Charts show the
 * forces. The key ? lists the keys, and q closes the window. After the window is closed, the timing
 * of the servo thread is printed. Returns "" or an error.
 */
std::string runLive(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
