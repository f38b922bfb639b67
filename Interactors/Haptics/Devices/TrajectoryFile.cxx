// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/TrajectoryFile.h"

#include "Mechanics/Identification/NumberedLines.h"
#include "Haptics/Devices/TrajectoryTable.h"
#include "Contact/WholeFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string_view>
#include <utility>

namespace palpate
{
namespace
{
using namespace TrajectoryTable;
using NumberedLines::trim;

constexpr std::size_t Block = 65536; // bytes that are written at once
constexpr std::size_t Absent = static_cast<std::size_t>(-1);

std::string quoted(std::string_view text)
{
  return "'" + std::string(text) + "'";
}

void append(std::string& line, double value)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  line.append(buffer.data(), end);
}

bool isWritten(const Trajectory& trajectory, std::size_t column)
{
  return column < ContactBegin ||
    (column < DeviceBegin ? trajectory.hasContact : trajectory.hasDevice);
}

TrajectoryRow rowOf(const Tick& tick)
{
  TrajectoryRow row;
  row.time = tick.time;
  row.tip = tick.tip;
  row.contact = tick.contact;
  row.idealForce = tick.contact.force.norm();
  const Numbers numbers = numbersOf(row);
  if (!std::all_of(numbers.begin() + 1, numbers.end(), [](double x) { return std::isfinite(x); }))
  {
    row = {};
    row.time = tick.time;
    row.contact.state = ContactState::Invalid;
  }
  return row;
}

/// A comma within double quotes does not part fields; a pair of quotes around a field goes.
void split(std::string_view line, std::vector<std::string_view>& fields)
{
  fields.clear();
  bool isQuoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i)
  {
    if (i < line.size() && line[i] == '"')
    {
      isQuoted = !isQuoted;
    }
    if (i == line.size() || (line[i] == ',' && !isQuoted))
    {
      std::string_view field = trim(line.substr(begin, i - begin));
      if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
      {
        field = trim(field.substr(1, field.size() - 2));
      }
      fields.push_back(field);
      begin = i + 1;
    }
  }
}

/// Reads line by line; every function returns what is wrong with the line, or "".
class Reader
{
public:
  std::string line(std::string_view text)
  {
    if (text.empty() || text.front() == '#')
    {
      return {};
    }
    split(text, this->Fields);
    return this->FieldCount == 0 ? this->header() : this->row();
  }

  std::string end() const
  {
    if (this->FieldCount == 0)
    {
      return "there is no line with the names of the columns";
    }
    return this->Result.rows.empty() ? "there are no lines with numbers" : std::string();
  }

  Trajectory Result;

private:
  std::string header()
  {
    this->Place.fill(Absent);
    for (std::size_t i = 0; i < this->Fields.size(); ++i)
    {
      const auto* const name = std::find(Names.begin(), Names.end(), this->Fields[i]);
      if (name == Names.end())
      {
        continue;
      }
      std::size_t& place = this->Place[static_cast<std::size_t>(name - Names.begin())];
      if (place != Absent)
      {
        return "column " + quoted(*name) + " stands there twice";
      }
      place = i;
    }
    this->Result.hasContact = this->hasAny(ContactBegin, DeviceBegin);
    this->Result.hasDevice = this->hasAny(DeviceBegin, ColumnCount);
    for (std::size_t column = 0; column < ColumnCount; ++column)
    {
      if (isWritten(this->Result, column) && this->Place[column] == Absent)
      {
        return "column " + quoted(Names[column]) + " is missing";
      }
    }
    this->FieldCount = this->Fields.size();
    return {};
  }

  bool hasAny(std::size_t begin, std::size_t end) const
  {
    return std::any_of(this->Place.begin() + begin, this->Place.begin() + end,
      [](std::size_t place) { return place != Absent; });
  }

  std::string row()
  {
    if (this->Fields.size() != this->FieldCount)
    {
      return "has " + std::to_string(this->Fields.size()) + " fields instead of " +
        std::to_string(this->FieldCount);
    }
    Numbers numbers{};
    for (std::size_t column = 0; column < ColumnCount; ++column)
    {
      if (!isWritten(this->Result, column))
      {
        continue;
      }
      const std::string_view text = this->Fields[this->Place[column]];
      const char* const end = text.data() + text.size();
      const auto read = std::from_chars(text.data(), end, numbers[column]);
      if (text.empty() || read.ec != std::errc() || read.ptr != end ||
        !std::isfinite(numbers[column]))
      {
        return std::string(Names[column]) + ": " + quoted(text) + " is not a finite number";
      }
    }
    TrajectoryRow row;
    std::string fault =
      TrajectoryTable::rowOf(numbers, this->Result.hasContact, this->Result.hasDevice, row);
    if (fault.empty() && !this->Result.rows.empty() && row.time < this->Result.rows.back().time)
    {
      fault = "time_s decreases";
    }
    this->Result.rows.push_back(row);
    return fault;
  }

  std::array<std::size_t, ColumnCount> Place{}; ///< of each column among the fields
  std::size_t FieldCount = 0;                   ///< 0 until the header was read
  std::vector<std::string_view> Fields;
};

/// What keeps the rows from being read again, or "".
std::string faultOf(const Trajectory& trajectory)
{
  for (std::size_t i = 0; i < trajectory.rows.size(); ++i)
  {
    const Numbers numbers = numbersOf(trajectory.rows[i]);
    for (std::size_t column = 0; column < ColumnCount; ++column)
    {
      if (isWritten(trajectory, column) && !std::isfinite(numbers[column]))
      {
        return "row " + std::to_string(i) + ": " + std::string(Names[column]) + " is not finite";
      }
    }
    if (i > 0 && trajectory.rows[i].time < trajectory.rows[i - 1].time)
    {
      return "row " + std::to_string(i) + ": time_s decreases";
    }
  }
  return {};
}

/// Keeps the rows for which there was room, since nobody can have them again; and says so.
std::string keepRows(WholeFile& file, std::size_t rows)
{
  const std::size_t lines = file.keepLines(2); // with the names of the columns
  return lines == 0 ? std::string()
                    : "; the first " + std::to_string(lines - 1) + " of " + std::to_string(rows) +
      " rows are kept in '" + file.unfinished() + "'";
}
} // namespace

const char* const TrajectoryColumns =
  "time_s,tip_x_mm,tip_y_mm,tip_z_mm,contact_x_mm,contact_y_mm,contact_z_mm,deflection_mm,"
  "normal_force_N,friction_x_N,friction_y_N,friction_z_N,ideal_force_N,state";

std::string writeTrajectory(const std::string& path, const std::vector<Tick>& ticks)
{
  Trajectory trajectory;
  trajectory.hasContact = true;
  trajectory.rows.reserve(ticks.size());
  for (const Tick& tick : ticks)
  {
    trajectory.rows.push_back(rowOf(tick));
  }
  return writeTrajectory(path, trajectory);
}

std::string writeTrajectory(const std::string& path, const Trajectory& trajectory)
{
  const std::string fault = faultOf(trajectory);
  if (!fault.empty())
  {
    return "cannot write '" + path + "': " + fault;
  }
  WholeFile file(path);
  std::string error = file.open();
  if (!error.empty())
  {
    return error;
  }
  std::string text;
  for (std::size_t column = 0; column < ColumnCount; ++column)
  {
    if (isWritten(trajectory, column))
    {
      text += column == 0 ? "" : ",";
      text += Names[column];
    }
  }
  text += '\n';
  for (const TrajectoryRow& row : trajectory.rows)
  {
    const Numbers numbers = numbersOf(row);
    for (std::size_t column = 0; column < ColumnCount; ++column)
    {
      if (isWritten(trajectory, column))
      {
        text += column == 0 ? "" : ",";
        append(text, numbers[column]);
      }
    }
    text += '\n';
    if (text.size() > Block)
    {
      file.write(text);
      text.clear();
    }
  }
  file.write(text);
  error = file.finish();
  return error.empty() ? error : error + keepRows(file, trajectory.rows.size());
}

std::string readTrajectory(std::istream& stream, const std::string& name, Trajectory& trajectory)
{
  Reader reader;
  std::string fault = NumberedLines::read(stream, name, reader);
  if (!fault.empty())
  {
    return fault;
  }
  trajectory = std::move(reader.Result);
  return {};
}

std::string readTrajectory(const std::string& path, Trajectory& trajectory)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    return path + ": cannot be opened";
  }
  return readTrajectory(stream, path, trajectory);
}
} // namespace palpate
