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
/// One of the alternatives compared.
struct TrialAlternative
{
  std::string name;       ///< one line, as given: "sphere:6.35"
  double intensity = 0.0; ///< of what the question asks for, N; 0: none
};

/// The head of a log.
struct TrialHead
{
  std::vector<TrialAlternative> alternatives; ///< two or more
  std::string question;                       ///< one line
  /// Whether the alternative with the larger intensity is the right answer.
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
 * written as soon as it is given, so that an aborted session keeps all answers. A row for which the
 * disk has no room is an error, and leaves the rows before it unchanged.
 *
 *   # palpate trial 1
 *   # question: Which one pushes back more?
 *   # alternative A: sphere:6.35
 *   # intensity A: 1.25
 *   ...
 *   trial,x,y,answer,chosen,correct,seconds,switches
 *   1,B,A,X,B,1,3.25,2
 *
 * Alternatives are letters from A on; `correct` is empty if no answer is right. An existing file is
 * not overwritten, as a log cannot be recovered.
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
  std::uintmax_t Size = 0; ///< of the file, without a partly written row
  std::string Fault;       ///< after which nothing more is written
};

/// 1: right, 0: wrong, -1: no answer to this trial is right.
PALPATE_EXPORT int isRight(const TrialHead& head, const TrialAnswer& answer);

/// Reads a log. Returns an error that names file and line and leaves the record as it was, or "".
PALPATE_EXPORT std::string readTrialLog(const std::string& path, TrialRecord& record);
} // namespace palpate

#endif
