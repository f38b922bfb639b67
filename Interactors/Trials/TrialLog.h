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
  std::string name;       ///< one line, as given by the user, such as "sphere:6.35"
  double intensity = 0.0; ///< intensity of the compared quantity, N; 0 if there is none
};

/// The head of a log.
struct TrialHead
{
  std::vector<TrialAlternative> alternatives; ///< at least two alternatives
  std::string question;                       ///< text of the question, one line
  /// Whether the answer with the larger intensity is right. If false, no answer counts as right.
  bool hasRightAnswer = false;
  std::uint64_t seed = 0;
  double forceFactor = 1.0; ///< factor by which the forces of all alternatives are multiplied
  std::string device;       ///< description of the device, one line
  std::string started;      ///< date and time of the start
};

/// One answer, which is one row of the log.
struct TrialAnswer
{
  Trial trial;
  bool choseX = false;
  double seconds = 0.0; ///< time from the beginning of the trial to the answer, s
  int switches = 0;     ///< number of switches between X and Y before the answer
};

/// The content of a log file.
struct TrialRecord
{
  TrialHead head;
  std::vector<TrialAnswer> answers;
};

/**
 * The log of a blind comparison: a CSV file with a head of lines that begin with '#', then a row
 * per answer. A row is written as soon as the answer is given, so that an aborted session keeps all
 * answers. If the disk has no space for a row, append returns an error, and the preceding rows are
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
 * The alternatives are named by the letters A, B, …. `correct` is empty if the trial has no right
 * answer. An existing file is not overwritten, because a log cannot be recovered.
 */
class PALPATE_EXPORT TrialLog
{
public:
  /// Creates the file and writes its head. Returns "" or an error that names the file.
  std::string open(const std::string& path, const TrialHead& head);
  /// Appends an answer to the file. Returns "" or an error that names the file.
  std::string append(const TrialAnswer& answer);

private:
  std::string write(const std::string& text);
  std::string fail(int reason);

  std::string Path;
  TrialHead Head;
  std::ofstream File;
  int Rows = 0;
  std::uintmax_t Size = 0; ///< size of the file without an incomplete row, bytes
  std::string Fault;       ///< the first error, after which nothing more is written
};

/// Returns 1 if the answer is right, 0 if it is wrong, -1 if this trial has no right answer.
PALPATE_EXPORT int isRight(const TrialHead& head, const TrialAnswer& answer);

/// Reads a log. Returns "" on success. Otherwise returns an error that names file and line, and
/// leaves `record` unchanged.
PALPATE_EXPORT std::string readTrialLog(const std::string& path, TrialRecord& record);
} // namespace palpate

#endif
