// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurvesFromTable_h
#define CurvesFromTable_h

#include "Mechanics/Identification/MeasuredCurve.h"

#include <string>

class vtkTable;

namespace palpate
{
/// The readings of one tool from a table with the columns of a file of curves (CurvesFile.h), as a
/// reader of .csv files makes it; other columns are passed over. `name` stands for the file in
/// errors. Returns what is wrong, with the row, or "".
std::string curvesFromTable(
  vtkTable* table, const std::string& name, const std::string& tool, MeasuredCurves& curves);
} // namespace palpate

#endif
