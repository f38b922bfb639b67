// SPDX-License-Identifier: BSD-3-Clause
#include "LiveWindow.h"

#include "LiveSetup.h"
#include "LiveTouch.h"
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
  LiveTouch live(options, scene, responses);
  error = chooseDevice(options, responses, live.session());
  if (!error.empty())
  {
    return error;
  }
  placeDevice(scene, responses, live.session());
  live.showHelp(Help);
  live.usePanel(setup);
  live.onTool([&responses](int tool) { tell(responses, tool); });
  live.open();
  error = startQuietly(live.session());
  if (!error.empty())
  {
    return error;
  }
  tell(responses, 0);
  return live.run();
}
} // namespace palpate
