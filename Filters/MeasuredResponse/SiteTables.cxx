// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredResponse/SiteTables.h"

#include "Identification/CurvesFile.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/IsotonicRegression.h"
#include "Identification/RelaxationFit.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
template <class Array, class Row, class Value>
void addColumn(
  vtkTable* table, const std::string& name, const std::vector<Row>& rows, const Value& value)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  for (const Row& row : rows)
  {
    column->InsertNextValue(value(row));
  }
  table->AddColumn(column);
}

template <class Value>
void addNumbers(vtkTable* table, const std::string& name, const std::vector<PlacedSite>& sites,
  const Value& value)
{
  addColumn<vtkDoubleArray>(table, name, sites, value);
}

template <class Value>
void addEstimate(vtkTable* table, const std::string& name, const std::string& unit,
  const std::vector<PlacedSite>& sites, const Value& value)
{
  addNumbers(table, name + unit, sites, [&](const PlacedSite& s) { return value(s).value; });
  addNumbers(
    table, name + " from" + unit, sites, [&](const PlacedSite& s) { return value(s).lower; });
  addNumbers(
    table, name + " to" + unit, sites, [&](const PlacedSite& s) { return value(s).upper; });
}

/// Returns the value with the largest magnitude over the curves of a site; NaN if no curve has a
/// value.
template <class Value>
double most(const PlacedSite& site, const Value& value)
{
  double largest = NotANumber;
  for (const SiteCurve& curve : site.measured.curves)
  {
    const double next = value(curve.prepared);
    largest = std::abs(next) <= std::abs(largest) ? largest : std::isnan(next) ? largest : next;
  }
  return largest;
}

std::string toolsOf(const PlacedSite& site)
{
  std::string tools;
  for (const SiteCurve& curve : site.measured.curves)
  {
    tools += (tools.empty() ? "" : " ") + curve.toolText;
  }
  return tools;
}

struct Reading
{
  const PlacedSite* site;
  const SiteCurve* curve;
  double deflection;
  double force;
  double monotone;
  double model;
  double time;
};

/// Appends all readings of a site that relaxes, in the order of measurement.
void appendHistory(const PlacedSite& site, std::size_t index,
  const std::shared_ptr<const LayerKernel>& kernel, std::vector<Reading>& readings)
{
  const SiteCurve& curve = site.measured.curves[index];
  const IdentifiedBody& body = site.measured.body;
  const double offset = body.contactOffset[index].value;
  PressHistory history;
  history.tool = curve.tool.get();
  history.time = curve.curve.time;
  history.deflection = curve.curve.deflection;
  const std::vector<double> model = forcesOver(history, body.body, body.relaxation, kernel, offset);
  for (std::size_t i = 0; i < model.size(); ++i)
  {
    const double net = curve.curve.force[i] - body.baseline[index].at(history.deflection[i]);
    readings.push_back({ &site, &curve, history.deflection[i] - offset, net, NotANumber, model[i],
      history.time[i] });
  }
}

bool isRelaxing(const PlacedSite& site)
{
  return site.measured.refusal.empty() && site.measured.body.relaxation.relaxes();
}

void appendReadings(const PlacedSite& site, std::size_t index,
  const std::shared_ptr<const LayerKernel>& kernel, std::vector<Reading>& readings)
{
  const SiteCurve& curve = site.measured.curves[index];
  const IdentifiedBody& body = site.measured.body;
  const bool known = site.measured.refusal.empty();
  if (isRelaxing(site) && !curve.curve.time.empty())
  {
    appendHistory(site, index, kernel, readings);
    return;
  }
  const double offset = known ? body.contactOffset[index].value : 0.0;
  const ForceBaseline baseline = known ? body.baseline[index] : ForceBaseline();
  for (const LoadingBranch& load : curve.prepared.loads)
  {
    std::vector<std::size_t> order(load.deflection.size());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    std::stable_sort(order.begin(), order.end(),
      [&load](std::size_t a, std::size_t b) { return load.deflection[a] < load.deflection[b]; });
    std::vector<double> forces;
    for (const std::size_t i : order)
    {
      forces.push_back(load.force[i] - baseline.at(load.deflection[i]));
    }
    const std::vector<double> monotone = isotonicRegression(forces);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const double depth = load.deflection[order[i]] - offset;
      readings.push_back({ &site, &curve, depth, forces[i], monotone[i],
        known ? bodyResponse(body.body, *curve.tool, kernel, depth).force : NotANumber,
        NotANumber });
    }
  }
}
/// Adds the columns for relaxation, if at least one site relaxes.
void addRelaxation(vtkTable* table, const std::vector<PlacedSite>& sites)
{
  std::size_t branches = 0;
  for (const PlacedSite& site : sites)
  {
    branches = std::max(branches, isRelaxing(site) ? site.measured.body.relaxation.count : 0);
  }
  if (branches == 0)
  {
    return;
  }
  addNumbers(table, "HoldLoss", sites,
    [](const PlacedSite& s) { return most(s, [](const PreparedCurve& p) { return p.holdLoss; }); });
  for (std::size_t i = 0; i < branches; ++i)
  {
    const auto estimate = [i](const std::vector<Estimate>& estimates)
    { return i < estimates.size() ? estimates[i] : Estimate(); };
    addEstimate(table, "RelaxationStrength " + std::to_string(i + 1), "", sites,
      [&](const PlacedSite& s) { return estimate(s.measured.body.relaxationStrength); });
    addEstimate(table, "RelaxationTime " + std::to_string(i + 1), " (s)", sites,
      [&](const PlacedSite& s) { return estimate(s.measured.body.relaxationTime); });
  }
  addNumbers(table, "ShortestTime (s)", sites,
    [](const PlacedSite& s) { return s.measured.body.shortestTime; });
  addNumbers(table, "LongestTime (s)", sites,
    [](const PlacedSite& s) { return s.measured.body.longestTime; });
}

/// Returns a number as text with all its digits, so that a double is read back unchanged.
std::string text(vtkAbstractArray* column, vtkIdType row)
{
  const vtkVariant value = column->GetVariantValue(row);
  if (!value.IsNumeric() || value.IsChar())
  {
    return value.ToString();
  }
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", value.ToDouble());
  return digits;
}
} // namespace

void tabulateSites(const std::vector<PlacedSite>& sites, vtkTable* table)
{
  const auto text = [&](const char* name, const auto& value)
  { addColumn<vtkStringArray>(table, name, sites, value); };
  text("Site", [](const PlacedSite& s) { return s.measured.name; });
  text("Verdict",
    [](const PlacedSite& s)
    { return s.measured.refusal.empty() ? std::string("identified") : s.measured.refusal; });
  text("Model",
    [](const PlacedSite& s)
    { return std::string(s.measured.refusal.empty() ? nameOf(s.measured.body.body.model) : ""); });
  text("Tools", toolsOf);
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    addNumbers(table, std::string(1, "XYZ"[k]) + " (mm)", sites,
      [k](const PlacedSite& s) { return s.position[k]; });
  }
  addNumbers(table, "Distance (mm)", sites, [](const PlacedSite& s) { return s.distance; });
  addEstimate(table, "ReducedModulus", " (MPa)", sites,
    [](const PlacedSite& s) { return s.measured.body.reducedModulus; });
  addEstimate(table, "Compliance", " (mm/N)", sites,
    [](const PlacedSite& s) { return s.measured.body.compliance; });
  addEstimate(table, "Thickness", " (mm)", sites,
    [](const PlacedSite& s) { return s.measured.body.thickness; });
  const auto first = [](const std::vector<Estimate>& estimates)
  { return estimates.empty() ? Estimate() : estimates.front(); };
  addEstimate(table, "ContactOffset", " (mm)", sites,
    [&](const PlacedSite& s) { return first(s.measured.body.contactOffset); });
  addEstimate(table, "ForceOffset", " (N)", sites,
    [&](const PlacedSite& s) { return first(s.measured.body.forceOffset); });
  addEstimate(table, "ForceDrift", " (N/mm)", sites,
    [&](const PlacedSite& s) { return first(s.measured.body.forceDrift); });
  const auto identified = [&](const char* name, double IdentifiedBody::*member)
  { addNumbers(table, name, sites, [=](const PlacedSite& s) { return s.measured.body.*member; }); };
  identified("Noise (N)", &IdentifiedBody::noise);
  identified("Misfit (N)", &IdentifiedBody::misfit);
  identified("LargestForce (N)", &IdentifiedBody::largestForce);
  addNumbers(table, "WithinNoise", sites,
    [](const PlacedSite& s) { return s.measured.body.withinNoise ? 1.0 : 0.0; });
  addNumbers(table, "Hysteresis", sites,
    [](const PlacedSite& s)
    { return most(s, [](const PreparedCurve& p) { return p.hysteresis; }); });
  addNumbers(table, "RateEffect", sites,
    [](const PlacedSite& s)
    { return most(s, [](const PreparedCurve& p) { return p.rateEffect; }); });
  addRelaxation(table, sites);
  text("Remark", [](const PlacedSite& s) { return s.measured.body.remark; });
}

void tabulateCurves(const std::vector<PlacedSite>& sites,
  const std::shared_ptr<const LayerKernel>& kernel, vtkTable* table)
{
  std::vector<Reading> readings;
  for (const PlacedSite& site : sites)
  {
    for (std::size_t i = 0; i < site.measured.curves.size(); ++i)
    {
      appendReadings(site, i, kernel, readings);
    }
  }
  const auto number = [&](const char* name, double Reading::*member) {
    addColumn<vtkDoubleArray>(table, name, readings, [=](const Reading& r) { return r.*member; });
  };
  number("Deflection (mm)", &Reading::deflection);
  number("Force (N)", &Reading::force);
  number("MonotoneForce (N)", &Reading::monotone);
  number("ModelForce (N)", &Reading::model);
  if (std::any_of(sites.begin(), sites.end(), isRelaxing))
  {
    number("Time (s)", &Reading::time);
  }
  addColumn<vtkStringArray>(
    table, "Site", readings, [](const Reading& r) { return r.site->measured.name; });
  addColumn<vtkStringArray>(
    table, "Tool", readings, [](const Reading& r) { return r.curve->toolText; });
}

std::string curvesFromTable(
  vtkTable* table, const std::string& name, const std::string& tool, MeasuredCurves& curves)
{
  std::vector<vtkAbstractArray*> columns;
  CurvesTable readings;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    const std::string title = column->GetName() ? column->GetName() : "";
    if (title.compare(0, 1, "#") == 0)
    {
      return name + ": the comment '" + title +
        "' is in the place of the column names: read a file without the comments of its head, or "
        "give the file itself";
    }
    columns.push_back(column);
    readings.columns.push_back(title);
  }
  readings.name = name;
  readings.tool = tool;
  readings.rowCount = static_cast<std::size_t>(table->GetNumberOfRows());
  readings.field = [&columns](std::size_t row, std::size_t column)
  { return text(columns[column], static_cast<vtkIdType>(row)); };
  return readCurves(readings, curves);
}
} // namespace palpate
