// SPDX-License-Identifier: BSD-3-Clause
// The second mesh of vtkElasticContactResponse: its effect against the exact layer, a change of the
// tool, threads, abort, errors. MeshDifferenceTest in Mechanics checks how often its error estimate
// holds.
#include "AbortedFilter.h"
#include "FilterChecks.h"
#include "TestBodies.h"
#include "VolumeBlock.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkElasticContactResponse.h"

#include <array>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{
using namespace palpate::testing;
using ElasticFilter = vtkSmartPointer<vtkElasticContactResponse>;

constexpr int Side = 24;
constexpr int Height = 4; // mm: a layer of four cells, and of two in the second mesh

/// A block of side × side × height mm with cells of `length` mm.
Grid cellsOf(double length, int side = Side, int height = Height)
{
  const Grid grid =
    block(static_cast<int>(side / length), static_cast<int>(height / length), VTK_HEXAHEDRON);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x{};
    grid->GetPoint(i, x.data());
    grid->GetPoints()->SetPoint(i, length * x[0], length * x[1], length * x[2]);
  }
  return grid;
}

ElasticFilter press(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser = nullptr)
{
  auto filter = ElasticFilter::New();
  filter->SetInputData(grid);
  filter->SetTool(makeTool("sphere:3"));
  filter->SetMaximumDeflection(0.6);
  filter->StoreMotionOff();
  if (coarser)
  {
    filter->SetCoarserData(coarser);
  }
  return filter;
}

vtkDataArray* array(vtkElasticContactResponse* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

bool isSame(vtkDataArray* a, vtkDataArray* b)
{
  bool same =
    a && b && a->GetNumberOfValues() > 0 && a->GetNumberOfValues() == b->GetNumberOfValues();
  for (vtkIdType i = 0; same && i < a->GetNumberOfValues(); ++i)
  {
    const double x = a->GetVariantValue(i).ToDouble();
    const double y = b->GetVariantValue(i).ToDouble();
    same = x == y || (std::isnan(x) && std::isnan(y));
  }
  return same;
}

/// In the middle of a bonded layer the exact law gives the true error. It is within the stated
/// error, which is at most √2 times that without the second mesh. The forces do not change. If the
/// second mesh is removed, the stated error is again that without it.
void checkLayer()
{
  const Grid grid = cellsOf(1.0);
  const ElasticFilter without = press(grid);
  without->Update();
  const ElasticFilter with = press(grid, cellsOf(2.0));
  Messages messages(with.Get());
  with->Update();
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK(isSame(array(with, "ResponseForce"), array(without, "ResponseForce")));
  PALPATE_CHECK(isSame(array(with, "ResponseStatus"), array(without, "ResponseStatus")));
  PALPATE_CHECK(with->GetNumberOfSolutions() > without->GetNumberOfSolutions());
  PALPATE_CHECK(with->GetMemoryEstimate() > without->GetMemoryEstimate());
  vtkNew<vtkToolContactResponse> exact;
  exact->SetInputData(planeBody(30.0, 8));
  exact->SetTool(makeTool("sphere:3"));
  exact->SetYoungsModulus(0.1);
  exact->SetPoissonRatio(0.45);
  exact->SetLayerThickness(Height);
  exact->SetMaximumDeflection(0.6);
  exact->Update();
  const vtkIdType point = with->GetOutput()->vtkDataSet::FindPoint(0.5 * Side, 0.5 * Side, Height);
  vtkDataArray* forces = exact->GetOutput()->GetPointData()->GetArray("ResponseForce");
  for (int k = 1; k < 8; ++k)
  {
    const double error = std::abs(
      array(with, "ResponseForce")->GetComponent(point, k) / forces->GetComponent(40, k) - 1.0);
    const double stated = array(with, "ResponseError")->GetComponent(point, k);
    const double expected = array(without, "ResponseError")->GetComponent(point, k);
    std::cout << "off by " << error << ", stated " << stated << ", without " << expected << "\n";
    PALPATE_CHECK(error < stated && stated != expected && stated < std::sqrt(2.0) * expected);
  }
  with->SetInputConnection(2, nullptr);
  with->Update();
  PALPATE_CHECK(with->GetNumberOfSolutions() == 0);
  PALPATE_CHECK(isSame(array(with, "ResponseError"), array(without, "ResponseError")));
  PALPATE_CHECK(isSame(array(with, "ResponseValidity"), array(without, "ResponseValidity")));
}

/// A change of the tool needs no new solution and gives the same result as a new filter, also on a
/// finer surface.
void checkNextTool()
{
  const Grid grid = cellsOf(1.0, 10, 4);
  const Grid coarser = cellsOf(2.0, 10, 4);
  const ElasticFilter filter = press(grid, coarser);
  const double radius = 1.42 * makeTool("sphere:3")->GetContactRadius(0.6);
  filter->Update();
  for (const bool isFiner : { false, true })
  {
    const Body plane = planeBody(2.0, 8, 4.0);
    for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> x{};
      plane->GetPoint(i, x.data());
      plane->GetPoints()->SetPoint(i, x[0] + 5.0, x[1] + 5.0, x[2]);
    }
    const ElasticFilter alone = press(grid, coarser);
    for (const ElasticFilter& each : { filter, alone })
    {
      each->SetTool(makeTool("cone:70"));
      each->SetLargestContactRadius(radius);
      each->SetSurfaceData(isFiner ? plane.Get() : nullptr);
      each->Update();
    }
    PALPATE_CHECK(filter->GetNumberOfSolutions() == 0);
    PALPATE_CHECK(isSame(array(filter, "ResponseForce"), array(alone, "ResponseForce")));
    PALPATE_CHECK(isSame(array(filter, "ResponseError"), array(alone, "ResponseError")));
  }
  filter->SetPoissonRatio(0.3);
  filter->Update();
  PALPATE_CHECK(filter->GetNumberOfSolutions() > 0);
}

void checkThreads()
{
  std::vector<vtkSmartPointer<vtkDataArray>> runs;
  for (const int threads : { 1, 3 })
  {
    withThreads(threads,
      [&]
      {
        const ElasticFilter filter = press(cellsOf(1.0, 8, 4), cellsOf(2.0, 8, 4));
        filter->Update();
        runs.emplace_back(array(filter, "ResponseError"));
      });
  }
  PALPATE_CHECK(isSame(runs[0], runs[1]));
}

void checkErrors()
{
  const Grid grid = cellsOf(1.0, 8, 4);
  const auto fails =
    [&grid](vtkUnstructuredGrid* coarser, auto&& change, std::initializer_list<const char*> words)
  {
    const ElasticFilter filter = press(grid, coarser);
    Messages messages(filter.Get());
    change(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  const auto nothing = [](vtkElasticContactResponse*) {};
  fails(Grid::New(), nothing, { "Coarser", "no cells" });
  fails(grid, nothing, { "Coarser", "1.2", "1 times as long" });
  fails(cellsOf(0.5, 8, 4), nothing, { "Coarser", "0.5 times as long" });
  fails(cellsOf(2.0, 16, 4), nothing, { "Coarser", "not the same body", "16 mm instead of 8" });
  const Grid free = cellsOf(2.0, 8, 4);
  free->GetPointData()->RemoveArray("Fixed");
  fails(free, nothing, { "Coarser", "no point array 'Fixed'" });
  addCells(grid, "E", 0.1);
  fails(cellsOf(2.0, 8, 4),
    [](auto* f)
    { f->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "E"); },
    { "Coarser", "'E'", "cells" });
}

void checkAbort()
{
  for (const double at : { 0.3, 0.76, 0.8, 0.88 })
  {
    checkAborted(press(cellsOf(1.0, 8, 4), cellsOf(2.0, 8, 4)).Get(), at);
  }
}
} // namespace

int TestCoarserBody(int, char*[])
{
  checkLayer();
  checkNextTool();
  checkThreads();
  checkErrors();
  checkAbort();
  return result();
}
