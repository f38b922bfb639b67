// SPDX-License-Identifier: BSD-3-Clause
#ifndef TickRecording_h
#define TickRecording_h

#include "ServoStep.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkTable;

namespace palpate
{
/// The ticks as one polyline of tips with the arrays of vtkToolContactProbe, `Time` (s) and
/// `AppliedForce` (N). `firstPoly` is the cell id of the body's first triangle.
void fillRecording(
  const std::vector<ServoTick>& ticks, vtkIdType firstPoly, vtkPolyData* recording);

/// One row, see vtkHapticSession::GetStatistics; `nanoseconds` holds the time of each tick.
void fillStatistics(
  const std::vector<ServoTick>& ticks, std::vector<double> nanoseconds, vtkTable* statistics);
} // namespace palpate

#endif
