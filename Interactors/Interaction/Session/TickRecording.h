// SPDX-License-Identifier: BSD-3-Clause
#ifndef TickRecording_h
#define TickRecording_h

#include "Haptics/Servo/ServoMeter.h"
#include "Haptics/Servo/TickHistory.h"
#include "Interaction/Session/TicksKept.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkTable;

namespace palpate
{
/// Writes the ticks as one polyline of tips. The arrays are those of vtkToolContactProbe, `Time`
/// (s), `AppliedForce` (N, body frame), `ForceFactor` and `SafetyLinks` (int, sum of SafetyLink).
/// `MemoryForce` is added if any tick has memory. `firstPoly` is the cell id of the body's first
/// triangle.
void fillRecording(const std::vector<Tick>& ticks, vtkIdType firstPoly, vtkPolyData* recording);
void fillRecording(const TickHistory& ticks, vtkIdType firstPoly, vtkPolyData* recording);

/// Reads the tip with index `index` of a recording or of the output of vtkToolContactProbe. Returns
/// false if there is no such tip, or if one of the arrays Force, Deflection, ContactPoint and
/// ContactCell is missing. Other arrays are optional. If their arrays are missing, time and applied
/// force are NaN.
bool readTick(vtkPolyData* tips, vtkIdType index, vtkIdType firstPoly, Tick& tick);

/// Writes the row of vtkHapticRecorder::GetStatistics. `nanoseconds` contains the duration of each
/// tick.
void fillStatistics(
  const TickSummary& summary, std::vector<double> nanoseconds, vtkTable* statistics);
/// Writes the row for a run in real time, including the times of the servo loop.
void fillStatistics(const TickSummary& summary, const ServoStatistics& statistics, vtkTable* table);

/// Writes one row per fraction of the ticks; see vtkHapticRecorder::GetTiming.
void fillTiming(const ServoStatistics& statistics, vtkTable* table);
/// Writes one row per class of durations; see vtkHapticRecorder::GetTimingHistogram.
void fillTimingHistogram(const ServoStatistics& statistics, vtkTable* table);
} // namespace palpate

#endif
