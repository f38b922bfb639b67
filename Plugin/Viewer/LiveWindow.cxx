// SPDX-License-Identifier: BSD-3-Clause
#include "LiveWindow.h"

#include "LiveTouch.h"
#include "SessionSettings.h"

#include <cstdio>

namespace palpate
{
namespace
{
const char* const Help = "left on the body: press and slide   wheel while pressing: depth   "
                         "left beside it: orbit   1-9: tool   q: quit";

void show(LiveTouch& live, const ResponseSet& responses, std::size_t tool)
{
  live.chooseLook(tool);
  std::printf("tool: %s\n", responses.tools[tool]->GetDescription().c_str());
  std::fflush(stdout);
}

/// Another tool under the hand; the force goes over to it, also in contact.
void choose(LiveTouch& live, const ResponseSet& responses, std::size_t tool)
{
  if (tool < responses.tools.size())
  {
    live.session()->SetResponseName(responses.names[tool]);
    live.session()->ApplyChanges();
    show(live, responses, tool);
  }
}
} // namespace

std::string runLive(const ViewerOptions& options, const TouchScene& scene)
{
  ResponseSet responses;
  std::string error = prepareResponses(options, scene, responses);
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
  live.onNumber(
    [&live, &responses](int number) { choose(live, responses, static_cast<std::size_t>(number)); });
  live.open();
  error = startQuietly(live.session());
  if (!error.empty())
  {
    return error;
  }
  show(live, responses, 0);
  return live.run();
}
} // namespace palpate
