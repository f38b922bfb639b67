// SPDX-License-Identifier: BSD-3-Clause
// vtkNoduleMaterial: volumes of spheres, mixed cells, overlap, input arrays, faults.
#include "FilterChecks.h"
#include "VolumeBlock.h"

#include "vtkDataObject.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkNoduleMaterial.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace
{
using namespace palpate::testing;
using Material = vtkSmartPointer<vtkNoduleMaterial>;

constexpr int Side = 12;
constexpr int Height = 12;

Material inserted(vtkUnstructuredGrid* grid)
{
  auto filter = Material::New();
  filter->SetInputData(grid);
  filter->SetYoungsModulus(1.0);
  return filter;
}

double valueOf(vtkNoduleMaterial* filter, const char* name, vtkIdType cell)
{
  return filter->GetOutput()->GetCellData()->GetArray(name)->GetTuple1(cell);
}

vtkIdType cellAt(int i, int j, int k)
{
  return (static_cast<vtkIdType>(k) * Side + j) * Side + i;
}

/// The same block with moved points, so that its cells are neither boxes nor equal.
Grid skewed()
{
  const Grid grid = block(Side, Height, VTK_HEXAHEDRON);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x{};
    grid->GetPoint(i, x.data());
    grid->GetPoints()->SetPoint(
      i, x[0] + 0.1 * x[2], x[1] + 0.02 * x[0] * x[1], x[2] * (1.0 + 0.02 * x[0]));
  }
  return grid;
}

/// The volume of a cell; that of a hexahedron is the sum of its tetrahedra.
double volumeOf(vtkCell* cell)
{
  std::array<std::array<double, 3>, 8> x{};
  const auto count = static_cast<std::size_t>(cell->GetNumberOfPoints());
  for (std::size_t i = 0; i < count; ++i)
  {
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), x[i].data());
  }
  const auto six = [&x](std::size_t a, std::size_t b, std::size_t c, std::size_t d)
  {
    std::array<std::array<double, 3>, 3> e{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      e[0][k] = x[b][k] - x[a][k];
      e[1][k] = x[c][k] - x[a][k];
      e[2][k] = x[d][k] - x[a][k];
    }
    return std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
      e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
      e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
  };
  return count == 4 ? six(0, 1, 2, 3) / 6.0
                    : (six(0, 1, 2, 6) + six(0, 2, 3, 6) + six(0, 3, 7, 6) + six(0, 7, 4, 6) +
                        six(0, 4, 5, 6) + six(0, 5, 1, 6)) /
      6.0;
}

/// The fractions of all cells add up to the volume of the ball.
void checkVolume()
{
  vtkNew<vtkDataSetTriangleFilter> tetrahedra;
  const Grid cubes = block(Side, Height);
  tetrahedra->SetInputData(cubes);
  tetrahedra->Update();
  for (const Grid& grid : std::initializer_list<Grid>{
         cubes, block(Side, Height, VTK_HEXAHEDRON), skewed(), tetrahedra->GetOutput() })
  {
    const Material filter = inserted(grid);
    filter->AddNodule(6.7, 5.8, 6.2, 3.1, 10.0);
    Messages messages(filter.Get());
    filter->Update();
    PALPATE_CHECK(messages.none());
    double sum = 0.0;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      sum += valueOf(filter, "NoduleFraction", i) * volumeOf(grid->GetCell(i));
    }
    const double ball = 4.0 / 3.0 * std::acos(-1.0) * std::pow(3.1, 3);
    // Each of some hundred cut cells has an error of a few per cent, of either sign. The tetrahedra
    // of a skewed hexahedron do not follow its curved sides.
    PALPATE_CHECK_NEAR(sum, ball, 0.005 * ball);
  }
}

/// A sphere whose surface is nearly a plane, so that the filled fractions are known.
void checkMixing()
{
  const Grid grid = block(Side, Height);
  for (const double inclusion : { 10.0, 0.2 })
  {
    const Material filter = inserted(grid);
    filter->SetSubdivisions(16);
    filter->AddNodule(6.5, 6.5, -1000.0 + 6.25, 1000.0, inclusion, 0.3);
    filter->Update();
    const vtkIdType cut = cellAt(6, 6, 6);
    PALPATE_CHECK_NEAR(valueOf(filter, "NoduleFraction", cut), 0.25, 1e-12); // 4 of 16 layers
    const double expected =
      inclusion > 1.0 ? 1.0 / (0.75 + 0.25 / inclusion) : std::pow(inclusion, 0.25);
    PALPATE_CHECK_NEAR(valueOf(filter, "YoungsModulus", cut), expected, 1e-12);
    PALPATE_CHECK_NEAR(valueOf(filter, "PoissonRatio", cut), 0.45 - 0.25 * 0.15, 1e-12);
    PALPATE_CHECK(valueOf(filter, "YoungsModulusWithout", cut) == 1.0);
    PALPATE_CHECK(valueOf(filter, "PoissonRatioWithout", cut) == 0.45);
    PALPATE_CHECK(valueOf(filter, "YoungsModulus", cellAt(6, 6, 5)) == inclusion);
    PALPATE_CHECK(valueOf(filter, "YoungsModulus", cellAt(6, 6, 7)) == 1.0);
  }
}

/// Two nodules that are nearly half-spaces in one cell, and two nodules that overlap.
void checkSeveral()
{
  const Grid grid = block(Side, Height);
  const Material filter = inserted(grid);
  filter->SetSubdivisions(16);
  filter->AddNodule(6.5, 6.5, -1000.0 + 6.25, 1000.0, 10.0); // below 6.25
  filter->AddNodule(6.5, 6.5, 1000.0 + 6.5, 1000.0, 5.0);    // above 6.5
  filter->Update();
  const vtkIdType cell = cellAt(6, 6, 6);
  PALPATE_CHECK_NEAR(valueOf(filter, "NoduleFraction", cell), 0.75, 1e-12);
  // All nodules are harder than the surrounding material, so the modulus is one harmonic mean of
  // the three, in any order.
  PALPATE_CHECK_NEAR(
    valueOf(filter, "YoungsModulus", cell), 1.0 / (0.25 + 0.25 / 10.0 + 0.5 / 5.0), 1e-2);
  PALPATE_CHECK(filter->GetNumberOfNodules() == 2);
  filter->ClearNodules();
  filter->AddNodule(6.5, 6.5, 6.5, 3.0, 10.0);
  filter->AddNodule(6.5, 6.5, 6.5, 2.0, 0.5); // a soft core: the nodule that was added last counts
  filter->Update();
  PALPATE_CHECK(valueOf(filter, "YoungsModulus", cell) == 0.5);
  PALPATE_CHECK(valueOf(filter, "YoungsModulus", cellAt(4, 6, 6)) > 0.5);
}

void checkArrays()
{
  const Grid grid = block(Side, Height);
  addCells(grid, "E", 2.0);
  addCells(grid, "Nu", 0.3);
  const Material filter = inserted(grid);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "E");
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Nu");
  filter->AddNodule(6.5, 6.5, 6.5, 3.0, 20.0); // has the ν of the surrounding material
  filter->Update();
  for (const vtkIdType cell : { cellAt(0, 0, 0), cellAt(6, 6, 6) })
  {
    PALPATE_CHECK(valueOf(filter, "YoungsModulusWithout", cell) == 2.0);
    PALPATE_CHECK_NEAR(valueOf(filter, "PoissonRatio", cell), 0.3, 1e-15);
  }
  PALPATE_CHECK(valueOf(filter, "YoungsModulus", cellAt(6, 6, 6)) == 20.0);
  PALPATE_CHECK(!grid->GetCellData()->HasArray("YoungsModulus")); // the input is not changed
  PALPATE_CHECK(filter->GetOutput()->GetPointData()->HasArray("Fixed"));

  const Material none = inserted(grid); // without nodules only the arrays are added
  none->Update();
  PALPATE_CHECK(valueOf(none, "YoungsModulus", 0) == 1.0);
  const Material empty = inserted(Grid::New());
  Messages messages(empty.Get());
  empty->AddNodule(0.0, 0.0, 0.0, 1.0, 1.0);
  empty->Update();
  PALPATE_CHECK(messages.none() && empty->GetOutput()->GetNumberOfCells() == 0);
}

void checkErrors()
{
  const Grid grid = block(Side, Height);
  const auto fails = [&grid](auto&& change, std::initializer_list<const char*> words)
  {
    const Material filter = inserted(grid);
    Messages messages(filter.Get());
    filter->AddNodule(6.0, 6.0, 6.0, 2.0, 10.0);
    change(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  };
  const double nan = std::nan("");
  fails([](auto* f) { f->AddNodule(6, 6, 6, 0.0, 1.0); }, { "Nodule 1", "radius", "0" });
  fails([&](auto* f) { f->AddNodule(6, 6, 6, nan, 1.0); }, { "Nodule 1", "radius", "nan" });
  fails([&](auto* f) { f->AddNodule(6, nan, 6, 1.0, 1.0); }, { "Nodule 1", "middle", "nan" });
  fails([](auto* f) { f->AddNodule(6, 6, 6, 1.0, -2.0); }, { "Nodule 1", "modulus", "-2" });
  fails([](auto* f) { f->AddNodule(6, 6, 6, 1.0, 1.0, 0.5); }, { "Nodule 1", "Poisson", "0.5" });
  fails([](auto* f) { f->AddNodule(60, 6, 6, 3.0, 1.0); }, { "Nodule 1", "60", "outside" });
  fails([](auto* f) { f->SetYoungsModulus(0.0); }, { "Young's Modulus", "0" });
  fails([](auto* f) { f->SetPoissonRatio(0.5); }, { "Poisson's Ratio", "0.5" });
  fails([](auto* f) { f->SetSubdivisions(0); }, { "Subdivisions", "0" });
  fails([](auto* f)
    { f->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Stiff"); },
    { "Stiff", "cells" });
  addCells(grid, "Bad", -1.0);
  fails([](auto* f)
    { f->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Bad"); },
    { "cell 0", "-1" });
  const Grid wedges = block(2, 1);
  const std::array<vtkIdType, 3> corners = { 0, 1, 2 };
  wedges->InsertNextCell(VTK_TRIANGLE, 3, corners.data());
  const Material wrong = inserted(wedges);
  Messages messages(wrong.Get());
  wrong->Update();
  PALPATE_CHECK_TEXT(messages.errors(), "cell");
}
} // namespace

int TestNoduleMaterial(int, char*[])
{
  checkVolume();
  checkMixing();
  checkSeveral();
  checkArrays();
  checkErrors();
  return result();
}
