// SPDX-License-Identifier: BSD-3-Clause
#include "Trials/TrialLog.h"

#include "Mechanics/Files/CsvReader.h"
#include "Mechanics/Files/CsvRow.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
const char* const FirstLine = "palpate trial 1";
const char* const Columns = "trial,x,y,answer,chosen,correct,seconds,switches";
enum Column : std::size_t
{
  Number,
  X,
  Y,
  Answer,
  Chosen,
  Correct,
  Seconds,
  Switches,
  ColumnCount
};
constexpr std::size_t Letters = 26;

bool isOneLine(const std::string& text)
{
  return text.find_first_of("\r\n") == std::string::npos;
}

std::string letterOf(int alternative)
{
  return { static_cast<char>('A' + alternative) };
}

int chosenBy(const TrialAnswer& answer)
{
  return answer.choseX ? answer.trial.x : answer.trial.y;
}

/// Returns the text in the column `correct` for an answer. The text is empty if the trial has no
/// right answer.
const char* correctText(const TrialHead& head, const TrialAnswer& answer)
{
  const int right = isRight(head, answer);
  return right < 0 ? "" : right == 1 ? "1" : "0";
}

std::string headText(const TrialHead& head)
{
  std::string text = "# " + std::string(FirstLine) + "\n# question: " + head.question +
    "\n# right answer: " + (head.hasRightAnswer ? "the larger intensity" : "none") + "\n";
  for (std::size_t i = 0; i < head.alternatives.size(); ++i)
  {
    const std::string letter = letterOf(static_cast<int>(i));
    text.append("# alternative ").append(letter).append(": ").append(head.alternatives[i].name);
    text.append("\n# intensity ").append(letter).append(": ");
    text.append(shortestDecimals(head.alternatives[i].intensity)).append("\n");
  }
  return text + "# seed: " + shortestDecimals(head.seed) +
    "\n# force factor: " + shortestDecimals(head.forceFactor) + "\n# device: " + head.device +
    "\n# started: " + head.started + "\n" + Columns + "\n";
}

/// Reads one line of the head after the first line. Returns false if the line does not belong to
/// the head.
bool readHeadLine(const CsvComment& line, TrialHead& head)
{
  auto& alternatives = head.alternatives;
  const auto isOf = [&line](const char* what, std::size_t alternative)
  { return alternative < Letters && line.key == what + letterOf(static_cast<int>(alternative)); };
  if (isOf("alternative ", alternatives.size())) // the letters of the alternatives must be in order
  {
    alternatives.push_back({ std::string(line.value), 0.0 });
    return true;
  }
  if (!alternatives.empty() && isOf("intensity ", alternatives.size() - 1))
  {
    return readNumber(line.value, alternatives.back().intensity);
  }
  if (line.key == "right answer")
  {
    head.hasRightAnswer = line.value == "the larger intensity";
    return head.hasRightAnswer || line.value == "none";
  }
  for (const auto& [key, text] : { std::pair{ "question", &head.question },
         std::pair{ "device", &head.device }, std::pair{ "started", &head.started } })
  {
    if (line.key == key)
    {
      *text = line.value;
      return true;
    }
  }
  return (line.key == "seed" && readNumber(line.value, head.seed)) ||
    (line.key == "force factor" && readNumber(line.value, head.forceFactor));
}

bool readLetter(std::string_view text, std::size_t alternatives, int& number)
{
  number = text.size() == 1 ? text[0] - 'A' : -1;
  return number >= 0 && static_cast<std::size_t>(number) < alternatives;
}

/// Reads the row of the trial with the given number. Returns false if the row is not consistent.
bool readRow(const CsvReader& csv, const TrialHead& head, int number, TrialAnswer& answer)
{
  int trial = 0;
  int chosen = 0;
  const std::size_t count = head.alternatives.size();
  if (!readNumber(csv.text(Number), trial) || trial != number ||
    !readLetter(csv.text(X), count, answer.trial.x) ||
    !readLetter(csv.text(Y), count, answer.trial.y) ||
    !(csv.text(Answer) == "X" || csv.text(Answer) == "Y") ||
    !readLetter(csv.text(Chosen), count, chosen) ||
    !readNumber(csv.text(Seconds), answer.seconds) ||
    !readNumber(csv.text(Switches), answer.switches))
  {
    return false;
  }
  answer.choseX = csv.text(Answer) == "X";
  return answer.trial.x != answer.trial.y && chosen == chosenBy(answer) && answer.seconds >= 0.0 &&
    answer.switches >= 0 && csv.text(Correct) == correctText(head, answer);
}
} // namespace

int isRight(const TrialHead& head, const TrialAnswer& answer)
{
  const auto intensity = [&head](int alternative)
  { return head.alternatives[static_cast<std::size_t>(alternative)].intensity; };
  const double x = intensity(answer.trial.x);
  const double y = intensity(answer.trial.y);
  if (!head.hasRightAnswer || x == y)
  {
    return -1;
  }
  return answer.choseX == (x > y) ? 1 : 0;
}

std::string TrialLog::open(const std::string& path, const TrialHead& head)
{
  const std::size_t count = head.alternatives.size();
  if (count < 2 || count > Letters)
  {
    return "a trial compares 2 to 26 alternatives, not " + std::to_string(count);
  }
  bool isLined = isOneLine(head.question) && isOneLine(head.device) && isOneLine(head.started);
  for (const TrialAlternative& alternative : head.alternatives)
  {
    isLined = isLined && isOneLine(alternative.name) && std::isfinite(alternative.intensity);
  }
  if (!isLined)
  {
    return "the head of the trial log '" + path +
      "' has a text of several lines, or an intensity that is not finite";
  }
  if (std::ifstream(path).good())
  {
    return "the trial log '" + path + "' already exists and is not overwritten";
  }
  this->Path = path;
  this->Head = head;
  this->Rows = 0;
  this->Size = 0;
  this->Fault.clear();
  this->File.open(path, std::ios::binary);
  if (!this->File)
  {
    return this->fail(errno);
  }
  std::string error = this->write(headText(head));
  if (!error.empty())
  {
    std::error_code ignored; // the file may not exist
    std::filesystem::remove(path, ignored);
  }
  return error;
}

std::string TrialLog::append(const TrialAnswer& answer)
{
  return this->write(CsvRow()
                       .number(++this->Rows)
                       .text(letterOf(answer.trial.x))
                       .text(letterOf(answer.trial.y))
                       .text(answer.choseX ? "X" : "Y")
                       .text(letterOf(chosenBy(answer)))
                       .text(correctText(this->Head, answer))
                       .number(answer.seconds)
                       .number(answer.switches)
                       .line());
}

std::string TrialLog::write(const std::string& text)
{
  if (!this->Fault.empty())
  {
    return this->Fault;
  }
  errno = 0;
  this->File << text << std::flush;
  if (!this->File)
  {
    return this->fail(errno);
  }
  this->Size += text.size();
  return {};
}

std::string TrialLog::fail(int reason)
{
  this->Fault = "cannot write the trial log '" + this->Path + "': " + std::strerror(reason);
  this->File.close(); // close() tries to write the buffered row again
  std::error_code ignored;
  if (std::filesystem::is_regular_file(this->Path, ignored))
  {
    // Removes an incomplete row from the file.
    std::filesystem::resize_file(this->Path, this->Size, ignored);
  }
  return this->Fault;
}

std::string readTrialLog(const std::string& path, TrialRecord& record)
{
  CsvReader csv(path);
  TrialRecord result;
  bool isFirst = true;
  bool inHead = true;
  csv.comment = [&](std::string_view text) -> std::string
  {
    const bool isGood = std::exchange(isFirst, false)
      ? text == FirstLine
      : inHead && readHeadLine(CsvComment(text), result.head);
    return isGood ? "" : "not a line of the head of a trial log";
  };
  const bool isBegun = csv.header(
    { "trial", "x", "y", "answer", "chosen", "correct", "seconds", "switches" }, ColumnCount);
  inHead = false;
  if (isBegun && (isFirst || result.head.alternatives.size() < 2))
  {
    csv.fail("the head of a trial log, or an alternative of it, is missing");
  }
  while (csv.next())
  {
    result.answers.emplace_back();
    // A last row without a line break was not written completely, and is rejected.
    if (!csv.endsLine() ||
      !readRow(csv, result.head, static_cast<int>(result.answers.size()), result.answers.back()))
    {
      csv.fail("not an answer to this trial");
    }
  }
  if (csv.fault().empty())
  {
    record = std::move(result);
  }
  return csv.fault();
}
} // namespace palpate
