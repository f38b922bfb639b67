// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Trials/TrialLog.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>

namespace palpate
{
namespace
{
const char* const FirstLine = "# palpate trial 1";
const char* const Columns = "trial,x,y,answer,chosen,correct,seconds,switches";
constexpr std::size_t Letters = 26;

template <class Number>
std::string written(Number value)
{
  char buffer[40];
  return { buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr };
}

template <class Number>
bool read(std::string_view text, Number& value)
{
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

bool read(std::string_view text, double& value)
{
  return read<double>(text, value) && std::isfinite(value);
}

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

std::string headText(const TrialHead& head)
{
  std::string text = std::string(FirstLine) + "\n# question: " + head.question +
    "\n# right answer: " + (head.hasRightAnswer ? "the larger intensity" : "none") + "\n";
  for (std::size_t i = 0; i < head.alternatives.size(); ++i)
  {
    const std::string letter = letterOf(static_cast<int>(i));
    text.append("# alternative ").append(letter).append(": ").append(head.alternatives[i].name);
    text.append("\n# intensity ").append(letter).append(": ");
    text.append(written(head.alternatives[i].intensity)).append("\n");
  }
  return text + "# seed: " + written(head.seed) + "\n# force factor: " + written(head.forceFactor) +
    "\n# device: " + head.device + "\n# started: " + head.started + "\n" + Columns + "\n";
}

/// What stands after `key` in a line that begins with it.
bool takeValue(std::string_view line, std::string_view key, std::string_view& value)
{
  if (line.substr(0, key.size()) != key)
  {
    return false;
  }
  value = line.substr(key.size());
  return true;
}

/// One line of the head; false if it is none.
bool readHeadLine(std::string_view line, TrialHead& head)
{
  std::string_view value;
  if (takeValue(line, "# question: ", value))
  {
    head.question = value;
    return true;
  }
  if (takeValue(line, "# right answer: ", value))
  {
    head.hasRightAnswer = value == "the larger intensity";
    return head.hasRightAnswer || value == "none";
  }
  if (takeValue(line, "# alternative ", value))
  {
    // Letters in their order.
    const bool isNext = head.alternatives.size() < Letters &&
      takeValue(value, letterOf(static_cast<int>(head.alternatives.size())) + ": ", value);
    head.alternatives.push_back({ std::string(value), 0.0 });
    return isNext;
  }
  if (takeValue(line, "# intensity ", value))
  {
    return !head.alternatives.empty() &&
      takeValue(value, letterOf(static_cast<int>(head.alternatives.size()) - 1) + ": ", value) &&
      read(value, head.alternatives.back().intensity);
  }
  if (takeValue(line, "# device: ", value))
  {
    head.device = value;
    return true;
  }
  if (takeValue(line, "# started: ", value))
  {
    head.started = value;
    return true;
  }
  return (takeValue(line, "# seed: ", value) && read(value, head.seed)) ||
    (takeValue(line, "# force factor: ", value) && read(value, head.forceFactor));
}

bool readLetter(std::string_view text, std::size_t alternatives, int& number)
{
  number = text.size() == 1 ? text[0] - 'A' : -1;
  return number >= 0 && static_cast<std::size_t>(number) < alternatives;
}

/// The row of trial `number`, which must agree with itself.
bool readRow(std::string_view line, const TrialHead& head, int number, TrialAnswer& answer)
{
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin <= line.size();)
  {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  int trial = 0;
  int chosen = 0;
  if (words.size() != 8 || !read(words[0], trial) || trial != number ||
    !readLetter(words[1], head.alternatives.size(), answer.trial.x) ||
    !readLetter(words[2], head.alternatives.size(), answer.trial.y) ||
    !(words[3] == "X" || words[3] == "Y") ||
    !readLetter(words[4], head.alternatives.size(), chosen) || !read(words[6], answer.seconds) ||
    !read(words[7], answer.switches))
  {
    return false;
  }
  answer.choseX = words[3] == "X";
  const int right = isRight(head, answer);
  return answer.trial.x != answer.trial.y && chosen == chosenBy(answer) && answer.seconds >= 0.0 &&
    answer.switches >= 0 &&
    words[5] ==
    (right < 0       ? ""
        : right == 1 ? "1"
                     : "0");
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
    return "the trial log '" + path + "' exists already and is not overwritten";
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
    std::error_code ignored; // it may never have been there
    std::filesystem::remove(path, ignored);
  }
  return error;
}

std::string TrialLog::append(const TrialAnswer& answer)
{
  const int right = isRight(this->Head, answer);
  std::ostringstream row;
  row << ++this->Rows << ',' << letterOf(answer.trial.x) << ',' << letterOf(answer.trial.y) << ','
      << (answer.choseX ? 'X' : 'Y') << ',' << letterOf(chosenBy(answer)) << ','
      << (right < 0       ? ""
             : right == 1 ? "1"
                          : "0")
      << ',' << written(answer.seconds) << ',' << answer.switches << '\n';
  return this->write(row.str());
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
  this->File.close(); // which tries once more
  std::error_code ignored;
  if (std::filesystem::is_regular_file(this->Path, ignored))
  {
    std::filesystem::resize_file(this->Path, this->Size, ignored); // no half of a row stays
  }
  return this->Fault;
}

std::string readTrialLog(const std::string& path, TrialRecord& record)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return "cannot read the trial log '" + path + "'";
  }
  TrialRecord result;
  std::string line;
  bool inHead = true;
  int number = 0;
  while (std::getline(file, line))
  {
    ++number;
    // A row without an end of line was being written when all ended.
    bool isGood = !file.eof();
    if (number == 1)
    {
      isGood = isGood && line == FirstLine;
    }
    else if (inHead && line == Columns)
    {
      inHead = false;
      isGood = isGood && result.head.alternatives.size() > 1;
    }
    else if (inHead)
    {
      isGood = isGood && readHeadLine(line, result.head);
    }
    else
    {
      result.answers.emplace_back();
      isGood = isGood &&
        readRow(line, result.head, static_cast<int>(result.answers.size()), result.answers.back());
    }
    if (!isGood)
    {
      std::string error = path + ":" + std::to_string(number);
      return error.append(": not a line of a trial log here: '").append(line).append("'");
    }
  }
  if (file.bad() || inHead)
  {
    return path + ": ends within the head of a trial log";
  }
  record = std::move(result);
  return {};
}
} // namespace palpate
