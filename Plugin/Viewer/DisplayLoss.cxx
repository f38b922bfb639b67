// SPDX-License-Identifier: BSD-3-Clause
#include "DisplayLoss.h"

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
  const std::string error = action ? action() : std::string(); // first of all, release the hand
  if (!error.empty())
  {
    std::fprintf(stderr, "palpate: error: %s\n", error.c_str());
  }
  std::fprintf(
    stderr, "palpate: error: the X server of DISPLAY='%s' is gone\n", DisplayString(display));
  std::fflush(nullptr);
  std::_Exit(EXIT_FAILURE); // static destructors would draw
}
#endif
} // namespace

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
