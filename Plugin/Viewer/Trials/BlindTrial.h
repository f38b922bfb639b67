// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BlindTrial_h
#define palpate_BlindTrial_h

#include "ResponseSet.h"
#include "ViewerScene.h"
#include "Trials/TrialLog.h"
#include "Trials/TrialPlan.h"
#include "ViewerOptions.h"

#include <chrono>
#include <string>
#include <vector>

class vtkHapticSession;

namespace palpate
{
/**
 * A blind comparison in progress. The class stores the alternatives that X and Y stand for, changes
 * the session to X or Y, and writes the log. Window and console know only X and Y, not the
 * alternatives.
 *
 * Body, device and force factor are the same for all alternatives, so that the rendered forces have
 * the same ratios as the computed forces.
 */
class BlindTrial
{
public:
  /// Plans the trials, and attaches responses that the alternatives need and the scene lacks.
  /// Returns "" or an error that names the alternative.
  std::string prepare(
    const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses);
  /// Opens the log. Must be called after the device of the session has been chosen. Returns "" or
  /// an error.
  std::string open(const ViewerOptions& options, const ViewerScene& scene,
    const ResponseSet& responses, vtkHapticSession* session);

  std::size_t numberOfTrials() const { return this->Plan.size(); }
  bool isOver() const { return this->Current >= this->Plan.size(); }
  bool showsX() const { return this->ShowsX; }
  /// Title of the current trial, such as "trial 3 of 20".
  std::string title() const;
  const std::string& question() const { return this->Head.question; }

  /// Begins the current trial. The session renders X.
  void begin();
  /// Makes the session render X or Y. A running session changes to it immediately.
  void show(bool x);
  void switchOver();
  /// Logs the answer. Then begin() must be called for the next trial. Returns "" or an error.
  std::string answer(bool choseX);

  /// Returns the result of all answers so far, as lines of text.
  std::vector<std::string> summary() const;

private:
  /// Finds the response of an alternative, or makes it if it does not exist.
  std::string chooseResponse(const ViewerScene& scene, const TrialChoice& choice,
    double maximumDeflection, ResponseSet& responses);
  void apply(std::size_t alternative);

  std::vector<TrialChoice> Choices;
  std::vector<std::string> ResponseNames; ///< response names of the alternatives
  std::vector<Trial> Plan;
  TrialHead Head;
  TrialLog Log;
  TrialRecord Record;
  vtkHapticSession* Session = nullptr;
  std::size_t Current = 0;
  bool ShowsX = true;
  int Switches = 0;
  std::chrono::steady_clock::time_point BeginTime;
};
} // namespace palpate

#endif
