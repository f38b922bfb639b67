// SPDX-License-Identifier: BSD-3-Clause
#include "LiveWindow.h"

#include "LiveSetup.h"
#include "HapticWindow.h"
#include "SessionSettings.h"

#include <cstdio>

namespace palpate
{
namespace
{
const char* const Help = "? or h: keys and mouse";

void report(const ResponseSet& responses, int tool)
{
  const std::string name = responses.tools[static_cast<std::size_t>(tool)]->GetDescription();
  std::printf("tool: %s\n", name.c_str());
  std::fflush(stdout);
}

/// Prints the form of the present response and the reason for this form, whenever the form changes.
class ChoiceReport
{
public:
  explicit ChoiceReport(vtkContactSetup* setup)
    : Setup(setup)
  {
  }

  void update()
  {
    const std::string reason = this->Setup->GetChoice(this->Setup->GetChosenTool());
    if (reason != this->Reported)
    {
      this->Reported = reason;
      std::printf("choice: %s\n", reason.c_str());
      std::fflush(stdout);
    }
  }

private:
  vtkContactSetup* Setup;
  std::string Reported;
};
} // namespace

std::string runLive(const ViewerOptions& options, const ViewerScene& scene)
{
  ResponseSet responses;
  vtkNew<vtkContactSetup> setup;
  std::string error = makeLiveSetup(options, scene, setup, responses);
  if (!error.empty())
  {
    return error;
  }
  HapticWindow live(options, scene, responses);
  setup->ApplyTo(live.session());
  error = chooseDevice(options, responses, live.session());
  if (!error.empty())
  {
    return error;
  }
  error = addHands(options, live.session());
  if (!error.empty())
  {
    return error;
  }
  placeDevice(scene, responses, live.session());
  live.showHelp(Help);
  live.usePanel(setup);
  ChoiceReport choice(setup);
  if (options.verbose)
  {
    live.onFrame([&choice] { choice.update(); });
  }
  live.onTool([&responses](int tool) { report(responses, tool); });
  live.open();
  error = startQuietly(live.session());
  if (!error.empty())
  {
    return error;
  }
  report(responses, 0);
  return live.run();
}
} // namespace palpate
