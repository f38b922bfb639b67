// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Measured/CurvesFromTable.h"

#include "Mechanics/Identification/CurvesFile.h"

#include "vtkDataArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cstdio>
#include <vector>

namespace palpate
{
namespace
{
/// Numbers with all their digits: a double is read back as it was.
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
        "' stands where the names of the columns should: read a file without the comments of its "
        "head, or give the file itself";
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
