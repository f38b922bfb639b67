// SPDX-License-Identifier: BSD-3-Clause
#include "TickRecording.h"

#include "ContactArrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

namespace palpate
{
namespace
{
/// 0 for no values.
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
} // namespace

void fillRecording(const std::vector<ServoTick>& ticks, vtkIdType firstPoly, vtkPolyData* recording)
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
  ContactArrays contacts(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const ServoTick& tick = ticks[static_cast<std::size_t>(i)];
    points->SetPoint(i, tick.tip.data());
    line->InsertCellPoint(i);
    time->SetValue(i, tick.time);
    applied->SetTypedTuple(i, tick.deviceForce.data());
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
  contacts.attach(recording);
}

void fillStatistics(
  const std::vector<ServoTick>& ticks, std::vector<double> nanoseconds, vtkTable* statistics)
{
  double inContact = 0.0;
  double peakForce = 0.0;
  double peakFriction = 0.0;
  double peakDeflection = 0.0;
  for (const ServoTick& tick : ticks)
  {
    inContact += tick.contact.triangle >= 0 ? 1.0 : 0.0;
    peakForce = std::max(peakForce, tick.contact.force.norm());
    peakFriction = std::max(peakFriction, tick.contact.friction.norm());
    peakDeflection = std::max(peakDeflection, tick.contact.deflection);
  }
  std::sort(nanoseconds.begin(), nanoseconds.end());
  statistics->Initialize();
  addColumn(statistics, "Ticks", static_cast<double>(ticks.size()));
  addColumn(statistics, "TicksInContact", inContact);
  addColumn(statistics, "PeakForce (N)", peakForce);
  addColumn(statistics, "PeakFriction (N)", peakFriction);
  addColumn(statistics, "PeakDeflection (mm)", peakDeflection);
  addColumn(statistics, "MedianTick (ns)", quantile(nanoseconds, 0.5));
  addColumn(statistics, "Percentile99Tick (ns)", quantile(nanoseconds, 0.99));
}
} // namespace palpate
