// SPDX-License-Identifier: BSD-3-Clause
// vtkNoduleMaterial and vtkNoduleDetectability against an axisymmetric code whose meshes follow the
// ball (Data/Reference/shape/nodule_forces.csv): the change of the force for three tools.
#include "FilterChecks.h"
#include "NoduleBodies.h"
#include "ReferenceTable.h"

#include "vtkAppendFilter.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;

/// Coordinates from 0 outwards: steps of 1 mm up to `fine`, then growing steps up to `end`;
/// mirrored if `both`.
std::vector<double> graded(double fine, double end, bool both)
{
  std::vector<double> half = { 0.0 };
  double step = 1.0;
  while (half.back() < end - 1e-9)
  {
    step *= half.back() >= fine - 1e-9 ? 1.6 : 1.0;
    const double next = half.back() + step;
    half.push_back(next > end - 0.5 * step ? end : next);
  }
  std::vector<double> line;
  for (std::size_t i = half.size(); both && i-- > 1;)
  {
    line.push_back(-half[i]);
  }
  line.insert(line.end(), half.begin(), half.end());
  return line;
}

/// A body that is equivalent to the table's cylinder (radius 60 mm, height 40 mm): 106 x 106 x 40
/// mm, held at the bottom and at its sides, which change the force by less than 0.1 %. Its top is z
/// = 0. Cells are fine around a nodule of 3 mm in the middle.
Grid tableBody(double depth)
{
  const std::vector<double> x = graded(4.0, 53.0, true);
  std::vector<double> z = graded(depth + 6.0, 40.0, false);
  std::reverse(z.begin(), z.end());
  std::transform(z.begin(), z.end(), z.begin(), [](double below) { return -below; });
  vtkNew<vtkRectilinearGrid> box;
  box->SetDimensions(
    static_cast<int>(x.size()), static_cast<int>(x.size()), static_cast<int>(z.size()));
  const auto line = [](const std::vector<double>& values)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    for (const double value : values)
    {
      array->InsertNextValue(value);
    }
    return array;
  };
  box->SetXCoordinates(line(x));
  box->SetYCoordinates(line(x));
  box->SetZCoordinates(line(z));
  vtkNew<vtkAppendFilter> cells;
  cells->AddInputData(box);
  cells->Update();
  const Grid grid = cells->GetOutput();
  vtkNew<vtkUnsignedCharArray> fixed;
  fixed->SetName("Fixed");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> at{};
    grid->GetPoint(i, at.data());
    const bool isAtWall = std::abs(at[0]) == x.back() || std::abs(at[1]) == x.back();
    fixed->InsertNextValue(isAtWall || at[2] == z.front() ? 7 : 0);
  }
  grid->GetPointData()->AddArray(fixed);
  return grid;
}

double valueAt(
  vtkNoduleDetectability* filter, const char* name, const std::array<double, 3>& x, int tool = 0)
{
  vtkPolyData* surface = filter->GetOutput();
  const vtkIdType point = surface->vtkDataSet::FindPoint(x[0], x[1], x[2]);
  return surface->GetPointData()->GetArray(name)->GetComponent(point, tool);
}

const std::vector<std::string> Tools = { "flat:1.6", "sphere:1.6", "sphere:6.35" };

/// Largest change of a tool's force over the depths of the table, and the largest depth.
std::pair<double, double> tableChange(const std::string& tool, double depth, double ratio)
{
  const ReferenceTable table("shape/nodule_forces.csv");
  std::pair<double, double> largest;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    std::string name = table.text(i, "tool");
    name.insert(name.find_first_of("0123456789"), ":");
    if (table.number(i, "R_nodule") == 3.0 && table.number(i, "top_depth") == depth &&
      table.number(i, "E_ratio") == ratio && name == tool)
    {
      const double change = 0.01 * table.number(i, "dF_%");
      largest.first = std::abs(change) > std::abs(largest.first) ? change : largest.first;
      largest.second = std::max(largest.second, table.number(i, "delta"));
    }
  }
  return largest;
}

void checkTable(double depth, double ratio, double allowed)
{
  const Grid grid = withNodule(tableBody(depth), 0.0, 0.0, -depth - 3.0, 3.0, ratio);
  const Detectability filter = felt(grid, Tools[0], 1.2);
  filter->AddMoreTool(Tools[1]);
  filter->AddMoreTool(Tools[2]);
  filter->SetMaximumDeflection(0.8); // largest depth of the table for the small tools
  filter->SetSourceSpacing(1.0);
  filter->SetSourceSpacingWithout(8.0);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.errors().empty());
  int strongest = 0;
  double most = 0.0;
  for (int tool = 0; tool < 3; ++tool)
  {
    const auto [expected, deepest] =
      tableChange(Tools[static_cast<std::size_t>(tool)], depth, ratio);
    const double found = valueAt(filter, "ForceChange", { 0.0, 0.0, 0.0 }, tool);
    std::printf("%s, %g mm deep, %g times as hard: %+.1f %%, table %+.1f %%, at %.2f mm; %lld "
                "solutions\n",
      Tools[static_cast<std::size_t>(tool)].c_str(), depth, ratio, 100.0 * found, 100.0 * expected,
      valueAt(filter, "ChangeDepth", { 0.0, 0.0, 0.0 }, tool),
      static_cast<long long>(filter->GetNumberOfSolutions()));
    PALPATE_CHECK_NEAR(found, expected, allowed * (1.0 + expected));
    PALPATE_CHECK(
      valueAt(filter, "Felt", { 0.0, 0.0, 0.0 }, tool) == (std::abs(expected) >= 0.1 ? 1.0 : 0.0));
    strongest = std::abs(expected) > most ? tool : strongest;
    most = std::max(most, std::abs(expected));
  }
  PALPATE_CHECK(valueAt(filter, "StrongestTool", { 0.0, 0.0, 0.0 }) == strongest);
}
} // namespace

int TestNoduleTable(int, char*[])
{
  // Tolerances of the kernel's tests for mixed cells of 1 mm, relative to the force with the
  // nodule: 1.5 % at depths from 2 mm on, 4 % at 1 mm.
  checkTable(2.0, 10.0, 0.015);
  checkTable(2.0, 0.2, 0.015);
  checkTable(1.0, 10.0, 0.04);
  return result();
}
