// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/CurvesFile.h"

#include "Mechanics/Files/CsvReader.h"

#include <array>
#include <map>
#include <string_view>

namespace palpate
{
namespace
{
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
  RequiredColumns = Time
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

/// Adds the last record of `csv` to the curve of its site; `index`: site -> curve.
void readReading(
  CsvReader& csv, std::map<std::string, std::size_t>& index, std::vector<MeasuredCurve>& curves)
{
  const std::string site(csv.text(Site));
  if (site.empty())
  {
    csv.fail("the site has no name");
    return;
  }
  const Eigen::Vector3d position{ csv.number(X), csv.number(Y), csv.number(Z) }; // in order
  const double deflection = csv.number(Deflection);
  const double force = csv.number(Force);
  const double time = csv.hasColumn(Time) ? csv.number(Time) : 0.0;
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
    csv.fail("site " + quoted(site) + " lies elsewhere than in its first row");
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

/// Reads from the names of the columns on; `read` may have the tool already.
std::string readReadings(
  CsvReader& csv, const std::string& name, MeasuredCurves read, MeasuredCurves& curves)
{
  bool inHead = true;
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
  csv.columns({ "site", "x_mm", "y_mm", "z_mm", "deflection_mm", "force_N", "time_s", "phase" },
    RequiredColumns);
  std::map<std::string, std::size_t> index;
  while (csv.next())
  {
    readReading(csv, index, read.curves);
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
  std::size_t records = 0; // the first are the names of the columns
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
