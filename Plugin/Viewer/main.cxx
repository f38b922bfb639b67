// SPDX-License-Identifier: BSD-3-Clause
// palpate: presses a tool against a body and renders the force. See --help.
#include "DisplayServer.h"
#include "Haptics/Safety/ForceRelease.h"
#include "LiveWindow.h"
#include "OffscreenSession.h"
#include "OutputCheck.h"
#include "Mechanics/ThreadCount.h"
#include "ViewerModules.h"
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

/// The modules that the options need for display and trials. A module that is not needed is null.
struct NeededModules
{
  const palpate::ComparisonModule* comparison = nullptr; ///< for --compare and --map
  const palpate::TrialsModule* trials = nullptr;         ///< for --trial
};

/// Loads the modules. Returns "" or an error that names the module that cannot be loaded.
std::string loadModules(const palpate::ViewerOptions& options, NeededModules& modules)
{
  std::string fault;
  if (options.compare || options.map)
  {
    modules.comparison = palpate::comparisonModule(options.compare ? "--compare" : "--map", fault);
  }
  if (fault.empty() && !options.trial.empty())
  {
    modules.trials = palpate::trialsModule("--trial", fault);
  }
  return fault;
}

/// Runs the session or display that the options choose. Returns "" or an error.
std::string run(const palpate::ViewerOptions& options, const palpate::ViewerScene& scene,
  const NeededModules& modules)
{
  if (modules.comparison)
  {
    return modules.comparison->mapRegime(options, scene);
  }
  if (modules.trials)
  {
    return options.window ? modules.trials->askInWindow(options, scene)
                          : modules.trials->askInConsole(options, scene);
  }
  return options.window ? palpate::runLive(options, scene) : palpate::runOffscreen(options, scene);
}

/// Makes the scene and runs it. Returns "" or an error.
std::string run(const palpate::ViewerOptions& options)
{
  const bool draws = options.window || (options.trial.empty() && options.pictures);
  std::string error = palpate::outputProblem(options);
  if (error.empty() && draws)
  {
    error = palpate::displayProblem();
  }
  NeededModules modules;
  if (error.empty())
  {
    error = loadModules(options, modules);
  }
  if (!error.empty())
  {
    return error;
  }
  if (options.compare)
  {
    return options.window ? modules.comparison->compareInWindow(options)
                          : modules.comparison->drawComparison(options);
  }
  palpate::ViewerScene scene;
  error = palpate::makeViewerScene(options, scene);
  for (const std::string& note : scene.notes)
  {
    std::fprintf(stderr, "palpate: %s\n", note.c_str());
  }
  return error.empty() ? run(options, scene, modules) : error;
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
  // These signals are ignored, because the write call also reports the fault, and a signal must not
  // end the process while a force acts on the hand.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // A program may choose the backend of VTK's loops, whereas a library must leave this choice to
  // its host.
  vtkSMPTools::SetBackend("STDThread");
  if (std::getenv("PALPATE_THREADS") != nullptr)
  {
    vtkSMPTools::Initialize(static_cast<int>(palpate::threadCount()));
  }
  const std::string error = run(options);
  return error.empty() ? EXIT_SUCCESS : fail(error);
}
