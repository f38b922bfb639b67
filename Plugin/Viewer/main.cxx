// SPDX-License-Identifier: BSD-3-Clause
// palpate: press a tool against a body, see and feel the force. See --help.
#include "DisplayCheck.h"
#include "LiveWindow.h"
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
  palpate::TouchScene scene;
  std::string error = palpate::displayProblem();
  if (error.empty())
  {
    error = palpate::makeTouchScene(options, scene);
  }
  if (error.empty())
  {
    error =
      options.window ? palpate::runLive(options, scene) : palpate::runOffscreen(options, scene);
  }
  return error.empty() ? EXIT_SUCCESS : fail(error);
}
