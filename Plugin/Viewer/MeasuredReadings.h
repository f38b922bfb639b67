// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredReadings_h
#define palpate_MeasuredReadings_h

#include "ViewerScene.h"

#include "vtkTable.h"

#include <string>

class vtkResponseChart;

namespace palpate
{
/// A value of a table of sites or readings.
double numberAt(vtkTable* table, vtkIdType row, const std::string& column);
std::string textAt(vtkTable* table, vtkIdType row, const std::string& column);

/// Suffix of a curve's label after its tool: ", from measured curves" or ", from synthetic curves";
/// "" without measured curves.
std::string measuredLabel(const ViewerScene& scene);

/// Adds the readings of the first site, one curve per tool used for the measurement.
void addReadings(const ViewerScene& scene, vtkResponseChart* chart);
} // namespace palpate

#endif
