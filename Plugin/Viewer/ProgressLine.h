// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ProgressLine_h
#define palpate_ProgressLine_h

#include <chrono>
#include <string>

class vtkAlgorithm;

namespace palpate
{
/// The progress of a long step on the error stream: on a terminal one line, which is overwritten
/// and in the end erased; elsewhere a line every ten seconds.
class ProgressLine
{
public:
  /// `step`: what is done, for example "the body is filled".
  explicit ProgressLine(const std::string& step);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the completed fraction. Returns true: the work goes on.
  bool show(double done);

private:
  using Clock = std::chrono::steady_clock;

  std::string Step;
  bool IsTerminal;
  Clock::time_point Next; ///< the next time at which the progress is shown
  bool IsShown = false;
};

/// As updateQuietly, with the progress of the algorithm.
std::string updateWithProgress(vtkAlgorithm* algorithm, const std::string& step);
} // namespace palpate

#endif
