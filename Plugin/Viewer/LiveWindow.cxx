// SPDX-License-Identifier: BSD-3-Clause
#include "LiveWindow.h"

#include "LiveSetup.h"
#include "LiveTouch.h"
#include "ModelChoice.h"
#include "SessionSettings.h"

#include <cstdio>

namespace palpate
{
namespace
{
const char* const Help = "? or h: keys and mouse";

void tell(const ResponseSet& responses, int tool)
{
  const std::string name = responses.tools[static_cast<std::size_t>(tool)]->GetDescription();
  std::printf("tool: %s\n", name.c_str());
  std::fflush(stdout);
}
} // namespace

std::string runLive(const ViewerOptions& options, const TouchScene& scene)
{
  ResponseSet responses;
  vtkNew<vtkContactSetup> setup;
  std::string error = makeLiveSetup(options, scene, setup, responses);
  if (!error.empty())
  {
    return error;
  }
  ModelChoice choice;
  error = chooseModel(options, scene, responses, choice);
  if (!error.empty())
  {
    return error;
  }
  LiveTouch live(options, scene, responses);
  live.session()->SetBody(choice.body); // until the panel changes what is felt
  error = chooseDevice(options, responses, live.session());
  if (!error.empty())
  {
    return error;
  }
  placeDevice(scene, responses, live.session());
  live.showHelp(choice.reason.empty() ? Help : Help + ("\n" + shortReason(choice)));
  live.usePanel(setup);
  live.onTool([&responses](int tool) { tell(responses, tool); });
  live.open();
  error = startQuietly(live.session());
  if (!error.empty())
  {
    return error;
  }
  if (!choice.reason.empty())
  {
    std::printf("choice: %s\n", choice.reason.c_str());
  }
  tell(responses, 0);
  return live.run();
}
} // namespace palpate
