// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialLog_h
#define palpate_TrialLog_h

#include "Mechanics/PalpateExport.h"
#include "Haptics/Trials/TrialPlan.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace palpate
{
/// What is compared.
struct TrialAlternative
{
  std::string name;       ///< one line, as given: "sphere:6.35"
  double intensity = 0.0; ///< what the question asks for, N; 0: it has none
};

/// What a log says of itself before the first answer.
struct TrialHead
{
  std::vector<TrialAlternative> alternatives; ///< two or more
  std::string question;                       ///< one line
  /// Whether the alternative of the larger intensity is the right answer.
  bool hasRightAnswer = false;
  std::uint64_t seed = 0;
  double forceFactor = 1.0; ///< common to all alternatives
  std::string device;       ///< one line, in words
  std::string started;      ///< date and time
};

/// One answer: a row of the log.
struct TrialAnswer
{
  Trial trial;
  bool choseX = false;
  double seconds = 0.0; ///< from the beginning of the trial to the answer
  int switches = 0;     ///< between X and Y before the answer
};

/// A log read back.
struct TrialRecord
{
  TrialHead head;
  std::vector<TrialAnswer> answers;
};

/**
 * The log of a blind comparison: CSV, lines beginning with '#' in the head, then a row per answer,
 * handed to the system as soon as it is given, so that a session that breaks off keeps all it has.
 * A row for which the disk has no room is told, and leaves the rows before it as they were.
 *
 *   # palpate trial 1
 *   # question: Which one pushes back more?
 *   # alternative A: sphere:6.35
 *   # intensity A: 1.25
 *   ...
 *   trial,x,y,answer,chosen,correct,seconds,switches
 *   1,B,A,X,B,1,3.25,2
 *
 * Alternatives are letters from A on; `correct` is empty where no answer is right. A log holds what
 * cannot be had again: an existing file is not overwritten.
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
  std::uintmax_t Size = 0; ///< of the file, without what was written in part
  std::string Fault;       ///< after which nothing is written any more
};

/// 1: right, 0: wrong, -1: no answer to this trial is right.
PALPATE_EXPORT int isRight(const TrialHead& head, const TrialAnswer& answer);

/// Reads a log. Returns an error that names file and line and leaves the record as it was, or "".
PALPATE_EXPORT std::string readTrialLog(const std::string& path, TrialRecord& record);
} // namespace palpate

#endif
