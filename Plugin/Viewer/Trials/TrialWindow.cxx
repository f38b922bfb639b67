// SPDX-License-Identifier: BSD-3-Clause
#include "TrialRuns.h"

#include "BlindTrial.h"
#include "HapticWindow.h"
#include "SessionSettings.h"

#include <cstdio>

namespace palpate
{
namespace
{
const char* const TrialHelp = "space: the other of the two   1: X   2: Y   ?: more";
const char* const TrialKeys = "? or h\tthis help, on and off\n"
                              "space\tthe other of the two under the hand\n"
                              "1  2\tthe answer: X, Y\n"
                              "q\tend\n"
                              "\n"
                              "mouse on the body\tthe hand hovers under the pointer\n"
                              "left button\tpress and slide\n"
                              "wheel\tpress deeper, or less deep\n"
                              "left next to the body\torbit\n"
                              "middle, right\tpan, zoom";

/// Asks the question of the current trial. Closes the window if there are no more trials.
void ask(HapticWindow& live, BlindTrial& trial)
{
  if (trial.isOver())
  {
    live.close();
    return;
  }
  trial.begin();
  std::printf("%s\n", trial.title().c_str());
  std::fflush(stdout);
}

void showState(HapticWindow& live, const BlindTrial& trial)
{
  live.view()->SetRemark(trial.title() + ", under the hand: " + (trial.showsX() ? "X" : "Y") +
    "\n" + trial.question() + " 1: X, 2: Y");
}
} // namespace

std::string runTrialWindow(const ViewerOptions& options, const ViewerScene& scene)
{
  ResponseSet responses;
  BlindTrial trial;
  std::string error = prepareResponses(options, scene, responses);
  if (error.empty())
  {
    error = trial.prepare(options, scene, responses);
  }
  if (!error.empty())
  {
    return error;
  }
  HapticWindow live(options, scene, responses);
  live.view()->SetBlind(true);
  live.style()->SetKeyHelp(TrialKeys);
  error = chooseDevice(options, responses, live.session());
  if (error.empty() && !live.session()->GetDevice()->GetOutputsForce())
  {
    std::fprintf(stderr,
      "palpate: warning: the device '%s' gives no force to the hand; give --device\n",
      options.device.c_str());
  }
  if (error.empty())
  {
    placeDevice(scene, responses, live.session());
    error = startQuietly(live.session());
  }
  if (error.empty())
  {
    error = trial.open(options, scene, responses, live.session());
  }
  if (!error.empty())
  {
    return error;
  }
  live.showHelp(TrialHelp);
  live.onSpace(
    [&]
    {
      trial.switchOver();
      showState(live, trial);
    });
  std::string logError;
  live.onNumber(
    [&](int number)
    {
      if (number > 1 || trial.isOver())
      {
        return;
      }
      logError = trial.answer(number == 0);
      ask(live, trial);
      if (!logError.empty())
      {
        live.close();
      }
      else if (!trial.isOver())
      {
        showState(live, trial);
      }
    });
  ask(live, trial);
  showState(live, trial);
  live.open();
  error = live.run();
  if (!trial.isOver())
  {
    std::printf("ended before %s was answered\n", trial.title().c_str());
  }
  for (const std::string& line : trial.summary())
  {
    std::printf("%s\n", line.c_str());
  }
  return logError.empty() ? error : logError;
}
} // namespace palpate
