// SPDX-License-Identifier: BSD-3-Clause
#include "DisplayCheck.h"

#ifdef PALPATE_X11
#include <X11/Xlib.h>

#include <cstdlib>
#endif

namespace palpate
{
std::string displayProblem()
{
#ifdef PALPATE_X11
  const char* name = std::getenv("DISPLAY");
  if (!name)
  {
    return "pictures need an X server, and DISPLAY is not set; run under xvfb-run";
  }
  Display* display = XOpenDisplay(name);
  if (!display)
  {
    return "pictures need an X server, and DISPLAY='" + std::string(name) +
      "' does not answer; run under xvfb-run";
  }
  XCloseDisplay(display);
#endif
  return {};
}
} // namespace palpate
