// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/ProfileFile.h"

#include "Mechanics/Files/CsvReader.h"

namespace palpate
{
std::string readProfile(const std::string& file, std::vector<ProfilePoint>& points)
{
  CsvReader csv(file);
  std::vector<ProfilePoint> read;
  for (bool isFirst = true; csv.next(); isFirst = false)
  {
    if (csv.size() != 2)
    {
      csv.fail("'" + std::string(csv.text(0)) + "' is not a profile point r_mm,f_mm");
    }
    // A header has two names. A first line that begins like a number is not a header, but a point
    // with an invalid number.
    else if (!isFirst || csv.text(0).find_first_of("0123456789+-.") == 0)
    {
      read.push_back({ csv.number(0), csv.number(1) });
      const std::string fault = ProfileTool::checkLast(read);
      if (!fault.empty())
      {
        csv.fail(fault);
      }
    }
  }
  const std::string fault = csv.fault().empty() ? ProfileTool::check(read) : std::string();
  if (!csv.fault().empty() || !fault.empty())
  {
    return csv.fault().empty() ? file + ": " + fault : csv.fault();
  }
  points = read;
  return {};
}
} // namespace palpate
