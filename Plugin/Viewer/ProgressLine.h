// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ProgressLine_h
#define palpate_ProgressLine_h

#include <chrono>
#include <string>

class vtkAlgorithm;

namespace palpate
{
/// Shows the progress of a long step on the error stream. On a terminal the progress is one line,
/// which is overwritten, and erased at the end. Otherwise a new line is printed every ten seconds.
class ProgressLine
{
public:
  /// `step` is the description of the step, such as "the body is filled".
  explicit ProgressLine(const std::string& step);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the completed fraction. Always returns true, so that the work continues.
  bool show(double done);

private:
  using Clock = std::chrono::steady_clock;

  std::string Step;
  bool IsTerminal;
  Clock::time_point Next; ///< the next time at which the progress is shown
  bool IsShown = false;
};

/// Updates an algorithm and shows its progress. Errors are returned as by updateQuietly.
std::string updateWithProgress(vtkAlgorithm* algorithm, const std::string& step);
} // namespace palpate

#endif
