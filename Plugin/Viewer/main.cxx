// SPDX-License-Identifier: BSD-3-Clause
// palpate: press a tool against a body, see and feel the force. See --help.
#include "OffscreenSession.h"
#include "TouchScene.h"
#include "ViewerOptions.h"

#include "vtkSMPTools.h"

#include <cstdio>
#include <cstdlib>

namespace
{
constexpr int Failure = 1;

int fail(const std::string& error)
{
  std::fprintf(stderr, "palpate: error: %s\n", error.c_str());
  return Failure;
}
} // namespace

int main(int argc, char** argv)
{
  palpate::ViewerOptions options;
  if (const auto exitCode = palpate::readCommandLine(argc, argv, options))
  {
    return *exitCode;
  }
  // An application may choose how VTK's loops run; the libraries leave it to their host.
  vtkSMPTools::SetBackend("STDThread");
#ifndef _WIN32
  if (!std::getenv("DISPLAY"))
  {
    return fail("pictures need an X server, and DISPLAY is not set; run under xvfb-run");
  }
#endif
  palpate::TouchScene scene;
  std::string error = palpate::makeTouchScene(options, scene);
  if (error.empty())
  {
    error = palpate::runOffscreen(options, scene);
  }
  return error.empty() ? EXIT_SUCCESS : fail(error);
}
