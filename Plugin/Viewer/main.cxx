// SPDX-License-Identifier: BSD-3-Clause
// palpate: press a tool against a body, see and feel the force. See --help.
#include "BlindTrial.h"
#include "ComparisonPictures.h"
#include "ComparisonWindow.h"
#include "DisplayServer.h"
#include "Haptics/Safety/ForceRelease.h"
#include "LiveWindow.h"
#include "OffscreenSession.h"
#include "OutputCheck.h"
#include "RegimeMap.h"
#include "Mechanics/ThreadCount.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include "vtkHapticSession.h"
#include "vtkSMPTools.h"

#include <csignal>
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

/// Runs the chosen way to touch or show a scene. Returns an error, or "".
std::string run(const palpate::ViewerOptions& options, const palpate::ViewerScene& scene)
{
  if (options.map)
  {
    return palpate::runRegimeMap(options, scene);
  }
  if (!options.trial.empty())
  {
    return options.window ? palpate::runTrialWindow(options, scene)
                          : palpate::runTrialConsole(options, scene);
  }
  return options.window ? palpate::runLive(options, scene) : palpate::runOffscreen(options, scene);
}

/// Returns an error, or "".
std::string run(const palpate::ViewerOptions& options)
{
  const bool draws = options.window || (options.trial.empty() && options.pictures);
  std::string error = palpate::outputProblem(options);
  if (error.empty() && draws)
  {
    error = palpate::displayProblem();
  }
  if (!error.empty())
  {
    return error;
  }
  if (options.compare)
  {
    return options.window ? palpate::runComparisonWindow(options) : palpate::runComparison(options);
  }
  palpate::ViewerScene scene;
  error = palpate::makeViewerScene(options, scene);
  for (const std::string& note : scene.notes)
  {
    std::fprintf(stderr, "palpate: %s\n", note.c_str());
  }
  return error.empty() ? run(options, scene) : error;
}
} // namespace

int main(int argc, char** argv)
{
  palpate::ViewerOptions options;
  if (const auto exitCode = palpate::readCommandLine(argc, argv, options))
  {
    return *exitCode;
  }
  if (options.listDevices)
  {
    std::fputs(vtkHapticDevice::ListDevices().c_str(), stdout);
    return EXIT_SUCCESS;
  }
  palpate::releaseForceOnTerminate();
  palpate::endWithDisplay();
  // Writing reports a broken pipe; the process must not end by it with a force on the hand.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // An application may choose the backend of VTK's loops; libraries leave it to their host.
  vtkSMPTools::SetBackend("STDThread");
  if (std::getenv("PALPATE_THREADS") != nullptr)
  {
    vtkSMPTools::Initialize(static_cast<int>(palpate::threadCount()));
  }
  const std::string error = run(options);
  return error.empty() ? EXIT_SUCCESS : fail(error);
}
