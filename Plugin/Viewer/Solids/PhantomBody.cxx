// SPDX-License-Identifier: BSD-3-Clause
#include "PhantomBody.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkNoduleMaterial.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRegularPolygonSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
// Sizes in mm. The accuracy depends on the cells near the axis of a nodule that contain both
// materials. With a size of 0.75 for these cells, the accuracy is the same as with this size
// everywhere.
//
// Size of cells at a distance of up to FinestHalfWidth from the axis of a nodule.
constexpr double FinestSize = 0.75;
constexpr double FinestHalfWidth = 3.75; // half width of the finest region, five cells
constexpr double FineSize = 1.0;         // size of cells at nodules
constexpr double CoarserSize = 2.0;      // size of cells between nodules
// Distance from the outermost nodules to the walls; more than ten contact radii.
constexpr double Margin = 30.0;
constexpr double Grading = 2.0; // ratio of the sizes of neighbouring cells in the margin
// Depth of the fine cells; the size of deeper cells has little effect.
constexpr double FineDepth = 9.0;
constexpr double BlockHeight = 40.0;
constexpr double FineMargin = 0.75; // width of fine cells outside a nodule

/// Adds coordinates up to `end` whose distances increase.
void growTo(std::vector<double>& line, double end)
{
  double step = FineSize;
  while (line.back() < end - 1e-9)
  {
    step *= Grading;
    const double next = line.back() + step;
    line.push_back(next > end - 0.5 * Grading * step ? end : next);
  }
}

/// Adds equidistant coordinates up to `end` whose distances are at most `most`.
void fillTo(std::vector<double>& line, double end, double most)
{
  const double begin = line.back();
  if (end <= begin)
  {
    return;
  }
  const int cells = std::max(1, static_cast<int>(std::ceil((end - begin) / most - 1e-9)));
  for (int i = 1; i <= cells; ++i)
  {
    line.push_back(begin + (end - begin) * i / cells);
  }
}

/// A row of nodules with the same coordinate on one axis: the coordinate of their centres, and the
/// half width of the fine cells around it.
struct Row
{
  double middle = 0.0;
  double half = 0.0;
};

std::vector<Row> rowsOf(double PhantomNodule::*place)
{
  std::vector<Row> rows;
  for (const PhantomNodule& nodule : PhantomNodules)
  {
    const double middle = nodule.*place;
    const double half = nodule.radius + FineMargin;
    const auto same = std::find_if(
      rows.begin(), rows.end(), [middle](const Row& row) { return row.middle == middle; });
    if (same == rows.end())
    {
      rows.push_back({ middle, half });
    }
    else
    {
      same->half = std::max(same->half, half);
    }
  }
  std::sort(
    rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.middle < b.middle; });
  return rows;
}

/// Returns the coordinates of the grid planes on one axis. They are finest at the centre of each
/// row and coarse outside of all rows.
std::vector<double> planes(const std::vector<Row>& rows)
{
  std::vector<double> outward = { rows.front().half - rows.front().middle };
  growTo(outward, outward.back() + Margin);
  std::vector<double> line;
  for (std::size_t i = outward.size(); i-- > 0;)
  {
    line.push_back(-outward[i]);
  }
  for (const Row& row : rows)
  {
    const double core = std::min(row.half, FinestHalfWidth);
    if (row.middle - row.half > line.back())
    {
      fillTo(line, row.middle - row.half, CoarserSize);
    }
    fillTo(line, row.middle - core, FineSize);
    fillTo(line, row.middle, FinestSize);
    fillTo(line, row.middle + core, FinestSize);
    fillTo(line, row.middle + row.half, FineSize);
  }
  growTo(line, line.back() + Margin);
  return line;
}

std::vector<double> heights()
{
  std::vector<double> depths = { 0.0 };
  fillTo(depths, FineDepth, FineSize);
  growTo(depths, BlockHeight);
  std::vector<double> line;
  for (std::size_t i = depths.size(); i-- > 0;)
  {
    line.push_back(-depths[i]);
  }
  return line;
}

vtkSmartPointer<vtkDoubleArray> arrayOf(const std::vector<double>& line)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (const double value : line)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// Makes an array on the points of the grid: `value` where `isMarked(x)` is true, otherwise 0.
template <class Condition>
vtkSmartPointer<vtkUnsignedCharArray> marked(
  vtkUnstructuredGrid* grid, const char* name, unsigned char value, const Condition& isMarked)
{
  auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  marks->SetName(name);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x{};
    grid->GetPoint(i, x.data());
    marks->InsertNextValue(isMarked(x) ? value : 0);
  }
  return marks;
}

/// Adds arrays that mark the points bonded to the box, and the points of the searched field on the
/// surface.
void markPoints(vtkUnstructuredGrid* grid)
{
  std::array<double, 6> box{};
  grid->GetBounds(box.data());
  grid->GetPointData()->AddArray(marked(grid, "Fixed", 7,
    [&box](const std::array<double, 3>& x)
    {
      return x[0] <= box[0] || x[0] >= box[1] || x[1] <= box[2] || x[1] >= box[3] || x[2] <= box[4];
    }));
  const std::array<double, 4>& field = PhantomField;
  grid->GetPointData()->AddArray(marked(grid, "Pressed", 1,
    [&field](const std::array<double, 3>& x)
    {
      return x[2] == 0.0 && x[0] >= field[0] && x[0] <= field[1] && x[1] >= field[2] &&
        x[1] <= field[3];
    }));
}
} // namespace

vtkSmartPointer<vtkUnstructuredGrid> makePhantomGrid(double youngsModulus, double poissonRatio)
{
  const std::vector<double> x = planes(rowsOf(&PhantomNodule::x));
  const std::vector<double> y = planes(rowsOf(&PhantomNodule::y));
  const std::vector<double> z = heights();
  vtkNew<vtkRectilinearGrid> block;
  block->SetDimensions(
    static_cast<int>(x.size()), static_cast<int>(y.size()), static_cast<int>(z.size()));
  block->SetXCoordinates(arrayOf(x));
  block->SetYCoordinates(arrayOf(y));
  block->SetZCoordinates(arrayOf(z));
  vtkNew<vtkAppendFilter> cells;
  cells->AddInputData(block);
  cells->Update();
  markPoints(cells->GetOutput());
  vtkNew<vtkNoduleMaterial> material;
  material->SetInputData(cells->GetOutput());
  material->SetYoungsModulus(youngsModulus);
  material->SetPoissonRatio(poissonRatio);
  for (const PhantomNodule& nodule : PhantomNodules)
  {
    material->AddNodule(nodule.x, nodule.y, -nodule.top - nodule.radius, nodule.radius,
      NoduleHardness * youngsModulus);
  }
  material->Update();
  return material->GetOutput();
}

vtkSmartPointer<vtkPolyData> outlineNodules()
{
  constexpr int corners = 64;
  vtkNew<vtkAppendPolyData> all;
  for (const PhantomNodule& nodule : PhantomNodules)
  {
    vtkNew<vtkRegularPolygonSource> circle;
    circle->GeneratePolygonOff();
    circle->SetNumberOfSides(corners);
    circle->SetRadius(nodule.radius);
    circle->SetCenter(nodule.x, nodule.y, 0.0);
    circle->Update();
    all->AddInputData(circle->GetOutput());
  }
  all->Update();
  return all->GetOutput();
}
} // namespace palpate
