// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshFiles/FileWords.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"

namespace palpate
{
namespace
{
constexpr std::string_view Blanks = " \t\r\v\f";
constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";
} // namespace

bool FileWords::nextLine()
{
  this->Place = 0;
  if (!std::getline(this->Stream, this->Line))
  {
    this->Line.clear();
    return false;
  }
  if (++this->Number == 1 && this->Line.compare(0, ByteOrderMark.size(), ByteOrderMark) == 0)
  {
    this->Place = ByteOrderMark.size();
  }
  const auto isContinued = [this]
  {
    const std::size_t last = this->Line.find_last_not_of(Blanks);
    return this->Continued != '\0' && last != std::string::npos &&
      this->Line[last] == this->Continued;
  };
  std::string more;
  while (isContinued())
  {
    this->Line[this->Line.find_last_not_of(Blanks)] = ' ';
    if (!std::getline(this->Stream, more))
    {
      break;
    }
    ++this->Number;
    this->Line += more;
  }
  return true;
}

std::string_view FileWords::word()
{
  const std::string_view line = this->Line;
  const std::size_t begin = line.find_first_not_of(Blanks, this->Place);
  if (begin == std::string_view::npos)
  {
    this->Place = line.size();
    return {};
  }
  const std::size_t end = line.find_first_of(Blanks, begin);
  this->Place = end == std::string_view::npos ? line.size() : end;
  return line.substr(begin, this->Place - begin);
}

std::string FileWords::shown(std::string_view word)
{
  constexpr std::size_t Shown = 20;
  return joined('\'', word.substr(0, Shown), word.size() > Shown ? "..." : "", '\'');
}

bool FileWords::number(float& value, std::string_view& wrong)
{
  wrong = this->word();
  const std::string_view digits = wrong.substr(wrong.size() > 1 && wrong[0] == '+' ? 1 : 0);
  // The value is read as double, because reading a float would reject numbers that are too small
  // for a float.
  double read = 0.0;
  const bool isNumber = readNumber(digits, read);
  value = isNumber ? static_cast<float>(read) : 0.0F;
  return isNumber && std::isfinite(value);
}
} // namespace palpate
