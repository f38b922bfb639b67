// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/TrajectoryFile.h"

#include "Haptics/Devices/TrajectoryTable.h"
#include "Mechanics/Files/CsvReader.h"
#include "Mechanics/Files/CsvRow.h"
#include "Mechanics/Files/WholeFile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

namespace palpate
{
namespace
{
using namespace TrajectoryTable;

constexpr std::size_t Block = 65536; // bytes per write

bool isWritten(const Trajectory& trajectory, std::size_t column)
{
  const struct
  {
    std::size_t end;
    bool isThere;
  } groups[] = { { ContactBegin, true }, { DeviceBegin, trajectory.hasContact },
    { MemoryBegin, trajectory.hasDevice }, { AxisBegin, trajectory.hasMemory },
    { TorqueBegin, trajectory.hasAxis }, { ColumnCount, trajectory.hasTorque } };
  const auto* group = std::begin(groups);
  while (column >= group->end)
  {
    ++group;
  }
  return group->isThere;
}

TrajectoryRow rowOf(const Tick& tick)
{
  TrajectoryRow row;
  row.time = tick.time;
  row.tip = tick.tip;
  row.axis = tick.axis;
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

/// Returns the reason why the file could not be read back, or "" if it could.
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

std::string readRows(CsvReader& csv, Trajectory& trajectory)
{
  Trajectory read;
  csv.comment = [&read](std::string_view text)
  {
    read.setups.readLine(text);
    return std::string();
  };
  if (csv.header({ Names.begin(), Names.end() }, ContactBegin))
  {
    read.hasContact = csv.hasColumns(ContactBegin, DeviceBegin);
    read.hasDevice = csv.hasColumns(DeviceBegin, MemoryBegin);
    read.hasMemory = read.hasContact && csv.hasColumn(MemoryBegin);
    read.hasAxis = csv.hasColumns(AxisBegin, TorqueBegin);
    read.hasTorque = csv.hasColumns(TorqueBegin, ColumnCount) && read.hasContact;
  }
  while (csv.next())
  {
    Numbers numbers{};
    for (std::size_t column = 0; column < ColumnCount; ++column)
    {
      numbers[column] = isWritten(read, column) ? csv.number(column) : 0.0;
    }
    TrajectoryRow row;
    std::string fault = TrajectoryTable::rowOf(numbers, read.hasContact, read.hasDevice, row);
    if (fault.empty() && !read.rows.empty() && row.time < read.rows.back().time)
    {
      fault = "time_s decreases";
    }
    if (!fault.empty())
    {
      csv.fail(fault);
    }
    read.rows.push_back(row);
  }
  if (read.rows.empty())
  {
    csv.fail("there are no lines with numbers");
  }
  csv.comment = nullptr; // the names would refer to the columns of `read`
  if (csv.fault().empty())
  {
    trajectory = std::move(read);
  }
  return csv.fault();
}

/// Keeps the rows written so far in a file, because they cannot be recorded again. Returns a text
/// about them.
std::string keepRows(WholeFile& file, std::size_t rows, std::size_t remarks)
{
  // Number of lines above the rows: the names of the columns and the setups.
  const std::size_t above = 1 + remarks;
  const std::size_t lines = file.keepLines(above + 1);
  return lines == 0 ? std::string()
                    : "; the first " + std::to_string(lines - above) + " of " +
      std::to_string(rows) + " rows are kept in '" + file.unfinished() + "'";
}
} // namespace

std::string writeTrajectory(
  const std::string& path, const std::vector<Tick>& ticks, const RecordedSetups& setups)
{
  Trajectory trajectory;
  if (!ticks.empty())
  {
    trajectory.setups = setups.between(ticks.front().time, ticks.back().time);
  }
  trajectory.hasContact = true;
  trajectory.rows.reserve(ticks.size());
  for (const Tick& tick : ticks)
  {
    const TrajectoryRow& row = trajectory.rows.emplace_back(rowOf(tick));
    trajectory.hasMemory = trajectory.hasMemory || row.contact.memory != 0.0;
    trajectory.hasAxis = trajectory.hasAxis || !row.axis.isZero(0.0);
    trajectory.hasTorque = trajectory.hasTorque || !row.contact.torque.isZero(0.0);
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
  CsvRow names;
  for (std::size_t column = 0; column < ColumnCount; ++column)
  {
    if (isWritten(trajectory, column))
    {
      names.text(Names[column]);
    }
  }
  std::string text = names.line();
  const std::vector<std::string> remarks = trajectory.setups.lines();
  for (const std::string& remark : remarks)
  {
    text += "# " + remark + "\n";
  }
  for (const TrajectoryRow& row : trajectory.rows)
  {
    const Numbers numbers = numbersOf(row);
    CsvRow fields;
    for (std::size_t column = 0; column < ColumnCount; ++column)
    {
      if (isWritten(trajectory, column))
      {
        fields.number(numbers[column]);
      }
    }
    text += fields.line();
    if (text.size() > Block)
    {
      file.write(text);
      text.clear();
    }
  }
  file.write(text);
  error = file.finish();
  return error.empty() ? error : error + keepRows(file, trajectory.rows.size(), remarks.size());
}

std::string readTrajectory(std::istream& stream, const std::string& name, Trajectory& trajectory)
{
  CsvReader csv(stream, name);
  return readRows(csv, trajectory);
}

std::string readTrajectory(const std::string& path, Trajectory& trajectory)
{
  CsvReader csv(path);
  return readRows(csv, trajectory);
}
} // namespace palpate
