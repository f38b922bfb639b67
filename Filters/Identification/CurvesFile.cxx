// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/CurvesFile.h"

#include "Mechanics/Files/CsvReader.h"
#include "Mechanics/Files/NumberText.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace palpate
{
namespace
{
enum Column : std::size_t
{
  X,
  Y,
  Z,
  Deflection,
  Force,
  Site,
  Time,
  Phase,
  RequiredColumns = Site
};

/// A column name, and the factor that converts the numbers of the column to mm, N or s.
struct UnitColumn
{
  const char* name;
  double factor;
};
constexpr std::array<UnitColumn, 6> DeflectionColumns = { { { "deflection_mm", 1.0 },
  { "deflection_nm", 1e-6 }, { "deflection_um", 1e-3 }, { "deflection_\xC2\xB5m", 1e-3 },
  { "deflection_cm", 10.0 }, { "deflection_m", 1e3 } } };
constexpr std::array<UnitColumn, 6> ForceColumns = { { { "force_N", 1.0 }, { "force_nN", 1e-9 },
  { "force_uN", 1e-6 }, { "force_\xC2\xB5N", 1e-6 }, { "force_mN", 1e-3 }, { "force_kN", 1e3 } } };
constexpr std::array<UnitColumn, 4> TimeColumns = { { { "time_s", 1.0 }, { "time_us", 1e-6 },
  { "time_ms", 1e-3 }, { "time_min", 60.0 } } };

/// Factors by which the numbers of a file are multiplied. They convert the unit, and are negative
/// for a quantity that decreases while the tool is pressed in.
struct Factors
{
  double deflection = 1.0;
  double force = 1.0;
  double time = 1.0;
};

std::string quoted(std::string_view text)
{
  return "'" + std::string(text) + "'";
}

bool readPhase(std::string_view text, CurvePhase& phase)
{
  phase = text == "loading" ? CurvePhase::Loading
    : text == "unloading"   ? CurvePhase::Unloading
    : text == "hold"        ? CurvePhase::Hold
                            : CurvePhase::Unknown;
  return phase != CurvePhase::Unknown || text.empty();
}

std::string readTool(std::string_view text, MeasuredCurves& curves)
{
  std::string error;
  curves.toolText = text;
  return parseTool(curves.toolText, curves.tool, error) ? std::string() : "tool: " + error;
}

/// Reads "force", "deflection", or both separated by a comma, and changes the sign of the factors.
/// Returns a fault, or "".
std::string readNegative(std::string_view text, Factors& factors)
{
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view name = trimmed(text.substr(begin, end - begin));
    if (name != "force" && name != "deflection")
    {
      return "negative: " + quoted(name) + " is not known; accepted are force, deflection";
    }
    (name == "force" ? factors.force : factors.deflection) = -1.0;
    begin = end + 1;
  }
  return {};
}

/// Finds the column of the current record that has a quantity in one of its units, and multiplies
/// `factor` by the factor of this column. Returns its name, or the first name of `columns` if there
/// is no such column.
template <std::size_t N>
const char* findColumn(CsvReader& csv, const std::array<UnitColumn, N>& columns, double& factor)
{
  const UnitColumn* found = nullptr;
  for (const UnitColumn& column : columns)
  {
    for (std::size_t i = 0; i < csv.size(); ++i)
    {
      if (csv.text(i) == column.name && found != &column)
      {
        if (found)
        {
          csv.fail("has both " + quoted(found->name) + " and " + quoted(column.name));
        }
        found = &column;
      }
    }
  }
  factor *= found ? found->factor : 1.0;
  return found ? found->name : columns.front().name;
}

/// Sets a fault if the name of a column has a known quantity but no known unit.
template <std::size_t N>
void refuseUnit(CsvReader& csv, const std::array<UnitColumn, N>& columns)
{
  const std::string_view first = columns.front().name;
  const std::string_view quantity = first.substr(0, first.find('_'));
  std::string units;
  for (const UnitColumn& column : columns)
  {
    units += (units.empty() ? "" : ", ") + std::string(column.name).substr(quantity.size() + 1);
  }
  bool isThere = false;
  std::string_view other;
  for (std::size_t i = 0; i < csv.size(); ++i)
  {
    const std::string_view name = csv.text(i);
    isThere = isThere ||
      std::any_of(columns.begin(), columns.end(),
        [&](const UnitColumn& column) { return name == column.name; });
    other = name.substr(0, quantity.size() + 1) == std::string(quantity) + "_" ? name : other;
  }
  if (!isThere && !other.empty())
  {
    csv.fail("column " + quoted(first) + " is missing; " + quoted(other) +
      " ends with none of the units " + units);
  }
}

/// Uses the current record as the names of the columns.
void nameColumns(CsvReader& csv, Factors& factors)
{
  const char* const deflection = findColumn(csv, DeflectionColumns, factors.deflection);
  const char* const force = findColumn(csv, ForceColumns, factors.force);
  const char* const time = findColumn(csv, TimeColumns, factors.time);
  refuseUnit(csv, DeflectionColumns);
  refuseUnit(csv, ForceColumns);
  csv.columns(
    { "x_mm", "y_mm", "z_mm", deflection, force, "site", time, "phase" }, RequiredColumns);
}

/// Returns the name of a site in a file without site names, for example "(10, 0, 50)".
std::string nameOf(const Eigen::Vector3d& position)
{
  return "(" + shortestDecimals(position[0]) + ", " + shortestDecimals(position[1]) + ", " +
    shortestDecimals(position[2]) + ")";
}

/// Adds the current record of `csv` to the curve of its site. `index` maps the names of sites to
/// indices in `curves`.
void readReading(CsvReader& csv, const Factors& factors, std::map<std::string, std::size_t>& index,
  std::vector<MeasuredCurve>& curves)
{
  // Braces guarantee that x, y and z are read in this order.
  const Eigen::Vector3d position{ csv.number(X), csv.number(Y), csv.number(Z) };
  const bool isNamed = csv.hasColumn(Site);
  const std::string site = isNamed ? std::string(csv.text(Site))
    : curves.empty()               ? nameOf(position)
                                   : curves.front().site;
  if (site.empty())
  {
    csv.fail("the site has no name");
    return;
  }
  const double deflection = factors.deflection * csv.number(Deflection);
  const double force = factors.force * csv.number(Force);
  const double time = csv.hasColumn(Time) ? factors.time * csv.number(Time) : 0.0;
  CurvePhase phase = CurvePhase::Unknown;
  if (!readPhase(csv.text(Phase), phase))
  {
    csv.fail(
      "phase: " + quoted(csv.text(Phase)) + " is not known; accepted are loading, unloading, hold");
  }
  const auto known = index.emplace(site, curves.size());
  if (known.second)
  {
    curves.emplace_back();
    curves.back().site = site;
    curves.back().position = position;
  }
  MeasuredCurve& curve = curves[known.first->second];
  if (curve.position != position)
  {
    csv.fail(isNamed ? "site " + quoted(site) + " has another position than in its first row"
                     : "has another position than the first row, but a file without the column "
                       "'site' has one curve");
  }
  if (csv.hasColumn(Time))
  {
    if (!curve.time.empty() && time < curve.time.back())
    {
      csv.fail("time_s decreases at site " + quoted(site));
    }
    curve.time.push_back(time);
  }
  if (csv.hasColumn(Phase))
  {
    curve.phase.push_back(phase);
  }
  curve.deflection.push_back(deflection);
  curve.force.push_back(force);
}

/// Reads the readings, starting with the names of the columns. The tool in `read` may already be
/// set. Returns a fault, or
/// "".
std::string readReadings(
  CsvReader& csv, const std::string& name, MeasuredCurves read, MeasuredCurves& curves)
{
  bool inHead = true;
  Factors factors;
  csv.comment = [&](std::string_view text) -> std::string
  {
    const CsvComment comment(text);
    if (comment.key == "tool")
    {
      return inHead && read.toolText.empty() ? readTool(comment.value, read)
                                             : "a file has one tool, named in its head";
    }
    if (comment.key == "synthetic")
    {
      read.synthetic = comment.value.empty() ? "not said how" : comment.value;
    }
    if (comment.key == "negative")
    {
      return inHead ? readNegative(comment.value, factors) : "signs are named in the head";
    }
    return {};
  };
  if (!csv.next())
  {
    csv.fail("there is no line with the names of the columns");
  }
  inHead = false;
  if (read.toolText.empty())
  {
    csv.fail("the head does not name the tool: '# tool: sphere:6.35' is missing");
  }
  nameColumns(csv, factors);
  std::map<std::string, std::size_t> index;
  while (csv.next())
  {
    readReading(csv, factors, index, read.curves);
  }
  if (read.curves.empty())
  {
    csv.fail("there are no readings");
  }
  if (csv.fault().empty())
  {
    read.file = name;
    curves = std::move(read);
  }
  return csv.fault();
}
} // namespace

std::string readCurves(std::istream& stream, const std::string& name, MeasuredCurves& curves)
{
  CsvReader csv(stream, name);
  return readReadings(csv, name, {}, curves);
}

std::string readCurves(const std::string& path, MeasuredCurves& curves)
{
  CsvReader csv(path);
  return readReadings(csv, path, {}, curves);
}

std::string readCurves(const CurvesTable& table, MeasuredCurves& curves)
{
  MeasuredCurves read;
  const std::string fault = readTool(table.tool, read);
  if (!fault.empty())
  {
    return table.name + ": " + fault;
  }
  std::size_t records = 0; // the first record contains the names of the columns
  CsvReader csv(
    [&](std::vector<std::string>& fields)
    {
      fields = table.columns;
      for (std::size_t column = 0;
           records > 0 && records <= table.rowCount && column < fields.size(); ++column)
      {
        fields[column] = trimmed(table.field(records - 1, column));
      }
      return records++ <= table.rowCount;
    },
    table.name);
  return readReadings(csv, table.name, std::move(read), curves);
}
} // namespace palpate
