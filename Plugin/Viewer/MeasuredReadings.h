// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredReadings_h
#define palpate_MeasuredReadings_h

#include "ViewerScene.h"

#include "vtkTable.h"

#include <string>

class vtkResponseChart;

namespace palpate
{
/// Returns a value from a table of sites or readings.
double numberAt(vtkTable* table, vtkIdType row, const std::string& column);
std::string textAt(vtkTable* table, vtkIdType row, const std::string& column);

/// Returns the suffix that follows the tool in the label of a curve, ", from measured curves" or ",
/// from synthetic curves". Returns "" without measured curves.
std::string measuredLabel(const ViewerScene& scene);

/// Adds the readings of the first site to a chart, as one curve per tool that was used in the
/// measurement.
void addReadings(const ViewerScene& scene, vtkResponseChart* chart);
} // namespace palpate

#endif
