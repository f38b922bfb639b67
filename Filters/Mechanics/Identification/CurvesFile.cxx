// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Identification/CurvesFile.h"

#include "Mechanics/Identification/NumberedLines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <string_view>

namespace palpate
{
namespace
{
using NumberedLines::trim;

enum Column : std::size_t
{
  Site,
  X,
  Y,
  Z,
  Deflection,
  Force,
  Time,
  Phase,
  ColumnCount
};
constexpr std::array<std::string_view, ColumnCount> Names = { "site", "x_mm", "y_mm", "z_mm",
  "deflection_mm", "force_N", "time_s", "phase" };
constexpr std::size_t RequiredColumns = Time;
constexpr std::size_t Absent = static_cast<std::size_t>(-1);

std::vector<std::string_view> split(std::string_view line)
{
  std::vector<std::string_view> fields;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(','))
  {
    fields.push_back(trim(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  fields.push_back(trim(line));
  return fields;
}

std::string quoted(std::string_view text)
{
  return "'" + std::string(text) + "'";
}

/// Reads line by line; every function returns what is wrong with the line, or "".
class Reader
{
public:
  std::string line(std::string_view text)
  {
    if (text.empty())
    {
      return {};
    }
    if (text.front() == '#')
    {
      return this->comment(trim(text.substr(1)));
    }
    return this->Place.empty() ? this->header(split(text)) : this->row(split(text));
  }

  std::string tool(std::string_view text)
  {
    this->Result.toolText = text;
    std::string error;
    return parseTool(this->Result.toolText, this->Result.tool, error) ? std::string()
                                                                      : "tool: " + error;
  }

  std::string end() const
  {
    if (this->Place.empty())
    {
      return "there is no line with the names of the columns";
    }
    return this->Result.curves.empty() ? "there are no readings" : std::string();
  }

  std::string header(const std::vector<std::string_view>& fields)
  {
    if (this->Result.toolText.empty())
    {
      return "the head does not name the tool: '# tool: sphere:6.35' is missing";
    }
    std::array<std::size_t, ColumnCount> place{};
    place.fill(Absent);
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      const auto* const name = std::find(Names.begin(), Names.end(), fields[i]);
      if (name == Names.end())
      {
        return "column " + quoted(fields[i]) + " is not known";
      }
      std::size_t& at = place[static_cast<std::size_t>(name - Names.begin())];
      if (at != Absent)
      {
        return "column " + quoted(fields[i]) + " stands there twice";
      }
      at = i;
    }
    for (std::size_t i = 0; i < RequiredColumns; ++i)
    {
      if (place[i] == Absent)
      {
        return "column " + quoted(Names[i]) + " is missing";
      }
    }
    this->Place.assign(place.begin(), place.end());
    this->FieldCount = fields.size();
    return {};
  }

  std::string row(const std::vector<std::string_view>& fields)
  {
    if (fields.size() != this->FieldCount)
    {
      return "has " + std::to_string(fields.size()) + " fields instead of " +
        std::to_string(this->FieldCount);
    }
    const std::string site(fields[this->Place[Site]]);
    if (site.empty())
    {
      return "the site has no name";
    }
    const bool timed = this->Place[Time] != Absent;
    std::array<double, ColumnCount> value{};
    for (const Column column : { X, Y, Z, Deflection, Force, Time })
    {
      if (column == Time && !timed)
      {
        continue;
      }
      std::string error = this->number(fields, column, value[column]);
      if (!error.empty())
      {
        return error;
      }
    }
    CurvePhase phase = CurvePhase::Unknown;
    if (this->Place[Phase] != Absent && !readPhase(fields[this->Place[Phase]], phase))
    {
      return "phase: " + quoted(fields[this->Place[Phase]]) +
        " is not known; accepted are loading, unloading, hold";
    }

    const auto known = this->Index.emplace(site, this->Result.curves.size());
    const Eigen::Vector3d position(value[X], value[Y], value[Z]);
    if (known.second)
    {
      MeasuredCurve curve;
      curve.site = site;
      curve.position = position;
      this->Result.curves.push_back(std::move(curve));
    }
    MeasuredCurve& curve = this->Result.curves[known.first->second];
    if (curve.position != position)
    {
      return "site " + quoted(site) + " lies elsewhere than in its first row";
    }
    if (timed)
    {
      if (!curve.time.empty() && value[Time] < curve.time.back())
      {
        return "time_s decreases at site " + quoted(site);
      }
      curve.time.push_back(value[Time]);
    }
    if (this->Place[Phase] != Absent)
    {
      curve.phase.push_back(phase);
    }
    curve.deflection.push_back(value[Deflection]);
    curve.force.push_back(value[Force]);
    return {};
  }

  MeasuredCurves Result;

private:
  std::string comment(std::string_view text)
  {
    const std::size_t colon = text.find(':');
    const std::string_view key = trim(text.substr(0, colon));
    const std::string_view value =
      colon == std::string_view::npos ? std::string_view() : trim(text.substr(colon + 1));
    if (key == "tool")
    {
      if (!this->Place.empty() || !this->Result.toolText.empty())
      {
        return "a file has one tool, named in its head";
      }
      return this->tool(value);
    }
    if (key == "synthetic")
    {
      this->Result.synthetic = value.empty() ? "not said how" : value;
    }
    return {};
  }

  std::string number(
    const std::vector<std::string_view>& fields, Column column, double& value) const
  {
    const std::string_view text = fields[this->Place[column]];
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size() ||
      !std::isfinite(value))
    {
      return std::string(Names[column]) + ": " + quoted(text) + " is not a finite number";
    }
    return {};
  }

  static bool readPhase(std::string_view text, CurvePhase& phase)
  {
    phase = text == "loading" ? CurvePhase::Loading
      : text == "unloading"   ? CurvePhase::Unloading
      : text == "hold"        ? CurvePhase::Hold
                              : CurvePhase::Unknown;
    return phase != CurvePhase::Unknown || text.empty();
  }

  std::vector<std::size_t> Place; ///< of each column among the fields, once the header was read
  std::size_t FieldCount = 0;
  std::map<std::string, std::size_t> Index; ///< site -> curve
};

} // namespace

std::string readCurves(std::istream& stream, const std::string& name, MeasuredCurves& curves)
{
  Reader reader;
  std::string fault = NumberedLines::read(stream, name, reader);
  if (!fault.empty())
  {
    return fault;
  }
  reader.Result.file = name;
  curves = std::move(reader.Result);
  return {};
}

std::string readCurves(const std::string& path, MeasuredCurves& curves)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    return path + ": cannot be opened";
  }
  return readCurves(stream, path, curves);
}

std::string readCurves(const CurvesTable& table, MeasuredCurves& curves)
{
  Reader reader;
  std::vector<std::string_view> fields(table.columns.begin(), table.columns.end());
  std::string fault = reader.tool(table.tool);
  if (fault.empty())
  {
    fault = reader.header(fields);
  }
  std::vector<std::string> texts(fields.size());
  for (std::size_t row = 0; fault.empty() && row < table.rowCount; ++row)
  {
    for (std::size_t column = 0; column < fields.size(); ++column)
    {
      texts[column] = table.field(row, column);
      fields[column] = trim(texts[column]);
    }
    fault = reader.row(fields);
    if (!fault.empty())
    {
      fault.insert(0, "row " + std::to_string(row) + ": ");
    }
  }
  if (fault.empty())
  {
    fault = reader.end();
  }
  if (!fault.empty())
  {
    return table.name + ": " + fault;
  }
  reader.Result.file = table.name;
  curves = std::move(reader.Result);
  return {};
}
} // namespace palpate
