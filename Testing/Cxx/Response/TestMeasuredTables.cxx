// SPDX-License-Identifier: BSD-3-Clause
// Measured curves from tables: the results are bit for bit those from files. Also the chart of the
// curves.
#include "FilterChecks.h"
#include "MeasuredFiles.h"

#include "vtkMeasuredCurves.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"

#include <cmath>
#include <sstream>

namespace
{
using namespace palpate::testing;

constexpr double Modulus = 0.05; // E*, MPa
constexpr double R = 6.35;
const char* const Tip = "paraboloid:6.35";
using Table = vtkSmartPointer<vtkTable>;

std::string makeFile(const std::string& path)
{
  return writeCurves(path, Tip,
    { { "A", { -3.0, 1.0, 0.0 }, hertz(R, Modulus) },
      { "B", { 4.0, 0.5, 0.0 }, hertz(R, 1.7 * Modulus) } },
    1.5, 0.3, 1e-4);
}

/// Reads the rows of a file of curves as a .csv reader does, with numeric columns.
Table readTable(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  Table table = Table::New();
  while (std::getline(file, line))
  {
    if (line.front() == '#')
    {
      continue;
    }
    std::istringstream fields(line);
    std::string field;
    const bool head = table->GetNumberOfColumns() == 0;
    for (vtkIdType column = 0; std::getline(fields, field, ','); ++column)
    {
      if (head)
      {
        vtkSmartPointer<vtkAbstractArray> made = vtkSmartPointer<vtkAbstractArray>::Take(
          vtkAbstractArray::CreateArray(column == 0 ? VTK_STRING : VTK_DOUBLE));
        made->SetName(field.c_str());
        table->AddColumn(made);
      }
      else if (column == 0)
      {
        vtkStringArray::SafeDownCast(table->GetColumn(0))->InsertNextValue(field);
      }
      else
      {
        vtkDoubleArray::SafeDownCast(table->GetColumn(column))
          ->InsertNextValue(std::strtod(field.c_str(), nullptr));
      }
    }
  }
  return table;
}

MeasuredFilter measureTable(vtkPolyData* body, vtkTable* table, const std::string& tool = Tip)
{
  auto filter = MeasuredFilter::New();
  filter->SetInputData(0, body);
  filter->AddInputData(1, table);
  filter->SetMeasuringTool(tool);
  filter->SetTool(makeTool("sphere:1.6"));
  return filter;
}

bool same(vtkDataArray* a, vtkDataArray* b)
{
  bool equal = a && b && a->GetNumberOfValues() == b->GetNumberOfValues();
  for (vtkIdType i = 0; equal && i < a->GetNumberOfValues(); ++i)
  {
    const double x = a->GetVariantValue(i).ToDouble();
    const double y = b->GetVariantValue(i).ToDouble();
    equal = x == y || (std::isnan(x) && std::isnan(y));
  }
  return equal;
}

void checkSameAsFile(const std::string& folder)
{
  const std::string file = makeFile(folder + "/table.csv");
  const Body body = planeBody(12.0, 10);
  const MeasuredFilter fromFile = measure(body, file, "sphere:1.6");
  fromFile->Update();
  const Table table = readTable(file);
  const MeasuredFilter fromTable = measureTable(body, table);
  Messages messages(fromTable.Get());
  fromTable->Update();
  PALPATE_CHECK(messages.none());
  vtkPointData* one = fromTable->GetOutput()->GetPointData();
  vtkPointData* other = fromFile->GetOutput()->GetPointData();
  PALPATE_CHECK(one->GetNumberOfArrays() == other->GetNumberOfArrays());
  for (int i = 0; i < other->GetNumberOfArrays(); ++i)
  {
    PALPATE_CHECK(same(one->GetArray(other->GetArrayName(i)), other->GetArray(i)));
  }
  for (const int port : { 1, 2 })
  {
    auto* rows = vtkTable::SafeDownCast(fromTable->GetOutputDataObject(port));
    auto* expected = vtkTable::SafeDownCast(fromFile->GetOutputDataObject(port));
    PALPATE_CHECK(rows->GetNumberOfRows() == expected->GetNumberOfRows());
    for (vtkIdType i = 0; i < expected->GetNumberOfColumns(); ++i)
    {
      auto* numbers = vtkDataArray::SafeDownCast(expected->GetColumn(i));
      PALPATE_CHECK(!numbers ||
        same(
          vtkDataArray::SafeDownCast(rows->GetColumnByName(expected->GetColumnName(i))), numbers));
    }
  }
  // Without noise the tests of the kernel are accurate to 1e-9 and better. Here the curves are
  // stored as floats.
  PALPATE_CHECK_NEAR(siteNumber(fromTable, 1, "ReducedModulus (MPa)"), 1.7 * Modulus, 1e-3);

  // The same tool twice at a site is an error, as for files.
  const MeasuredFilter both = measureTable(body, table);
  both->AddFileName(file);
  Messages complaints(both.Get());
  both->Update();
  const MeasuredFilter twice = measure(body, file, "sphere:1.6");
  twice->AddFileName(file);
  Messages expected(twice.Get());
  twice->Update();
  PALPATE_CHECK(complaints.none() == expected.none());
}

void checkErrors(const std::string& folder)
{
  const Table table = readTable(makeFile(folder + "/table.csv"));
  const Body body = planeBody(12.0, 10);
  const auto refuse =
    [&](vtkTable* wrong, const std::string& tool, std::initializer_list<const char*> words)
  {
    const MeasuredFilter filter = measureTable(body, wrong, tool);
    Messages messages(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  refuse(table, "", { "Measuring Tool", "required" });
  refuse(table, "spoon:3", { "Table 0", "tool", "spoon" });
  Table wrong = Table::New();
  wrong->DeepCopy(table);
  wrong->RemoveColumnByName("force_N");
  refuse(wrong, Tip, { "Table 0", "'force_N' is missing" });
  wrong->DeepCopy(table);
  wrong->SetValueByName(7, "force_N", std::nan(""));
  refuse(wrong, Tip, { "Table 0", "row 7", "force_N", "not a finite number" });
  wrong->DeepCopy(table);
  wrong->SetValueByName(3, "x_mm", 8.0);
  refuse(wrong, Tip, { "row 3", "'A'", "another position" });
  vtkNew<vtkIntArray> more;
  more->SetName("colour");
  more->SetNumberOfValues(table->GetNumberOfRows());
  more->Fill(0);
  wrong->DeepCopy(table);
  wrong->AddColumn(more); // a column that is not used
  const MeasuredFilter filter = measureTable(body, wrong);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  refuse(Table::New(), Tip, { "Table 0", "'x_mm' is missing" });
  Table comment = Table::New();
  more->SetName("# tool: sphere:3");
  comment->AddColumn(more);
  refuse(comment, Tip, { "Table 0", "'# tool: sphere:3'", "without the comments" });
}

/// The chart has the readings of two sites next to each other, sorted, with the curves of the
/// model.
void checkChart(const std::string& folder)
{
  const MeasuredFilter filter =
    measure(planeBody(12.0, 10), makeFile(folder + "/table.csv"), "sphere:1.6");
  vtkNew<vtkMeasuredCurves> curves;
  Messages messages(curves);
  curves->SetInputConnection(filter->GetOutputPort(2));
  curves->Update();
  PALPATE_CHECK(messages.none());
  vtkTable* chart = curves->GetOutput();
  PALPATE_CHECK(chart->GetNumberOfRows() == 2 * 71 && chart->GetNumberOfColumns() == 5);
  for (vtkIdType row = 0; row < chart->GetNumberOfRows(); ++row)
  {
    const bool first = row < 71;
    const auto number = [&](const std::string& name)
    { return chart->GetValueByName(row, name.c_str()).ToDouble(); };
    const std::string here = first ? "A" : "B";
    const std::string there = first ? "B" : "A";
    const double depth = number("Deflection (mm)");
    PALPATE_CHECK(row % 71 == 0 || depth >= chart->GetValue(row - 1, 0).ToDouble());
    PALPATE_CHECK(
      std::isnan(number(there + " measured (N)")) && std::isnan(number(there + " model (N)")));
    const double law = depth > 0.0 ? hertz(R, first ? Modulus : 1.7 * Modulus)(depth) : 0.0;
    // The noise is 1e-4 N. None of 142 readings deviates by 8 standard deviations. The model with
    // the identified offset deviates less.
    PALPATE_CHECK_NEAR(number(here + " measured (N)"), law, 8e-4);
    PALPATE_CHECK_NEAR(number(here + " model (N)"), law, 3e-4);
  }
  vtkNew<vtkTable> wrong;
  vtkNew<vtkDoubleArray> column;
  column->SetName("Deflection (mm)");
  column->InsertNextValue(1.0);
  wrong->AddColumn(column);
  curves->SetInputData(wrong);
  curves->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'Force (N)' is missing", "Readings");
}
} // namespace

int TestMeasuredTables(int, char* arguments[])
{
  checkSameAsFile(arguments[1]);
  checkErrors(arguments[1]);
  checkChart(arguments[1]);
  return result();
}
