// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/TickRecording.h"

#include "Mechanics/Numerics/Constants.h"
#include "Response/ContactArrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
/// Returns the quantile of the sorted values for the fraction `share`; 0 if there are no values.
double quantile(const std::vector<double>& sorted, double share)
{
  return sorted.empty()
    ? 0.0
    : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void addColumn(vtkTable* table, const char* name, double value)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  column->InsertNextValue(value);
  table->AddColumn(column);
}
void addSummary(const TickSummary& summary, std::uint64_t ticks, vtkTable* table)
{
  addColumn(table, "Ticks", static_cast<double>(ticks));
  addColumn(table, "TicksInContact", static_cast<double>(summary.inContact));
  addColumn(table, "PeakForce (N)", summary.peakForce);
  addColumn(table, "PeakAppliedForce (N)", summary.peakApplied);
  addColumn(table, "PeakFriction (N)", summary.peakFriction);
  addColumn(table, "PeakDeflection (mm)", summary.peakDeflection);
  addColumn(table, "MemoryAtPeak (N)", summary.memoryAtPeak);
}
} // namespace

namespace
{
template <class Ticks, class Get>
void attachVectors(const Ticks& ticks, const char* name, Get get, vtkPolyData* recording)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ticks.size()));
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), get(ticks[i]));
  }
  recording->GetPointData()->AddArray(array);
}

template <class Ticks>
void fillFrom(const Ticks& ticks, vtkIdType firstPoly, vtkPolyData* recording)
{
  const auto count = static_cast<vtkIdType>(ticks.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(count));
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  time->SetNumberOfTuples(count);
  vtkNew<vtkDoubleArray> applied;
  applied->SetName("AppliedForce");
  applied->SetNumberOfComponents(3);
  applied->SetNumberOfTuples(count);
  vtkNew<vtkDoubleArray> factor;
  factor->SetName("ForceFactor");
  factor->SetNumberOfTuples(count);
  vtkNew<vtkIntArray> links;
  links->SetName("SafetyLinks");
  links->SetNumberOfTuples(count);
  bool remembers = false;
  bool isTurned = false;
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    remembers = remembers || ticks[i].contact.memory != 0.0;
    isTurned = isTurned || ticks[i].hasAxis();
  }
  ContactArrays contacts(count, remembers);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Tick& tick = ticks[static_cast<std::size_t>(i)];
    points->SetPoint(i, tick.tip.data());
    line->InsertCellPoint(i);
    time->SetValue(i, tick.time);
    applied->SetTypedTuple(i, tick.appliedForce.data());
    factor->SetValue(i, tick.forceFactor);
    links->SetValue(i, tick.acted);
    contacts.store(i, tick.contact, firstPoly);
  }
  recording->Initialize();
  recording->SetPoints(points);
  if (count > 0)
  {
    recording->SetLines(line);
  }
  recording->GetPointData()->AddArray(time);
  recording->GetPointData()->AddArray(applied);
  recording->GetPointData()->AddArray(factor);
  recording->GetPointData()->AddArray(links);
  contacts.attach(recording);
  if (isTurned)
  {
    attachVectors(
      ticks, "ToolAxis", [](const Tick& tick) { return tick.axis.data(); }, recording);
    attachVectors(
      ticks, "Torque", [](const Tick& tick) { return tick.contact.torque.data(); }, recording);
  }
}
} // namespace

void fillRecording(const std::vector<Tick>& ticks, vtkIdType firstPoly, vtkPolyData* recording)
{
  fillFrom(ticks, firstPoly, recording);
}

void fillRecording(const TickHistory& ticks, vtkIdType firstPoly, vtkPolyData* recording)
{
  fillFrom(ticks, firstPoly, recording);
}

bool readTick(vtkPolyData* tips, vtkIdType index, vtkIdType firstPoly, Tick& tick)
{
  vtkPointData* data = tips->GetPointData();
  const auto read = [data, index](const char* name, double* values)
  {
    vtkDataArray* array = data->GetArray(name);
    if (array)
    {
      array->GetTuple(index, values);
    }
    return array != nullptr;
  };
  const bool isTip = index >= 0 && index < tips->GetNumberOfPoints();
  Contact& contact = tick.contact;
  double cell = -1.0;
  if (!isTip || !read("Force", contact.force.data()) || !read("Deflection", &contact.deflection) ||
    !read("ContactPoint", contact.contactPoint.data()) || !read("ContactCell", &cell))
  {
    return false;
  }
  contact.triangle =
    cell < 0.0 ? -1 : static_cast<std::int32_t>(cell - static_cast<double>(firstPoly));
  double state = 0.0;
  double links = 0.0;
  read("Normal", contact.normal.data());
  read("NormalForce", &contact.normalForce);
  read("MemoryForce", &contact.memory);
  read("FrictionForce", contact.friction.data());
  read("ContactState", &state);
  read("ToolAxis", tick.axis.data());
  read("Torque", contact.torque.data());
  tick.idealTorque = contact.torque;
  if (tick.hasAxis() && contact.triangle >= 0)
  {
    tick.axis.normalize();
    contact.tilt =
      std::atan2(tick.axis.cross(contact.normal).norm(), tick.axis.dot(contact.normal));
  }
  contact.state = static_cast<ContactState>(static_cast<int>(state));
  tips->GetPoint(index, tick.tip.data());
  tick.idealForce = contact.force;
  tick.time = NotANumber;
  tick.appliedForce.setConstant(NotANumber);
  read("Time", &tick.time);
  read("AppliedForce", tick.appliedForce.data());
  read("ForceFactor", &tick.forceFactor);
  read("SafetyLinks", &links);
  tick.acted = static_cast<std::uint16_t>(links);
  return true;
}

void fillStatistics(
  const TickSummary& summary, std::vector<double> nanoseconds, vtkTable* statistics)
{
  std::sort(nanoseconds.begin(), nanoseconds.end());
  statistics->Initialize();
  addSummary(summary, summary.ticks, statistics);
  addColumn(statistics, "MedianTick (ns)", quantile(nanoseconds, 0.5));
  addColumn(statistics, "Percentile99Tick (ns)", quantile(nanoseconds, 0.99));
}

void fillStatistics(const TickSummary& summary, const ServoStatistics& statistics, vtkTable* table)
{
  table->Initialize();
  addSummary(summary, statistics.ticks, table);
  addColumn(table, "MedianTick (ns)", static_cast<double>(statistics.tick.quantile(0.5)));
  addColumn(table, "Percentile99Tick (ns)", static_cast<double>(statistics.tick.quantile(0.99)));
  const std::pair<const char*, std::uint64_t> counts[] = { { "Missed", statistics.missed },
    { "InvalidSamples", statistics.invalidSamples },
    { "RepeatedSamples", statistics.repeatedSamples },
    { "RefusedForces", statistics.refusedForces }, { "Overruns", statistics.overruns },
    { "SceneChanges", statistics.sceneChanges },
    { "MalformedReports", statistics.device.malformed },
    { "StaleReports", statistics.device.stale }, { "LostReports", statistics.device.lost },
    { "UnsentForces", statistics.device.unsent },
    { "Disconnections", statistics.device.disconnections } };
  for (const auto& [name, count] : counts)
  {
    addColumn(table, name, static_cast<double>(count));
  }
}

void fillTiming(const ServoStatistics& statistics, vtkTable* table)
{
  constexpr double shares[] = { 0.5, 0.9, 0.99, 0.999, 0.9999, 1.0 };
  const auto add = [&](const char* name, const LatencyCounts* counts)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const double share : shares)
    {
      const bool isWorst = share == 1.0;
      column->InsertNextValue(counts == nullptr ? share
          : isWorst                             ? 1e-3 * static_cast<double>(counts->worst())
                    : 1e-3 * static_cast<double>(counts->quantile(share)));
    }
    table->AddColumn(column);
  };
  table->Initialize();
  add("Share", nullptr);
  add("Period (us)", &statistics.period);
  add("WakeUp (us)", &statistics.wakeUp);
  add("Tick (us)", &statistics.tick);
}

void fillTimingHistogram(const ServoStatistics& statistics, vtkTable* table)
{
  const std::pair<const char*, const LatencyCounts*> times[] = { { "Period", &statistics.period },
    { "WakeUp", &statistics.wakeUp }, { "Tick", &statistics.tick } };
  std::size_t first = LatencyCounts::Classes;
  std::size_t end = 0;
  for (std::size_t i = 0; i < LatencyCounts::Classes; ++i)
  {
    for (const auto& [name, counts] : times)
    {
      if (counts->count(i) > 0)
      {
        first = std::min(first, i);
        end = i + 1;
      }
    }
  }
  const auto add = [&](const char* name, const auto& value)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (std::size_t i = first; i < end; ++i)
    {
      column->InsertNextValue(value(i));
    }
    table->AddColumn(column);
  };
  constexpr double microsecond = 1e-3; // factor from nanoseconds to microseconds
  table->Initialize();
  add("From (us)",
    [](std::size_t i)
    { return i > 0 ? microsecond * static_cast<double>(LatencyCounts::longestOf(i - 1)) : 0.0; });
  add("To (us)",
    [](std::size_t i) { return microsecond * static_cast<double>(LatencyCounts::longestOf(i)); });
  for (const auto& [name, counts] : times)
  {
    add(name, [c = counts](std::size_t i) { return static_cast<double>(c->count(i)); });
  }
}
} // namespace palpate
