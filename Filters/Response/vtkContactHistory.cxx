// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactHistory.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

/// The tips in the order of the rows, and the number of the polyline of each tip.
struct Rows
{
  std::vector<vtkIdType> point;
  std::vector<std::size_t> line;
  std::size_t lineCount = 0;
};

Rows findRows(vtkPolyData* tips)
{
  Rows rows;
  auto cells = vtkSmartPointer<vtkCellArrayIterator>::Take(tips->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    rows.point.insert(rows.point.end(), ids, ids + count);
    rows.line.insert(rows.line.end(), static_cast<std::size_t>(count), rows.lineCount);
    ++rows.lineCount;
  }
  if (rows.lineCount == 0)
  {
    for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
    {
      rows.point.push_back(i);
    }
    rows.line.assign(rows.point.size(), 0);
    rows.lineCount = 1;
  }
  return rows;
}

double magnitude(vtkDataArray* array, vtkIdType point)
{
  double squares = 0.0;
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    squares += array->GetComponent(point, k) * array->GetComponent(point, k);
  }
  return std::sqrt(squares);
}

void addNumbers(vtkTable* table, const Rows& rows, const char* name, vtkDataArray* array)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  for (const vtkIdType point : rows.point)
  {
    column->InsertNextValue(array->GetTuple1(point));
  }
  table->AddColumn(column);
}

/// Adds one force column per polyline.
template <class Value>
void addForces(vtkTable* table, const Rows& rows, const std::string& name, const Value& value)
{
  for (std::size_t line = 0; line < rows.lineCount; ++line)
  {
    const std::string of = rows.lineCount > 1 ? " of line " + std::to_string(line) : "";
    vtkNew<vtkDoubleArray> column;
    column->SetName((name + of + " (N)").c_str());
    for (std::size_t i = 0; i < rows.point.size(); ++i)
    {
      column->InsertNextValue(rows.line[i] == line ? value(rows.point[i]) : Missing);
    }
    table->AddColumn(column);
  }
}

/// Returns a point array with `components` components. Returns null if there is none.
vtkDataArray* find(vtkPolyData* tips, const char* name, int components)
{
  vtkDataArray* array = tips->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}
} // namespace

vtkStandardNewMacro(vtkContactHistory);

int vtkContactHistory::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkContactHistory::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* tips = vtkPolyData::GetData(inputVector[0]);
  vtkTable* output = vtkTable::GetData(outputVector);
  if (!tips || tips->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  for (const char* name : { "Deflection", "NormalForce" })
  {
    if (!find(tips, name, 1))
    {
      vtkErrorMacro(<< "Wrong tips: the point array '" << name
                    << "', a number per point, is missing; apply Tool Contact Probe first.");
      return 0;
    }
  }
  vtkDataArray* time = find(tips, "Time", 1);
  vtkDataArray* deflection = find(tips, "Deflection", 1);
  if (this->Abscissa == Time && !time)
  {
    vtkErrorMacro(
      "Wrong tips: the point array 'Time', a number per point, is missing, and Abscissa "
      "is Time.");
    return 0;
  }
  const Rows rows = findRows(tips);
  const bool overTime = time && this->Abscissa != Deflection;
  if (overTime)
  {
    addNumbers(output, rows, "Time (s)", time);
  }
  addNumbers(output, rows, "Deflection (mm)", deflection);
  if (time && !overTime)
  {
    addNumbers(output, rows, "Time (s)", time);
  }
  vtkDataArray* normal = find(tips, "NormalForce", 1);
  addForces(
    output, rows, "Normal Force", [normal](vtkIdType point) { return normal->GetTuple1(point); });
  if (vtkDataArray* memory = find(tips, "MemoryForce", 1))
  {
    addForces(output, rows, "Slow Force",
      [&](vtkIdType point) { return normal->GetTuple1(point) - memory->GetTuple1(point); });
    addForces(
      output, rows, "Memory Force", [memory](vtkIdType point) { return memory->GetTuple1(point); });
  }
  const auto addMagnitude = [&](const char* name, vtkDataArray* array)
  {
    if (array)
    {
      addForces(output, rows, name, [array](vtkIdType point) { return magnitude(array, point); });
    }
  };
  addMagnitude("Friction Force", find(tips, "FrictionForce", 3));
  vtkDataArray* total = find(tips, "Force", 3);
  addMagnitude("Force", total ? total : find(tips, "IdealForce", 1));
  addMagnitude("Sent Force", find(tips, "SentForce", 3));
  return 1;
}

void vtkContactHistory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Abscissa: " << this->Abscissa << "\n";
}
