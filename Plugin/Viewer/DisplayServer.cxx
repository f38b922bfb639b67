// SPDX-License-Identifier: BSD-3-Clause
#include "DisplayServer.h"

#include <utility>

#ifdef PALPATE_X11
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>
#endif

namespace palpate
{
namespace
{
std::function<std::string()> LastAction;

#ifdef PALPATE_X11
int onLoss(Display* display)
{
  const std::function<std::string()> action = std::exchange(LastAction, nullptr);
  // This releases the hand before the message is printed.
  const std::string error = action ? action() : std::string();
  if (!error.empty())
  {
    std::fprintf(stderr, "palpate: error: %s\n", error.c_str());
  }
  std::fprintf(
    stderr, "palpate: error: the X server of DISPLAY='%s' is gone\n", DisplayString(display));
  std::fflush(nullptr);
  std::_Exit(EXIT_FAILURE); // exit would run static destructors, which would draw
}
#endif
} // namespace

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

void endWithDisplay()
{
#ifdef PALPATE_X11
  XSetIOErrorHandler(onLoss);
#endif
}

AtDisplayLoss::AtDisplayLoss(std::function<std::string()> action)
{
  LastAction = std::move(action);
}

AtDisplayLoss::~AtDisplayLoss()
{
  LastAction = nullptr;
}
} // namespace palpate
