// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/ProfileFile.h"

#include <charconv>
#include <fstream>

namespace palpate
{
namespace
{
/// The text without white space at its ends.
std::string trimmed(const std::string& text)
{
  const char* const space = " \t\r";
  const std::size_t begin = text.find_first_not_of(space);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(space) - begin + 1);
}

bool readNumber(const std::string& text, double& value)
{
  const std::string number = trimmed(text);
  const char* const end = number.data() + number.size();
  const auto result = std::from_chars(number.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

bool readPoint(const std::string& line, ProfilePoint& point)
{
  const std::size_t comma = line.find(',');
  return comma != std::string::npos && readNumber(line.substr(0, comma), point.r) &&
    readNumber(line.substr(comma + 1), point.f);
}
} // namespace

std::string readProfile(const std::string& file, std::vector<ProfilePoint>& points)
{
  std::ifstream stream(file);
  if (!stream)
  {
    return "cannot read the profile '" + file + "'";
  }
  std::vector<ProfilePoint> read;
  std::string text;
  bool headerAllowed = true;
  for (int number = 1; std::getline(stream, text); ++number)
  {
    std::string place = file;
    place.append(":").append(std::to_string(number)).append(": ");
    const std::string line = trimmed(text);
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    ProfilePoint point{};
    if (!readPoint(line, point))
    {
      // A header has two names; a first line with a digit in front is a point gone wrong.
      if (headerAllowed && line.find_first_of("0123456789+-.") != 0 &&
        line.find(',') != std::string::npos)
      {
        headerAllowed = false;
        continue;
      }
      return place.append("'").append(line).append("' is not a profile point r_mm,f_mm");
    }
    headerAllowed = false;
    read.push_back(point);
    const std::string fault = ProfileTool::checkLast(read);
    if (!fault.empty())
    {
      return place + fault;
    }
  }
  if (stream.bad())
  {
    return "cannot read the profile '" + file + "' to its end";
  }
  const std::string fault = ProfileTool::check(read);
  if (!fault.empty())
  {
    return file + ": " + fault;
  }
  points = read;
  return {};
}
} // namespace palpate
