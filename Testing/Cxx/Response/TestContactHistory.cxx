// SPDX-License-Identifier: BSD-3-Clause
// The table of a contact along a path, over time or deflection.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkContactHistory.h"
#include "vtkToolContactProbe.h"

#include "vtkDoubleArray.h"
#include "vtkPolyLine.h"
#include "vtkTable.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace
{
using namespace palpate::testing;

/// Tips in lines with these ids, with distinct numbers in their arrays.
Body tips(const std::vector<std::vector<vtkIdType>>& lines, vtkIdType count, bool timed)
{
  Body body = Body::New();
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(static_cast<double>(i), 0.0, 0.0);
  }
  body->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
  }
  body->SetLines(cells);
  const auto give = [&](const char* name, int components, double scale)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    for (vtkIdType i = 0; i < count; ++i)
    {
      for (int k = 0; k < components; ++k)
      {
        array->InsertNextValue(scale * static_cast<double>(i) *
          (k == 1      ? 4.0
              : k == 2 ? 0.0
                       : 3.0));
      }
    }
    body->GetPointData()->AddArray(array);
  };
  give("Deflection", 1, 0.1);
  give("NormalForce", 1, 1.0);
  if (timed)
  {
    give("Time", 1, 0.01);
    give("FrictionForce", 3, 1.0);
    give("IdealForce", 1, 2.0);
    give("SentForce", 3, 0.1);
  }
  return body;
}

std::vector<std::string> names(vtkTable* table)
{
  std::vector<std::string> found;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    found.emplace_back(table->GetColumnName(i));
  }
  return found;
}

double value(vtkTable* table, vtkIdType row, const char* name)
{
  return table->GetValueByName(row, name).ToDouble();
}

void checkOneLine()
{
  using Names = std::vector<std::string>;
  vtkNew<vtkContactHistory> history;
  Messages messages(history);
  history->SetInputData(tips({ { 4, 2, 0, 1 } }, 5, true)); // point 3 is in no line
  history->Update();
  vtkTable* table = history->GetOutput();
  PALPATE_CHECK((names(table) ==
    Names{ "Time (s)", "Deflection (mm)", "Normal Force (N)", "Friction Force (N)", "Force (N)",
      "Sent Force (N)" }));
  PALPATE_CHECK(table->GetNumberOfRows() == 4);
  vtkIdType row = 0;
  for (const double id : { 4.0, 2.0, 0.0, 1.0 })
  {
    // Tolerances: rounding of a product or of a root. The components 3, 4, 0 have the resultant 5.
    PALPATE_CHECK_NEAR(value(table, row, "Time (s)"), 0.03 * id, 1e-15);
    PALPATE_CHECK_NEAR(value(table, row, "Deflection (mm)"), 0.3 * id, 1e-15);
    PALPATE_CHECK_NEAR(value(table, row, "Normal Force (N)"), 3.0 * id, 0.0);
    PALPATE_CHECK_NEAR(value(table, row, "Friction Force (N)"), 5.0 * id, 0.0);
    PALPATE_CHECK_NEAR(value(table, row, "Force (N)"), 6.0 * id, 0.0);
    PALPATE_CHECK_NEAR(value(table, row, "Sent Force (N)"), 0.5 * id, 1e-15);
    ++row;
  }
  history->SetAbscissaToDeflection();
  history->Update();
  PALPATE_CHECK(std::string(table->GetColumnName(0)) == "Deflection (mm)");
  PALPATE_CHECK(std::string(table->GetColumnName(1)) == "Time (s)");

  history->SetAbscissaToAutomatic();
  history->SetInputData(tips({}, 3, false));
  history->Update();
  PALPATE_CHECK((names(table) == Names{ "Deflection (mm)", "Normal Force (N)" }));
  PALPATE_CHECK(table->GetNumberOfRows() == 3 && value(table, 2, "Normal Force (N)") == 6.0);
  PALPATE_CHECK(messages.none());

  history->SetAbscissaToTime();
  history->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'Time'", "missing");
  PALPATE_CHECK(history->GetOutput()->GetNumberOfColumns() == 0);
  Body bare = tips({}, 3, true);
  bare->GetPointData()->RemoveArray("NormalForce");
  history->SetInputData(bare);
  history->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'NormalForce'", "Tool Contact Probe");
  history->SetInputData(Body::New());
  history->Update();
  PALPATE_CHECK(messages.none() && history->GetOutput()->GetNumberOfColumns() == 0);
}

void checkSeveralLines()
{
  vtkNew<vtkContactHistory> history;
  Messages messages(history);
  history->SetInputData(tips({ { 0, 1 }, { 2, 3, 4 } }, 5, false));
  history->Update();
  vtkTable* table = history->GetOutput();
  PALPATE_CHECK((names(table) ==
    std::vector<std::string>{
      "Deflection (mm)", "Normal Force of line 0 (N)", "Normal Force of line 1 (N)" }));
  for (vtkIdType row = 0; row < 5; ++row)
  {
    const double first = value(table, row, "Normal Force of line 0 (N)");
    const double second = value(table, row, "Normal Force of line 1 (N)");
    PALPATE_CHECK(row < 2 ? first == 3.0 * static_cast<double>(row) : std::isnan(first));
    PALPATE_CHECK(row < 2 ? std::isnan(second) : second == 3.0 * static_cast<double>(row));
  }
  PALPATE_CHECK(messages.none());
}

/// The output of a probe, without times.
void checkProbe()
{
  vtkNew<vtkToolContactResponse> response;
  response->SetInputData(planeBody(10.0, 4));
  response->SetTool(makeTool("sphere:5"));
  Body way = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids(9);
  std::iota(ids.begin(), ids.end(), vtkIdType{ 0 });
  for (const vtkIdType i : ids)
  {
    points->InsertNextPoint(0.1 * static_cast<double>(i), 0.2, 0.5 - 0.25 * static_cast<double>(i));
  }
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(9, ids.data());
  way->SetPoints(points);
  way->SetLines(line);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputConnection(0, response->GetOutputPort());
  probe->SetInputData(1, way);
  probe->SetFrictionCoefficient(0.4);
  vtkNew<vtkContactHistory> history;
  Messages messages(history);
  history->SetInputConnection(probe->GetOutputPort());
  history->Update();
  vtkTable* table = history->GetOutput();
  PALPATE_CHECK(messages.none() && table->GetNumberOfRows() == 9);
  for (vtkIdType i = 0; i < 9; ++i)
  {
    PALPATE_CHECK_NEAR(value(table, i, "Deflection (mm)"),
      std::max(0.0, 0.25 * static_cast<double>(i) - 0.5), 1e-15);
    // The force is the resultant of normal force and friction, which are perpendicular.
    PALPATE_CHECK_NEAR(value(table, i, "Force (N)"),
      std::hypot(value(table, i, "Normal Force (N)"), value(table, i, "Friction Force (N)")),
      1e-14);
  }
  PALPATE_CHECK(value(table, 8, "Friction Force (N)") > 0.0);
}

/// A body that relaxes: the normal force is 3 i, and the memory part is i.
void checkMemory()
{
  vtkNew<vtkContactHistory> history;
  Messages messages(history);
  const Body felt = tips({ { 0, 1, 2 } }, 3, false);
  vtkNew<vtkDoubleArray> memory;
  memory->SetName("MemoryForce");
  for (const double value : { 0.0, 1.0, 2.0 })
  {
    memory->InsertNextValue(value);
  }
  felt->GetPointData()->AddArray(memory);
  history->SetInputData(felt);
  history->Update();
  vtkTable* table = history->GetOutput();
  PALPATE_CHECK((names(table) ==
    std::vector<std::string>{
      "Deflection (mm)", "Normal Force (N)", "Slow Force (N)", "Memory Force (N)" }));
  for (vtkIdType i = 0; i < 3; ++i)
  {
    PALPATE_CHECK(value(table, i, "Slow Force (N)") == 2.0 * static_cast<double>(i));
    PALPATE_CHECK(value(table, i, "Memory Force (N)") == static_cast<double>(i));
  }
}
} // namespace

int TestContactHistory(int, char*[])
{
  checkOneLine();
  checkSeveralLines();
  checkProbe();
  checkMemory();
  return result();
}
