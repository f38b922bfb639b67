// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialLog_h
#define palpate_TrialLog_h

#include "Mechanics/PalpateExport.h"
#include "Trials/TrialPlan.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace palpate
{
/// One of the compared alternatives.
struct TrialAlternative
{
  std::string name;       ///< one line, as given: "sphere:6.35"
  double intensity = 0.0; ///< intensity of the compared quantity, N; 0: none
};

/// The head of a log.
struct TrialHead
{
  std::vector<TrialAlternative> alternatives; ///< two or more
  std::string question;                       ///< one line
  /// Whether the answer with the larger intensity is right. If not, there is no right answer.
  bool hasRightAnswer = false;
  std::uint64_t seed = 0;
  double forceFactor = 1.0; ///< factor on the forces of all alternatives
  std::string device;       ///< description of the device, one line
  std::string started;      ///< date and time
};

/// One answer: a row of the log.
struct TrialAnswer
{
  Trial trial;
  bool choseX = false;
  double seconds = 0.0; ///< time from the beginning of the trial to the answer
  int switches = 0;     ///< number of switches between X and Y before the answer
};

/// A log as read from a file.
struct TrialRecord
{
  TrialHead head;
  std::vector<TrialAnswer> answers;
};

/**
 * The log of a blind comparison: a CSV file with a head of lines that begin with '#', then a row
 * per answer. A row is written as soon as the answer is given, so that an aborted session keeps all
 * answers. If the disk has no space for a row, this is an error, and the preceding rows are
 * unchanged.
 *
 *   # palpate trial 1
 *   # question: Which one pushes back more?
 *   # alternative A: sphere:6.35
 *   # intensity A: 1.25
 *   ...
 *   trial,x,y,answer,chosen,correct,seconds,switches
 *   1,B,A,X,B,1,3.25,2
 *
 * Alternatives are the letters A, B, …; `correct` is empty if no answer is right. An existing file
 * is not overwritten, because a log cannot be recovered.
 */
class PALPATE_EXPORT TrialLog
{
public:
  /// Creates the file and writes its head. Returns an error that names the file, or "".
  std::string open(const std::string& path, const TrialHead& head);
  /// Returns an error that names the file, or "".
  std::string append(const TrialAnswer& answer);

private:
  std::string write(const std::string& text);
  std::string fail(int reason);

  std::string Path;
  TrialHead Head;
  std::ofstream File;
  int Rows = 0;
  std::uintmax_t Size = 0; ///< size of the file without an incomplete row
  std::string Fault;       ///< the first error; after it nothing more is written
};

/// Returns 1 if the answer is right, 0 if it is wrong, -1 if this trial has no right answer.
PALPATE_EXPORT int isRight(const TrialHead& head, const TrialAnswer& answer);

/// Reads a log. Returns "", or an error that names file and line; `record` is then unchanged.
PALPATE_EXPORT std::string readTrialLog(const std::string& path, TrialRecord& record);
} // namespace palpate

#endif
