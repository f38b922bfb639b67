// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/RecordedSetup.h"

#include "Mechanics/Files/CsvReader.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <iterator>

namespace palpate
{
namespace
{
constexpr std::string_view From = " from ";
constexpr std::string_view Seconds = " s";

/// Returns the text as one line: control characters become spaces.
std::string inOneLine(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return std::string(trimmed(text));
}

/// Splits "tool from 1.5 s" into "tool" and 1.5. A name without " from " remains unchanged. Returns
/// false if the time cannot be read.
bool splitTime(std::string_view& name, double& time)
{
  const std::size_t from = name.find(From);
  if (from == std::string_view::npos)
  {
    return true;
  }
  std::string_view number = name.substr(from + From.size());
  name = name.substr(0, from);
  if (number.size() <= Seconds.size() || number.substr(number.size() - Seconds.size()) != Seconds)
  {
    return false;
  }
  number.remove_suffix(Seconds.size());
  return readNumber(number, time);
}
} // namespace

void RecordedSetups::add(double time, const RecordedSetup& setup)
{
  while (this->All.size() > 1 && !(this->All.back().time < time))
  {
    this->All.pop_back();
  }
  if (this->All.size() == 1 && !(this->All.back().time < time))
  {
    this->All.back().setup = setup;
  }
  else if (this->All.empty() || !(this->All.back().setup == setup))
  {
    this->All.push_back({ time, setup });
  }
}

void RecordedSetups::keepNewest()
{
  if (this->All.size() > 1)
  {
    this->All.erase(this->All.begin(), this->All.end() - 1);
  }
}

RecordedSetups RecordedSetups::between(double begin, double end) const
{
  RecordedSetups part;
  if (const RecordedSetup* first = this->at(begin))
  {
    part.add(begin, *first);
  }
  for (const SetupSince& since : this->All)
  {
    if (since.time > begin && since.time <= end)
    {
      part.add(since.time, since.setup);
    }
  }
  return part;
}

void RecordedSetups::shift(double begin)
{
  for (SetupSince& since : this->All)
  {
    since.time -= begin;
  }
}

const RecordedSetup* RecordedSetups::at(double time) const
{
  const RecordedSetup* found = this->All.empty() ? nullptr : &this->All.front().setup;
  for (const SetupSince& since : this->All)
  {
    found = since.time <= time ? &since.setup : found;
  }
  return found;
}

std::vector<std::string> RecordedSetups::lines() const
{
  std::vector<std::string> lines;
  const RecordedSetup unknown;
  const RecordedSetup* before = &unknown;
  for (const SetupSince& since : this->All)
  {
    const std::string when = before == &unknown
      ? ""
      : std::string(From) + shortestDecimals(since.time) + std::string(Seconds);
    for (std::size_t part = 0; part < SetupPartNames.size(); ++part)
    {
      if (since.setup.texts[part] != before->texts[part])
      {
        lines.push_back(SetupPartNames[part] + when + ": " + inOneLine(since.setup.texts[part]));
      }
    }
    before = &since.setup;
  }
  return lines;
}

void RecordedSetups::readLine(std::string_view line)
{
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos)
  {
    return;
  }
  const CsvComment comment(line);
  std::string_view name = comment.key;
  double time = this->All.empty() ? 0.0 : this->All.front().time;
  const auto found = splitTime(name, time)
    ? std::find(SetupPartNames.begin(), SetupPartNames.end(), name)
    : SetupPartNames.end();
  if (found == SetupPartNames.end() || (!this->All.empty() && time < this->All.back().time))
  {
    return;
  }
  RecordedSetup setup = this->All.empty() ? RecordedSetup() : this->All.back().setup;
  setup.texts[static_cast<std::size_t>(std::distance(SetupPartNames.begin(), found))] =
    std::string(comment.value);
  this->add(time, setup);
}

std::string materialInWords(double youngsModulus, double poissonRatio)
{
  return joined("E = ", youngsModulus, " MPa, nu = ", poissonRatio);
}

std::string frictionInWords(const FrictionSettings& friction)
{
  if (friction.coefficient == 0.0)
  {
    return "none";
  }
  const std::string coefficient = joined("mu = ", friction.coefficient, ", ");
  if (friction.model == FrictionModel::ShapeDerived)
  {
    return joined(
      coefficient, "pre-sliding displacement from the response, nu = ", friction.poissonRatio);
  }
  const bool creeps = friction.model == FrictionModel::Dahl;
  return joined(coefficient, creeps ? "Dahl's creep, " : "elasto-plastic, ",
    friction.tangentialStiffness, " N/mm");
}

std::string differenceOf(const RecordedSetup& recorded, const RecordedSetup& here)
{
  std::string text;
  for (std::size_t part = 0; part < SetupPartNames.size(); ++part)
  {
    const std::string& there = recorded.texts[part];
    const std::string now = inOneLine(here.texts[part]);
    if (!there.empty() && !now.empty() && inOneLine(there) != now)
    {
      text += (text.empty() ? "" : ", ") + std::string(SetupPartNames[part]) + " " + there +
        " (here " + now + ")";
    }
  }
  return text;
}

std::string setupInWords(const RecordedSetup& setup)
{
  std::string text;
  for (std::size_t part = 0; part < SetupPartNames.size(); ++part)
  {
    if (!setup.texts[part].empty())
    {
      text +=
        (text.empty() ? "" : ", ") + std::string(SetupPartNames[part]) + " " + setup.texts[part];
    }
  }
  return text;
}

std::string replayInWords(const RecordedSetups& recorded, double time, const RecordedSetup& here)
{
  const RecordedSetup* then = recorded.at(time);
  if (!then)
  {
    return "Replay: the record names neither tool nor material";
  }
  const std::string difference = differenceOf(*then, here);
  return difference.empty() ? "Replay: recorded with " + setupInWords(*then)
                            : "Replay: recorded with another setup: " + difference;
}
} // namespace palpate
